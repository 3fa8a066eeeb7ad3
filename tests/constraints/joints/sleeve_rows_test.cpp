// The equations of a sleeve in motions of nodes: with arms, motors and laws, on bodies and on the ground.

#include "constraints/joints/sleeve_rows.hpp"

#include "constraints/joints/wide_differences.hpp"
#include "state/increment.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double tolerance = 1e-9;  // of derivatives by seven-point differences
using Level = ConstraintLevel;
using Nodes = std::vector<NodeMotion>;

constexpr int rod_nodes = 8;

struct SleeveSample {
    Model model;
    State state;  // trial motions anywhere near, the point not on the line

    SleeveRows rows() const { return {model, model.sleeves[0]}; }
    WidePlace at(const Nodes& nodes) const { return {nodes, state, state.joints_previous[0], {}, 0.3}; }
    WidePlace here() const { return at(state.trial); }
};

// A rod of nodes 0 to 7 along x, in unequal elements; the point is carried by node 8, or by the ground.
SleeveSample make_sample(bool is_on_ground, bool has_motor, bool holds_turn = false) {
    RandomValues random(77);
    SleeveSample sample;
    Rod rod;
    rod.name = "rod";
    std::vector<double> arc_lengths;
    for (int i = 0; i < rod_nodes; ++i) {
        rod.nodes.push_back(i);
        arc_lengths.push_back(0.4 * i + 0.05 * (i % 3));
    }
    std::vector<Quat> triads(rod_nodes, Quat::Identity());
    for (int i = 0; i < rod_nodes && holds_turn; ++i)
        triads[static_cast<std::size_t>(i)] = exp_quaternion(0.2 * i * Vec3(0.3, -0.2, 0.5));
    set_line_elements(rod, arc_lengths, triads);
    sample.model.rods.push_back(rod);
    Sleeve sleeve;
    sleeve.name = "sleeve";
    sleeve.place = 1.5;
    sleeve.holds_turn = holds_turn;
    if (is_on_ground)
        sleeve.point.arm = Vec3(1.42, 0.1, -0.05);
    else
        sleeve.point = {.node = rod_nodes, .arm = Vec3(0.1, 0.2, -0.1)};
    if (has_motor) sleeve.slide.motion = TimeFunction([](double t) { return 0.2 * t * t; });
    sleeve.slide.stiffness = 3.0;
    sleeve.slide.damping = 0.7;
    sleeve.slide.drive = TimeFunction(1.1);
    sample.model.sleeves.push_back(sleeve);
    for (int node = 0; node <= rod_nodes; ++node) {
        NodeMotion previous;
        previous.r = node < rod_nodes ? Vec3(arc_lengths[static_cast<std::size_t>(node)], 0.0, 0.0)
                                      : Vec3(1.32, -0.1, 0.1);
        NodeMotion motion;
        place(previous, previous.r + random.vector(0.05), random.vector(0.3), motion);
        motion.v = random.vector();
        motion.a = random.vector();
        motion.omega = random.vector();
        motion.alpha = random.vector();
        sample.state.previous.push_back(previous);
        sample.state.trial.push_back(motion);
    }
    sample.state.joints_previous.resize(1);
    sample.state.joints_previous[0].slide = -0.05;
    return sample;
}

// Calls check(sample, rows) with and without a motor, on a body and on the ground, free to turn or not.
template <class Check>
void for_each_sleeve(Check&& check) {
    for (const bool is_on_ground : {false, true}) {
        for (const bool has_motor : {false, true}) {
            for (const bool holds_turn : {false, true}) {
                const SleeveSample sample = make_sample(is_on_ground, has_motor, holds_turn);
                INFO("on ground " << is_on_ground << ", motor " << has_motor << ", holds turn "
                                  << holds_turn);
                check(sample, sample.rows());
            }
        }
    }
}

template <class Function>
Eigen::MatrixXd differentiate_sleeve(const SleeveSample& sample,
                                     const NodeLinearization& linearization,
                                     Function&& function) {
    return differentiate_by_unknowns(
        sample.state, sample.rows().list_nodes(sample.here()), linearization, function);
}

Eigen::VectorXd make_multipliers(const SleeveRows& rows) {
    return (Vec6() << 0.8, -1.3, 0.6, 0.9, -0.4, 1.1).finished().head(rows.count());
}

}  // namespace

TEST_CASE("The gradient of a sleeve is the derivative of its equations", "[constraints][joints][sleeve]") {
    for_each_sleeve([](const SleeveSample& sample, const SleeveRows& rows) {
        const Eigen::MatrixXd expected =
            differentiate_sleeve(sample, {.placement = 1.0}, [&](const Nodes& nodes) {
                return rows.compute_values(sample.at(nodes), Level::position, {});
            });
        CHECK(relative_difference(rows.compute_gradient(sample.here()), expected) < tolerance);
    });
}

TEST_CASE("The equations of a sleeve at each level are the derivatives by time of those before",
          "[constraints][joints][sleeve]") {
    for_each_sleeve([](const SleeveSample& sample, const SleeveRows& rows) {
        if (rows.count() % 3 == 0) return;  // the motor's part is a matter of its time alone
        check_levels(sample.state, [&](const Nodes& nodes, Level level) {
            return rows.compute_values(sample.at(nodes), level, {});
        });
    });
}

