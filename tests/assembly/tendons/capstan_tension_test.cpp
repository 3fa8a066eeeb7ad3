// Tensions along tendons that rub in their paths, and how they follow the motions of nodes.

#include "assembly/tendons/capstan_tension.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/scatter.hpp"
#include "assembly/system.hpp"
#include "assembly/tendons/capstan_rows.hpp"
#include "deck/decks.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

namespace gxrod::test {
namespace {

using namespace gxrod::tools;

constexpr double rubbing_time = 0.3;

// A helix beside the first of two rods, from 0.25 to its end; another tendon with friction comes behind it,
// so that memories have places of their own.
std::string rubbing_rods(const std::string& element, int order, const std::string& friction) {
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
elements = 3
order = )deck" +
           std::to_string(order) + "\nelement = \"" + element + R"deck("
[tendon.t]
on = "arm"
offset = ["0.1*cos(2*s)", "0.1*sin(2*s)"]
from = 0.25
tension = 3
)deck" + friction +
           R"deck(
[tendon.last]
on = "other"
offset = [0, 0.1]
tension = 2
friction = 0.2
[analysis]
kind = "dynamic"
end_time = 1
steps = 10
)deck";
}

NodeMotion displace(const NodeMotion& previous, RandomValues& random) {
    NodeMotion motion;
    place(previous, previous.r + random.vector(0.05), random.vector(0.2), motion);
    return motion;
}

// Trial motions anywhere near others that were accepted, and tensions of which some slip this way, some that
// way, and some stick.
struct RubbingSample {
    explicit RubbingSample(const std::string& deck)
        : problem(read(deck)), system(problem.model), tension(list_capstan_tensions(problem.model).front()) {
        state = system.initial_state();
        RandomValues random(47);
        for (NodeMotion& motion : state.trial) motion = displace(motion, random);
        system.commit(state, 0.1);
        for (std::size_t i = 0; i < state.trial.size(); ++i)
            state.trial[i] = displace(state.previous[i], random);
        const std::vector<double> first = tension.compute(state.trial, state, rubbing_time);
        const std::span<double> memory = tension.memory().of(state);
        for (std::size_t i = 0; i < memory.size(); ++i)
            memory[i] = i % 3 == 0 ? 0.5 * first[i] : i % 3 == 1 ? 1.01 * first[i] : 2.0 * first[i];
    }

    Problem problem;
    System system;
    CapstanTension tension;
    State state;
};

template <class Check>
void for_each_rubbing(const std::string& friction, Check&& check) {
    for (const std::string element : {"objective", "simo"}) {
        for (const int order : {1, 2, 3, 4}) {
            INFO(element << " " << order << " " << friction);
            RubbingSample sample(rubbing_rods(element, order, friction));
            check(sample);
        }
    }
}

const std::string by_friction = "friction = 0.6\n";

}  // namespace

TEST_CASE("The direction of a tendon follows the nodes as its derivative says", "[assembly][tendon]") {
    for_each_rubbing(by_friction, [](const RubbingSample& sample) {
        const TendonLine line(sample.problem.model, sample.problem.model.tendons.front());
        const std::vector<TendonTangent> here = line.list_tangents(sample.state.trial, sample.state, true);
        double length = 0.0;
        for (const TendonTangent& tangent : here) length += tangent.weight * tangent.slope.norm();
        CHECK(length == Approx(line.compute_length(sample.state.trial, sample.state)).epsilon(1e-13));
        for (std::size_t k = 0; k < line.nodes().size(); ++k) {
            const auto node = static_cast<std::size_t>(line.nodes()[k]);
            for (int unknown = 0; unknown < 6; ++unknown) {
                const Eigen::VectorXd expected = differentiate(
                    [&](double amount) {
                        const Vec6 by = amount * Vec6::Unit(unknown);
                        std::vector<NodeMotion> moved = sample.state.trial;
                        apply_spin(sample.state.previous[node], by.head<3>(), by.tail<3>(), moved[node]);
                        Eigen::VectorXd all(3 * static_cast<Eigen::Index>(here.size()));
                        Eigen::Index row = 0;
                        for (const TendonTangent& at : line.list_tangents(moved, sample.state, false)) {
                            all.segment<3>(row) = at.slope;
                            row += 3;
                        }
                        return all;
                    },
                    1e-3);
                for (std::size_t i = 0; i < here.size(); ++i) {
                    const Vec3 own = here[i].gradient.col(6 * static_cast<Eigen::Index>(k) + unknown);
                    CHECK((own - expected.segment<3>(3 * static_cast<Eigen::Index>(i))).norm() < 1e-9);
                }
            }
        }
    });
}

TEST_CASE("The tangent of a model whose tendon rubs is the derivative of its residual",
          "[assembly][tendon]") {
    for (const std::string& friction : {by_friction,
                                        by_friction + "pulled_at = \"to\"\n",
                                        by_friction + "stiffness = 40\n",
                                        by_friction + "stiffness = 40\npulled_at = \"to\"\n"}) {
        for_each_rubbing(friction, [](const RubbingSample& sample) {
            const System& system = sample.system;
            std::vector<double> values;
            const std::vector<NodeLinearization> placed(sample.state.trial.size(), {.placement = 1.0});
            system.compute_tangent(sample.state, rubbing_time, placed, values);
            const std::int64_t size = system.equations().count();
            Eigen::MatrixXd expected(size, size);
            for (std::int64_t j = 0; j < size; ++j) {
                const int node = system.equations().unknown(j).node;
                const Vec6 direction = system.equations().increment_of(node, Eigen::VectorXd::Unit(size, j));
                expected.col(j) = differentiate(
                    [&](double amount) {
                        State moved = sample.state;
                        const Vec6 by = amount * direction;
                        apply_spin(moved.previous[node], by.head<3>(), by.tail<3>(), moved.trial[node]);
                        Residual residual;
                        system.compute_residual(moved, rubbing_time, residual);
                        return gather(residual.nodal, system.equations());
                    },
                    1e-4);  // of directions that turn by little
            }
            const Eigen::MatrixXd tangent = make_dense(system.pattern(), values);
            // Of what elements do not know alone: the rod's own stiffness is a thousand times as large.
            CapstanRows rows(sample.tension);
            const WidePlace at{
                sample.state.trial, sample.state, sample.state.joints_previous[0], {}, rubbing_time};
            const double own = rows.compute_law_tangent(at, placed).norm();
            REQUIRE(own > 0.1);
            CHECK((tangent - expected).norm() < 1e-6 * own);
        });
    }
}

