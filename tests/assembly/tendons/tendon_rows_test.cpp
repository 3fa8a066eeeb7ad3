// Tendons that winches draw in: their length and its derivatives in motions of nodes.

#include "assembly/tendons/tendon_rows.hpp"

#include <numbers>

#include "assembly/system.hpp"
#include "constraints/joints/wide_differences.hpp"
#include "deck/decks.hpp"
#include "state/increment.hpp"

namespace gxrod::test {
namespace {

using namespace gxrod::tools;
using Level = ConstraintLevel;
using Nodes = std::vector<NodeMotion>;

constexpr double tolerance = 1e-8;  // of derivatives by seven-point differences

// A helix beside the first of two rods, from 0.25 to its end; the second one only takes places among the
// histories of sections.
std::string two_rods(const std::string& element, int order, const std::string& winch) {
    return R"deck([section.s]
stiffness = { EA = 1e4, GAy = 4e3, GAz = 4e3, GJ = 5, EIy = 6, EIz = 7 }
inertia = { rhoA = 1.0, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
[rod.other]
section = "s"
line = { from = [0, 1, 0], to = [2, 1, 0] }
elements = 3
order = 2
element = "simo"
[rod.arm]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
order = )deck" +
           std::to_string(order) + "\nelement = \"" + element + R"deck("
[tendon.t]
on = "arm"
offset = ["0.1*cos(2*s)", "0.1*sin(2*s)"]
from = 0.25
)deck" + winch +
           R"deck(
[analysis]
kind = "dynamic"
end_time = 1
steps = 10
)deck";
}

NodeMotion move(const NodeMotion& previous, RandomValues& random) {
    NodeMotion motion;
    place(previous, previous.r + random.vector(0.05), random.vector(0.2), motion);
    motion.v = random.vector();
    motion.a = random.vector();
    motion.omega = random.vector();
    motion.alpha = random.vector();
    return motion;
}

// Trial motions anywhere near others that were accepted.
struct Sample {
    explicit Sample(const std::string& deck) : problem(read(deck)), rows(problem.model, tendon()) {
        const System system(problem.model);
        state = system.initial_state();
        RandomValues random(31);
        for (NodeMotion& motion : state.trial) motion = move(motion, random);
        system.commit(state, 0.1);
        for (std::size_t i = 0; i < state.trial.size(); ++i) state.trial[i] = move(state.previous[i], random);
    }
    const Tendon& tendon() const { return problem.model.tendons.front(); }
    WidePlace at(const Nodes& nodes) const { return {nodes, state, state.joints_previous[0], {}, 0.3}; }
    WidePlace here() const { return at(state.trial); }
    template <class Function>
    Eigen::MatrixXd differentiate(const NodeLinearization& linearization, Function&& function) const {
        return differentiate_by_unknowns(state, rows.list_nodes(here()), linearization, function);
    }

    Problem problem;
    TendonRows rows;
    State state;
};

template <class Check>
void for_each_tendon(const std::string& winch, Check&& check) {
    for (const std::string element : {"objective", "simo"}) {
        for (const int order : {1, 3}) {
            INFO(element << " " << order);
            check(Sample(two_rods(element, order, winch)));
        }
    }
}

const std::string stiff = "shortening = \"0.05*t^2\"\nslack = false\n";
const std::string elastic = "shortening = \"0.5*t\"\nstiffness = 300\n";

}  // namespace

TEST_CASE("A tendon's length at the start is that of its path", "[assembly][tendon]") {
    for_each_tendon(stiff, [](const Sample& sample) {
        const TendonLine line(sample.problem.model, sample.tendon());
        CHECK(line.start_length() == Approx(1.5 * std::hypot(1.0, 0.2)).epsilon(1e-12));
        CHECK(line.nodes().front() ==
              sample.problem.model.rods[1].element_nodes[line.nodes().size() / 3 + 1]);
        CHECK(line.nodes().back() == sample.problem.model.rods[1].nodes.back());
    });
}

TEST_CASE("The gradient of a tendon's equation is its derivative", "[assembly][tendon]") {
    for_each_tendon(stiff, [](const Sample& sample) {
        const Eigen::MatrixXd expected = sample.differentiate({.placement = 1.0}, [&](const Nodes& nodes) {
            return sample.rows.compute_values(sample.at(nodes), Level::position, {});
        });
        CHECK(relative_difference(sample.rows.compute_gradient(sample.here()), expected) < tolerance);
    });
}

TEST_CASE("A tendon's equation at each level is the derivative by time of the one before",
          "[assembly][tendon]") {
    for_each_tendon("shortening = 0\nslack = false\n", [](const Sample& sample) {
        // The motions of this check are not since the last step, from which this element measures.
        if (sample.problem.model.rods[1].kind == ElementKind::simo) return;
        check_levels(sample.state, [&](const Nodes& nodes, Level level) {
            return sample.rows.compute_values(sample.at(nodes), level, {});
        });
    });
}

