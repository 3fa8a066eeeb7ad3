// The equation of a gear: rates and gradients are derivatives, also where joints share a node or the ground.

#include "constraints/joints/gear_rows.hpp"

#include "constraints/joints/joint_samples.hpp"
#include "constraints/joints/wide_differences.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/node_paths.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double tolerance = 1e-9;  // of derivatives by seven-point differences
using Level = ConstraintLevel;
using Nodes = std::vector<NodeMotion>;

struct GearSample {
    std::string name;
    Model model;
    State state;  // trial motions anywhere, joints not closed

    GearRows rows() const { return {model, model.gears[0]}; }
    WidePlace at(const Nodes& nodes) const { return {nodes, state, state.joints_previous.back(), {}, 0.0}; }
    WidePlace here() const { return at(state.trial); }
};

struct GearKind {
    std::string name;
    std::array<JointKind, 2> kinds;
    std::array<bool, 2> are_turns;
    std::array<std::array<int, 2>, 2> nodes;  // of A and B of both joints
};

const std::vector<GearKind> gear_kinds{
    {"two turns of four nodes", {JointKind::hinge, JointKind::universal}, {true, true}, {{{0, 1}, {2, 3}}}},
    {"rack and pinion", {JointKind::hinge, JointKind::slider}, {true, false}, {{{0, 1}, {2, 3}}}},
    {"slide first", {JointKind::cylinder, JointKind::plane}, {false, true}, {{{3, 1}, {2, 0}}}},
    {"two slides", {JointKind::slider, JointKind::screw}, {false, false}, {{{0, 1}, {2, 3}}}},
    {"on the ground", {JointKind::hinge, JointKind::free}, {true, false}, {{{-1, 1}, {2, -1}}}},
    {"on a carrier", {JointKind::hinge, JointKind::free}, {true, true}, {{{0, 1}, {0, 2}}}}};

GearSample make_sample(const GearKind& kind, RandomValues& random) {
    GearSample sample;
    sample.name = kind.name;
    for (std::size_t i = 0; i < 2; ++i) {
        Joint joint = make_joint(kind.kinds[i], random);
        joint.a.anchor.node = kind.nodes[i][0];
        joint.b.anchor.node = kind.nodes[i][1];
        sample.model.joints.push_back(joint);
    }
    Gear gear;
    gear.name = "g";
    gear.sides = {GearSide{0, kind.are_turns[0]}, GearSide{1, kind.are_turns[1]}};
    gear.ratio = -1.7;
    sample.model.gears.push_back(gear);
    for (int node = 0; node < 4; ++node) {
        NodeMotion previous;
        previous.Lambda = exp_quaternion(random.vector(0.2));
        NodeMotion motion;
        place(previous, random.vector(), random.vector(0.3), motion);
        motion.v = random.vector();
        motion.a = random.vector();
        motion.omega = random.vector();
        motion.alpha = random.vector();
        sample.state.previous.push_back(previous);
        sample.state.trial.push_back(motion);
    }
    sample.state.joints_previous.resize(3);
    sample.state.joints_previous[0].turn = 31.0;
    sample.state.joints_previous[1].turn = -4.5;
    return sample;
}

// Calls check(sample, rows) for each kind.
template <class Check>
void for_each_gear(Check&& check) {
    RandomValues random(611);
    for (const GearKind& kind : gear_kinds) {
        const GearSample sample = make_sample(kind, random);
        INFO(sample.name);
        check(sample, sample.rows());
    }
}

// The derivative of function(nodes), a vector, as the unknowns of the equation's nodes move.
template <class Function>
Eigen::MatrixXd differentiate_gear(const GearSample& sample,
                                   const NodeLinearization& linearization,
                                   Function&& function) {
    return differentiate_by_unknowns(
        sample.state, sample.rows().list_nodes(sample.here()), linearization, function);
}

}  // namespace

TEST_CASE("The gradient of a gear is the derivative of its equation", "[constraints][joints][gear]") {
    for_each_gear([](const GearSample& sample, const GearRows& rows) {
        const Eigen::MatrixXd expected =
            differentiate_gear(sample, {.placement = 1.0}, [&](const Nodes& nodes) {
                return rows.compute_values(sample.at(nodes), Level::position, {});
            });
        CHECK(relative_difference(rows.compute_gradient(sample.here()), expected) < tolerance);
    });
}

TEST_CASE("The equation of a gear sums coordinates of its joints", "[constraints][joints][gear]") {
    for_each_gear([](const GearSample& sample, const GearRows& rows) {
        double sum = 0.0;
        const NodeMotion ground{};
        for (std::size_t i = 0; i < 2; ++i) {
            const Joint& joint = sample.model.joints[i];
            const auto motion = [&](const JointSide& side) -> const NodeMotion& {
                return side.anchor.is_ground() ? ground : sample.state.trial[side.anchor.node];
            };
            const JointMotions motions{motion(joint.a), motion(joint.b)};
            const JointCoordinates coordinates(joint);
            const double value =
                sample.model.gears[0].sides[i].is_turn
                    ? coordinates.turn->compute_jet(motions, sample.state.joints_previous[i].turn).value
                    : coordinates.slide->compute_jet(motions).value;
            sum += (i == 0 ? -1.7 : 1.0) * value;
        }
        CHECK(rows.compute_values(sample.here(), Level::position, {})[0] == sum);
        CHECK(rows.is_length(0) == !sample.model.gears[0].sides[1].is_turn);
    });
}