TEST_CASE("What a motor prescribes is taken off a sleeve's slide", "[constraints][joints][sleeve]") {
    const SleeveSample sample = make_sample(false, true);
    const SleeveRows rows = sample.rows();
    const TimeSpan step{0.2, 0.2};
    const JointValues values = rows.compute_joint_values(sample.here(), Eigen::VectorXd::Zero(3));
    CHECK(rows.compute_values(sample.here(), Level::position, step)[2] ==
          Approx(values.slide - 0.2 * 0.3 * 0.3));
    CHECK(rows.compute_values(sample.here(), Level::velocity, step)[2] ==
          Approx(values.slide_rate - 0.4 * 0.3));
}

TEST_CASE("The accelerations of a sleeve follow the unknowns", "[constraints][joints][sleeve]") {
    for_each_sleeve([](const SleeveSample& sample, const SleeveRows& rows) {
        for (const auto& [what, linearization] : make_linearizations()) {
            INFO(what);
            const Eigen::MatrixXd expected =
                differentiate_sleeve(sample, linearization, [&](const Nodes& nodes) {
                    return rows.compute_values(sample.at(nodes), Level::acceleration, {0.2, 0.2});
                });
            const std::vector<NodeLinearization> all(rod_nodes + 1, linearization);
            CHECK(relative_difference(rows.compute_acceleration_derivative(sample.here(), all), expected) <
                  tolerance);
        }
    });
}

TEST_CASE("The derivative of a sleeve's forces is that of its gradient", "[constraints][joints][sleeve]") {
    for_each_sleeve([](const SleeveSample& sample, const SleeveRows& rows) {
        const Eigen::VectorXd multipliers = make_multipliers(rows);
        const Eigen::MatrixXd expected =
            differentiate_sleeve(sample, {.placement = 1.0}, [&](const Nodes& nodes) {
                return Eigen::VectorXd(rows.compute_gradient(sample.at(nodes)).transpose() * multipliers);
            });
        CHECK(relative_difference(rows.compute_force_derivative(sample.here(), multipliers), expected) <
              tolerance);
    });
}

TEST_CASE("The tangent of what acts along a sleeve is the derivative of its forces",
          "[constraints][joints][sleeve]") {
    for_each_sleeve([](const SleeveSample& sample, const SleeveRows& rows) {
        for (const auto& [what, linearization] : make_linearizations()) {
            INFO(what);
            const Eigen::MatrixXd expected =
                differentiate_sleeve(sample, linearization, [&](const Nodes& nodes) {
                    return rows.compute_law_force(sample.at(nodes));
                });
            const std::vector<NodeLinearization> all(rod_nodes + 1, linearization);
            CHECK(relative_difference(rows.compute_law_tangent(sample.here(), all), expected) < tolerance);
        }
    });
}

TEST_CASE("A sleeve's forces on the line and the point are in balance", "[constraints][joints][sleeve]") {
    const SleeveSample sample = make_sample(false, true);
    const SleeveRows rows = sample.rows();
    const std::vector<int> nodes = rows.list_nodes(sample.here());
    const Eigen::VectorXd force = rows.compute_force(sample.here(), make_multipliers(rows));
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < nodes.size(); ++i) sum += force.segment<3>(6 * static_cast<Eigen::Index>(i));
    CHECK(sum.norm() < 1e-14 * force.norm());
    CHECK(nodes.front() == rod_nodes);
    CHECK(nodes.size() == 7);
}

// Multipliers of any motion without a change of the equations: none of them does work.
TEST_CASE("A sleeve that does not turn exerts no moment in all", "[constraints][joints][sleeve]") {
    const SleeveSample sample = make_sample(false, true, true);
    const SleeveRows rows = sample.rows();
    const std::vector<int> nodes = rows.list_nodes(sample.here());
    const Eigen::VectorXd multipliers =
        make_multipliers(rows).array() * Eigen::Array<double, 6, 1>(0, 0, 0, 1, 1, 1);
    const Eigen::VectorXd force = rows.compute_force(sample.here(), multipliers);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Vec6 on_node = force.segment<6>(6 * static_cast<Eigen::Index>(i));
        sum += on_node.head<3>();
        moment += on_node.tail<3>() +
                  sample.state.trial[static_cast<std::size_t>(nodes[i])].r.cross(Vec3(on_node.head<3>()));
    }
    CHECK(sum.norm() < 1e-14 * force.norm());
    CHECK(moment.norm() < 1e-14 * force.norm());
}

TEST_CASE("All that a sleeve on the ground exerts on the rod is the ground's",
          "[constraints][joints][sleeve]") {
    const bool holds_turn = GENERATE(false, true);
    const SleeveSample sample = make_sample(true, false, holds_turn);
    const SleeveRows rows = sample.rows();
    const Eigen::VectorXd multipliers = make_multipliers(rows);
    const Eigen::VectorXd all =
        rows.compute_force(sample.here(), multipliers) + rows.compute_law_force(sample.here());
    CHECK(relative_difference(rows.compute_ground_force(sample.here(), multipliers), all) < 1e-14);
    CHECK(make_sample(false, false).rows().compute_ground_force(sample.here(), multipliers).size() == 0);
}

TEST_CASE("A sleeve takes the energy of its spring, and its damper power", "[constraints][joints][sleeve]") {
    const SleeveSample sample = make_sample(false, false);
    const SleeveRows rows = sample.rows();
    const JointValues values = rows.compute_joint_values(sample.here(), make_multipliers(rows));
    CHECK(rows.compute_strain_energy(sample.here()) == Approx(0.5 * 3.0 * values.slide * values.slide));
    CHECK(rows.compute_damping_power(sample.here()) == Approx(0.7 * values.slide_rate * values.slide_rate));
}