TEST_CASE("What a winch prescribes enters a tendon's equation at all levels", "[assembly][tendon]") {
    const Sample sample(two_rods("objective", 3, stiff));
    const Sample still(two_rods("objective", 3, "shortening = 0\nslack = false\n"));
    const auto added = [&](Level level) {
        return sample.rows.compute_values(sample.here(), level, {0.2, 0.2})[0] -
               still.rows.compute_values(still.here(), level, {0.2, 0.2})[0];
    };
    CHECK(added(Level::position) == Approx(-0.05 * 0.3 * 0.3));
    CHECK(added(Level::velocity) == Approx(-0.1 * 0.3));
    CHECK(added(Level::acceleration) == Approx(-0.1));
}

TEST_CASE("The accelerations of a tendon follow the unknowns", "[assembly][tendon]") {
    for_each_tendon(stiff, [](const Sample& sample) {
        for (const auto& [what, linearization] : make_linearizations()) {
            INFO(what);
            const Eigen::MatrixXd expected = sample.differentiate(linearization, [&](const Nodes& nodes) {
                return sample.rows.compute_values(sample.at(nodes), Level::acceleration, {0.2, 0.2});
            });
            const std::vector<NodeLinearization> all(sample.state.trial.size(), linearization);
            // Third derivatives of the length are differences themselves.
            CHECK(relative_difference(sample.rows.compute_acceleration_derivative(sample.here(), all),
                                      expected) < 1e-6);
        }
    });
}

TEST_CASE("The derivative of a tendon's forces is that of its gradient", "[assembly][tendon]") {
    for_each_tendon(stiff, [](const Sample& sample) {
        const Eigen::VectorXd tension = Eigen::VectorXd::Constant(1, 0.8);
        const Eigen::MatrixXd expected = sample.differentiate({.placement = 1.0}, [&](const Nodes& nodes) {
            return Eigen::VectorXd(sample.rows.compute_gradient(sample.at(nodes)).transpose() * tension);
        });
        CHECK(relative_difference(sample.rows.compute_force_derivative(sample.here(), tension), expected) <
              tolerance);
    });
}

TEST_CASE("The tangent of a tendon that stretches is the derivative of its forces, which its energy is of",
          "[assembly][tendon]") {
    for_each_tendon(elastic, [](const Sample& sample) {
        const Eigen::VectorXd here = sample.rows.compute_law_force(sample.here());
        REQUIRE(here.norm() > 1.0);
        const Eigen::MatrixXd of_energy = sample.differentiate({.placement = 1.0}, [&](const Nodes& nodes) {
            return Eigen::VectorXd::Constant(1, sample.rows.compute_strain_energy(sample.at(nodes)));
        });
        CHECK(relative_difference(-here.transpose(), of_energy) < tolerance);
        const NodeLinearization placed{.placement = 1.0};
        const Eigen::MatrixXd expected = sample.differentiate(
            placed, [&](const Nodes& nodes) { return sample.rows.compute_law_force(sample.at(nodes)); });
        const std::vector<NodeLinearization> all(sample.state.trial.size(), placed);
        CHECK(relative_difference(sample.rows.compute_law_tangent(sample.here(), all), expected) < tolerance);
    });
}

TEST_CASE("A tendon exerts no force and no moment on the whole of its rod", "[assembly][tendon]") {
    for_each_tendon(stiff, [](const Sample& sample) {
        const Eigen::VectorXd force =
            sample.rows.compute_force(sample.here(), Eigen::VectorXd::Constant(1, 2.0));
        const std::vector<int> nodes = sample.rows.list_nodes(sample.here());
        Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const Vec6 own = force.segment<6>(6 * static_cast<Eigen::Index>(i));
            sum += own.head<3>();
            moment += own.tail<3>() +
                      sample.state.trial[static_cast<std::size_t>(nodes[i])].r.cross(Vec3(own.head<3>()));
        }
        CHECK(sum.norm() < 1e-13 * force.norm());
        // Elements that interpolate rotations since the last step do not see rigid turns exactly.
        if (sample.problem.model.rods[1].kind == ElementKind::objective)
            CHECK(moment.norm() < 1e-13 * force.norm());
    });
}

TEST_CASE("A tendon lets go where it is longer than its path, and a winch that is released always",
          "[assembly][tendon]") {
    const auto holds = [](const Sample& sample, double tension) {
        return sample.rows.hold(sample.here(), Eigen::VectorXd::Constant(1, tension), Level::position);
    };
    const Sample taut(two_rods("objective", 2, "shortening = \"2*t\"\n"));
    CHECK(holds(taut, 0.0));
    CHECK(holds(taut, -1.0));  // not yet as short as prescribed
    const Sample loose(two_rods("objective", 2, "shortening = \"-2*t\"\n"));
    CHECK_FALSE(holds(loose, 0.0));
    CHECK_FALSE(holds(loose, 1.0));
    CHECK(holds(Sample(two_rods("objective", 2, "shortening = \"-2*t\"\nslack = false\n")), -1.0));
    Sample released(two_rods("objective", 2, "shortening = \"2*t\"\n"));
    released.problem.model.tendons.front().winch->is_released = true;
    CHECK_FALSE(holds(released, 1.0));
    const Sample elastic_loose(two_rods("objective", 2, "shortening = \"-2*t\"\nstiffness = 300\n"));
    CHECK(elastic_loose.rows.compute_law_force(elastic_loose.here()).norm() == 0.0);
}

}  // namespace gxrod::test