TEST_CASE("The equation of a gear at each level is the derivative by time of that before",
          "[constraints][joints][gear]") {
    for_each_gear([](const GearSample& sample, const GearRows& rows) {
        check_levels(sample.state, [&](const Nodes& nodes, Level level) {
            return rows.compute_values(sample.at(nodes), level, {});
        });
    });
}

TEST_CASE("The acceleration of a gear follows the unknowns", "[constraints][joints][gear]") {
    for_each_gear([](const GearSample& sample, const GearRows& rows) {
        for (const auto& [what, linearization] : make_linearizations()) {
            INFO(what);
            const Eigen::MatrixXd expected =
                differentiate_gear(sample, linearization, [&](const Nodes& nodes) {
                    return rows.compute_values(sample.at(nodes), Level::acceleration, {});
                });
            const std::vector<NodeLinearization> all(4, linearization);
            CHECK(relative_difference(rows.compute_acceleration_derivative(sample.here(), all), expected) <
                  tolerance);
        }
    });
}

TEST_CASE("The derivative of a gear's forces is that of its gradient", "[constraints][joints][gear]") {
    for_each_gear([](const GearSample& sample, const GearRows& rows) {
        const Eigen::VectorXd multipliers = Eigen::VectorXd::Constant(1, 0.8);
        const Eigen::MatrixXd expected =
            differentiate_gear(sample, {.placement = 1.0}, [&](const Nodes& nodes) {
                return Eigen::VectorXd(rows.compute_gradient(sample.at(nodes)).transpose() * multipliers);
            });
        const Eigen::MatrixXd derivative = rows.compute_force_derivative(sample.here(), multipliers);
        CHECK((derivative - expected).norm() < tolerance * (1.0 + expected.norm()));
    });
}

TEST_CASE("What a gear exerts through joints on the ground is the ground's", "[constraints][joints][gear]") {
    for_each_gear([](const GearSample& sample, const GearRows& rows) {
        const Eigen::VectorXd multipliers = Eigen::VectorXd::Constant(1, 0.8);
        const Eigen::VectorXd of_ground = rows.compute_ground_force(sample.here(), multipliers);
        if (sample.name == "on the ground")
            CHECK(of_ground == rows.compute_force(sample.here(), multipliers));
        else
            CHECK(of_ground.isZero(0.0));
    });
}

namespace {

// Calls check(sample, rows) for each kind with teeth that are pushed from both sides, and once free ones.
template <class Check>
void for_each_yielding_gear(Check&& check) {
    for_each_gear([&](const GearSample& rigid, const GearRows& rows) {
        const double sum = rows.compute_values(rigid.here(), Level::position, {})[0];
        for (const auto& [lower, upper] : {std::pair{sum - 3.0, sum - 0.6}, {sum + 0.4, sum + 2.0}}) {
            GearSample sample = rigid;
            sample.model.gears[0].teeth = {.lower = lower, .upper = upper, .stiffness = 90.0, .damping = 0.7};
            check(sample, sample.rows());
        }
    });
}

}  // namespace

TEST_CASE("Teeth that yield have no equation, and push by the slope of their energy",
          "[constraints][joints][gear]") {
    for_each_yielding_gear([](GearSample sample, const GearRows& rows) {
        CHECK(rows.count() == 0);
        CHECK(rows.has_laws());
        for (NodeMotion& motion : sample.state.trial) {
            motion.v.setZero();
            motion.omega.setZero();
        }
        const Eigen::MatrixXd slope = differentiate_gear(sample, {.placement = 1.0}, [&](const Nodes& nodes) {
            return Eigen::VectorXd(
                Eigen::VectorXd::Constant(1, rows.compute_strain_energy(sample.at(nodes))));
        });
        CHECK(slope.norm() > 1.0);
        CHECK(relative_difference(-rows.compute_law_force(sample.here()).transpose(), slope) < tolerance);
    });
}

TEST_CASE("The tangent of teeth that yield is the derivative of their force", "[constraints][joints][gear]") {
    for_each_yielding_gear([](const GearSample& sample, const GearRows& rows) {
        for (const auto& [what, linearization] : make_linearizations()) {
            INFO(what);
            const Eigen::MatrixXd expected =
                differentiate_gear(sample, linearization, [&](const Nodes& nodes) {
                    return rows.compute_law_force(sample.at(nodes));
                });
            const std::vector<NodeLinearization> all(4, linearization);
            const Eigen::MatrixXd tangent = rows.compute_law_tangent(sample.here(), all);
            CHECK((tangent - expected).norm() < tolerance * (1.0 + expected.norm()));
        }
    });
}

TEST_CASE("Teeth within their backlash are free", "[constraints][joints][gear]") {
    for_each_gear([](GearSample sample, const GearRows& rigid) {
        const double sum = rigid.compute_values(sample.here(), Level::position, {})[0];
        sample.model.gears[0].teeth = {
            .lower = sum - 1e-3, .upper = sum + 1e-3, .stiffness = 90.0, .damping = 0.7};
        const GearRows rows = sample.rows();
        CHECK(rows.compute_law_force(sample.here()).isZero(0.0));
        CHECK(rows.compute_strain_energy(sample.here()) == 0.0);
        CHECK(rows.compute_damping_power(sample.here()) == 0.0);
        CHECK(rows.compute_joint_values(sample.here(), {}).play == sum);
    });
}
