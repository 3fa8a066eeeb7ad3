#include "check/motions/unsupported_motions.hpp"

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/random_values.hpp"

namespace gxrod {
namespace {

using Held = std::array<bool, 6>;
constexpr Held all{true, true, true, true, true, true};
constexpr Held position{true, true, true, false, false, false};

// A rod with a node at each of the places.
Model make_rod(const std::vector<Vec3>& places) {
    Model model;
    Rod rod;
    rod.name = "cable";
    std::vector<double> arc_length{0.0};
    for (std::size_t i = 0; i < places.size(); ++i) {
        model.nodes.push_back({"node " + std::to_string(i), places[i]});
        rod.nodes.push_back(static_cast<int>(i));
        if (i > 0) arc_length.push_back(arc_length.back() + (places[i] - places[i - 1]).norm());
    }
    set_line_elements(rod, arc_length, std::vector<Quat>(places.size(), Quat::Identity()));
    model.rods = {rod};
    return model;
}

Model make_straight_rod() { return make_rod({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}); }

void hold(Model& model, int node, const Held& held, const Quat& axes = Quat::Identity()) {
    model.supports.push_back({.node = node, .fixed = held, .axes = axes});
}

std::vector<std::string> motions_of(const Model& model) {
    const std::vector<ModelPart> parts = find_parts(model);
    REQUIRE(parts.size() == 1);
    std::vector<std::string> texts;
    for (const UnsupportedMotion& motion : find_unsupported_motions(model, parts[0])) {
        texts.push_back(describe_unsupported_motion(model, parts[0], motion));
    }
    return texts;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("Without supports, a part has six free motions", "[check]") {
    CHECK(motions_of(make_straight_rod()) == Texts{"move along x",
                                                   "move along y",
                                                   "move along z",
                                                   "turn about an axis along x",
                                                   "turn about an axis along y",
                                                   "turn about an axis along z"});
}

TEST_CASE("A clamp leaves no free motion, fixed or moved, in any axes", "[check]") {
    Model model = make_straight_rod();
    hold(model, 0, all, exp_quaternion({0.3, -0.4, 0.9}));
    CHECK(motions_of(model).empty());
    model.supports[0].fixed = position;
    CHECK(motions_of(model).size() == 3);
    model.supports[0].moved = {false, false, false, true, true, true};
    CHECK(motions_of(model).empty());
}

TEST_CASE("A straight rod on two ball joints can twist", "[check]") {
    Model model = make_straight_rod();
    hold(model, 0, position);
    hold(model, 2, position);
    CHECK(motions_of(model) == Texts{"twist about its axis"});
    model.supports[1].fixed[0] = false;
    CHECK(motions_of(model) == Texts{"twist about its axis"});
    model.supports[0].fixed[0] = false;
    CHECK(motions_of(model) == Texts{"move along x", "twist about its axis"});
}

TEST_CASE("A bent rod on two ball joints turns about the line between them", "[check]") {
    Model model = make_rod({{1, 1, 5}, {1, 4, 5}, {4, 5, 5}});
    hold(model, 0, position);
    hold(model, 2, position);
    CHECK(motions_of(model) == Texts{"turn about an axis along (0.6, 0.8, 0) through (1, 1, 5)"});
}

TEST_CASE("A ball joint leaves three turns about itself", "[check]") {
    Model model = make_straight_rod();
    hold(model, 1, position);
    CHECK(motions_of(model) == Texts{"twist about its axis",
                                     "turn about an axis along y through (1, 0, 0)",
                                     "turn about an axis along z through (1, 0, 0)"});
}

TEST_CASE("A hinge leaves the turn about its own axis", "[check]") {
    Model model = make_straight_rod();
    hold(model, 2, {true, true, true, true, true, false});
    CHECK(motions_of(model) == Texts{"turn about an axis along z through (2, 0, 0)"});
    model.supports[0].axes = exp_quaternion({std::atan2(0.6, 0.8), 0, 0});
    CHECK(motions_of(model) == Texts{"turn about an axis along (0, -0.6, 0.8) through (2, 0, 0)"});
}

TEST_CASE("Free translations are along the global axes where they can be", "[check]") {
    Model model = make_straight_rod();
    hold(model, 0, {false, true, false, true, true, true});
    CHECK(motions_of(model) == Texts{"move along x", "move along z"});
    model.supports[0].axes = exp_quaternion({0, 0, std::atan2(0.6, 0.8)});
    CHECK(motions_of(model) == Texts{"move along z", "move along (0.8, 0.6, 0)"});
}

TEST_CASE("In its plane, a part that slides turns about any point", "[check]") {
    Model model = make_straight_rod();
    hold(model, 0, {false, false, true, true, true, false});
    CHECK(motions_of(model) == Texts{"move along x", "move along y", "turn about an axis along z"});
}

TEST_CASE("Supports can leave a screw", "[check]") {
    // Motions (v, ω) with v_x = p ω_x at the origin: a row of each support mixes both.
    Model model = make_rod({{0, 0, 0}, {0, 3, 0}, {0, 0, 3}, {5, 0, 0}});
    // Everything but a turn about x and a slide along it …
    hold(model, 0, {false, true, true, false, true, true});
    CHECK(motions_of(model) == Texts{"move along x", "turn about an axis along x through (0, 0, 0)"});
    // … tied together: at (0, 3, 0) the turn moves along z.
    hold(model,
         1,
         {true, false, false, false, false, false},
         Quat(Eigen::AngleAxisd(std::atan2(-0.6, 0.8), Vec3::UnitY())));
    const Texts motions = motions_of(model);
    REQUIRE(motions.size() == 1);
    // 0.8 v_x + 0.6 · 3 ω_x = 0
    CHECK(motions[0] ==
          "turn about an axis along x through (0, 0, 0) while it moves along it by 2.25 per rad");
}

TEST_CASE("Free motions do not move what is held, and are as many as there can be", "[check]") {
    tools::RandomValues random(3);
    for (int round = 0; round < 200; ++round) {
        Model model =
            make_rod(std::vector<Vec3>{random.vector(), random.vector(), random.vector(), random.vector()});
        Eigen::MatrixXd rows(0, 6);
        for (int node = 0; node < 4; node += 1 + round % 3) {
            Held held{};
            for (int i = 0; i < 6; ++i) held[i] = random.number(-1.0, 1.0) > (i < 3 ? 0.2 : 0.7);
            const Quat axes = exp_quaternion(random.vector());
            hold(model, node, held, axes);
            for (int i = 0; i < 6; ++i) {
                if (!held[i]) continue;
                const Vec3 axis = axes * Vec3::Unit(i % 3);
                rows.conservativeResize(rows.rows() + 1, 6);
                rows.bottomRows<1>().setZero();
                if (i < 3)
                    rows.bottomRows<1>() << axis.transpose(),
                        model.nodes[node].position.cross(axis).transpose();
                if (i >= 3) rows.bottomRows<1>().tail<3>() = axis.transpose();
            }
        }
        const auto motions = find_unsupported_motions(model, find_parts(model)[0]);
        const Eigen::Index rank = rows.rows() == 0 ? 0 : find_singular_values(rows).rank(1e-12);
        CHECK(static_cast<Eigen::Index>(motions.size()) == 6 - rank);
        for (const UnsupportedMotion& motion : motions) {
            Eigen::Matrix<double, 6, 1> about_origin;
            about_origin << motion.velocity - motion.rotation.cross(motion.point), motion.rotation;
            if (rows.rows() > 0)
                CHECK((rows * about_origin).cwiseAbs().maxCoeff() < 1e-8 * (1.0 + about_origin.norm()));
        }
    }
}

}  // namespace gxrod