TEST_CASE("About an accepted state a tendon sticks and keeps its tensions", "[assembly][tendon]") {
    for_each_rubbing(by_friction, [](RubbingSample& sample) {
        const std::vector<double> expected =
            sample.tension.compute(sample.state.trial, sample.state, rubbing_time);
        sample.system.commit(sample.state, rubbing_time);
        const std::span<const double> kept = sample.tension.memory().of(sample.state);
        CHECK(std::ranges::equal(kept, expected));
        CHECK(sample.tension.compute(sample.state.trial, sample.state, rubbing_time) == expected);
        CHECK(sample.tension.compute_coupling(sample.state.trial, sample.state, rubbing_time).isZero(0.0));
    });
}

TEST_CASE("Without a coefficient the tension is the same all along", "[assembly][tendon]") {
    for_each_rubbing(by_friction, [](RubbingSample& sample) {
        sample.problem.model.tendons.front().friction->coefficient = 0.0;
        const std::vector<double> tensions =
            sample.tension.compute(sample.state.trial, sample.state, rubbing_time);
        for (const double tension : tensions) CHECK(tension == Approx(3.0).epsilon(1e-14));
        Model smooth = sample.problem.model;
        smooth.tendons.front().friction.reset();
        const System other(smooth);
        State state = sample.state;
        state.memory.erase(state.memory.begin(),
                           state.memory.begin() + static_cast<std::ptrdiff_t>(sample.tension.count()));
        Residual rubbed, unrubbed;
        sample.system.compute_residual(sample.state, rubbing_time, rubbed);
        other.compute_residual(state, rubbing_time, unrubbed);
        const double scale = rubbed.force_scale;
        for (std::size_t i = 0; i < rubbed.nodal.size(); ++i)
            CHECK((rubbed.nodal[i] - unrubbed.nodal[i]).norm() < 1e-14 * scale);
    });
}

TEST_CASE("A tendon that would push where it rubs is refused, but for round-off", "[assembly][tendon]") {
    const RubbingSample sample(rubbing_rods("objective", 2, by_friction));
    Model model = sample.problem.model;
    const auto compute = [&](double pull) {
        model.tendons.front().tension = TimeFunction(pull);
        const CapstanTension tension = list_capstan_tensions(model).front();
        return tension.compute(sample.state.trial, sample.state, rubbing_time);
    };
    CHECK_THROWS_WITH(compute(-15.0),
                      Catch::Contains("tendon.t.tension is -15 at t = 0.3") && Catch::Contains("only pulls"));
    // Let go altogether, it has no tension anywhere.
    for (const double tension : compute(-1e-15)) CHECK(tension == 0.0);
}

// A tendon with a kink of atan(0.5) at the middle of a straight rod, and none elsewhere.
TEST_CASE("A straight tendon loses no tension, and one with a kink its share there", "[assembly][tendon]") {
    const std::string deck = replaced(rubbing_rods("objective", 2, by_friction),
                                      "offset = [\"0.1*cos(2*s)\", \"0.1*sin(2*s)\"]\nfrom = 0.25",
                                      "offset = [[0, 0, 0], [0.5, 0, 0], [1, 0.5, 0]]");
    const Problem problem = read(deck);
    const System system(problem.model);
    const State state = system.initial_state();
    const CapstanTension tension = list_capstan_tensions(problem.model).front();
    const std::vector<double> tensions = tension.compute(state.trial, state, rubbing_time);
    const double after = 3.0 * std::exp(-0.6 * std::atan(0.5));
    CHECK(tensions.front() == Approx(3.0).epsilon(1e-14));
    CHECK(tensions[tensions.size() - 2] == Approx(after).epsilon(1e-14));
    CHECK(tensions.back() == Approx(after).epsilon(1e-14));
}

// On a straight rod the tendon's direction goes round a circle on the sphere, of the radius sin α; its angles
// between force points are chords of that, so that the turning is short by the order 2.
TEST_CASE("The turning of a helix is found to the second order", "[assembly][tendon]") {
    const auto find_loss = [](int elements) {
        const std::string deck =
            replaced(replaced(rubbing_rods("objective", 2, by_friction), "from = 0.25", "from = 0"),
                     "elements = 3\norder = 2\nelement = \"objective\"",
                     "elements = " + std::to_string(elements) + "\norder = 2\nelement = \"objective\"");
        const Problem problem = read(deck);
        const System system(problem.model);
        const State state = system.initial_state();
        const CapstanTension tension = list_capstan_tensions(problem.model).front();
        return -std::log(tension.compute(state.trial, state, rubbing_time).back() / 3.0) / 0.6;
    };
    const double exact = 4.0 * 0.2 / std::hypot(1.0, 0.2);
    const double coarse = exact - find_loss(8), fine = exact - find_loss(16);
    CHECK(std::abs(fine) < 1e-3 * exact);
    CHECK(coarse / fine == Approx(4.0).epsilon(0.1));
}

}  // namespace gxrod::test
