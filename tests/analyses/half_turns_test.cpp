// Rotations of exactly half turns and whole turns, and of a few units of the last place more or less.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "deck/decks.hpp"
#include "model/energy_round_off.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/run.hpp"
#include "tools/static_run.hpp"
#include "tools/tops.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

using std::numbers::pi;

// The double nearest to k π, and its neighbours `steps` away.
double half_turns(int k, int steps) {
    double angle = k * pi;
    for (int i = 0; i < std::abs(steps); ++i) angle = std::nextafter(angle, steps > 0 ? 1e3 : -1e3);
    return angle;
}

// A rod along x whose start is turned by the vector φ while nothing loads it.
Model make_turned_rod(const Vec3& phi, const std::string& element) {
    Problem problem =
        test::read(test::static_rod_deck + "[[support]]\nat = \"r.start\"\nfix = \"position\"\n",
                   {"rod.r.element=" + element, "rod.r.elements=3"});
    for (int i = 0; i < 3; ++i) {
        problem.model.supports[0].moved[3 + i] = true;
        problem.model.supports[0].motion[3 + i] =
            TimeFunction([angle = phi[i]](double t) { return angle * t; });
    }
    return problem.model;
}

// A rod along x that turns about z at a rate, carried by a support at its start.
Problem read_carried_rod(int half_turns_a_second, const std::string& element, const std::string& integrator) {
    return test::read(fmt::format(R"([section.s]
stiffness = {{ EA = 1e5, GAy = 1e5, GAz = 1e5, GJ = 1e4, EIy = 1e4, EIz = 1e4 }}
inertia = {{ rhoA = 1.0, rhoIy = 0.01, rhoIz = 0.01 }}
[rod.r]
section = "s"
line = {{ from = [0, 0, 0], to = [2, 0, 0] }}
elements = 3
order = 2
element = "{1}"
[[initial]]
on = "r"
velocity = ["-({0})*pi*y", "{0}*pi*x", 0]
angular_velocity = [0, 0, "{0}*pi"]
[[support]]
at = "r.start"
fix = ["position", "rx", "ry"]
move = {{ rz = "{0}*pi*t" }}
[analysis]
kind = "dynamic"
integrator = "{2}"
end_time = 1
steps = 48
)",
                                  half_turns_a_second,
                                  element,
                                  integrator));
}

// A body that turns about its second axis, for four steps of 1.
Model make_spinning_body(double rate) { return make_free_body(Vec3(1.0, 2.0, 4.0), Vec3(0.0, rate, 0.0)); }

}  // namespace

TEST_CASE("A rod that its support turns by half and whole turns comes where they end, free of strain",
          "[analyses][static]") {
    for (const char* element : {"objective", "simo"}) {
        for (const int k : {1, 2, 12}) {
            for (const int beside : {-1, 0, 1}) {
                for (const Vec3& axis : {Vec3(0.0, 0.0, 1.0), Vec3(1.0, 0.0, 0.0), Vec3(0.6, 0.0, 0.8)}) {
                    for (const long steps : {1L, 12L}) {
                        INFO(element << " " << k << " " << beside << " " << axis.transpose() << " " << steps);
                        const Vec3 phi = half_turns(k, beside) * axis;
                        const Model model = make_turned_rod(phi, element);
                        const StaticRun run = run_static(model, make_static_settings(steps, 1e-8));
                        CHECK((run.tip().r - exp_quaternion(phi) * Vec3(10.0, 0.0, 0.0)).norm() < 1e-10);
                        CHECK(run.tip().Lambda.angularDistance(exp_quaternion(phi)) < 1e-10);
                        CHECK(run.ledger.strain_energy < compute_energy_round_off(model));
                    }
                }
            }
        }
    }
}

TEST_CASE("A body's attitude at half and whole turns is that of the shortest vector", "[analyses]") {
    const auto attitude_after = [](double angle) {
        const Problem problem = test::read(test::body_deck,
                                           {fmt::format("body.top.rotation_vector=[0, {:.17g}, 0]", angle),
                                            "body.top.angular_velocity_material=[0.3, 1, -0.5]",
                                            "body.top.inertia=[1, 2, 2.5]"});
        return run_to_end(problem.model, test::dynamic_of(problem)).Lambda * problem.model.bodies[0].attitude;
    };
    for (const int k : {0, 1, 2, 5, 12, 100}) {
        for (const int beside : {-2, -1, 0, 1, 2}) {
            INFO(k << " " << beside);
            const Quat expected = attitude_after(k % 2 == 0 ? 0.0 : pi);
            CHECK(attitude_after(half_turns(k, beside)).angularDistance(expected) < 1e-12 * std::max(k, 1));
        }
    }
}

TEST_CASE("A step in which a body turns by half a turn is cut, one of a little less is not", "[analyses]") {
    for (const Scheme scheme : {Scheme::newmark_simplified,
                                Scheme::newmark_ibrahimbegovic,
                                Scheme::generalized_alpha,
                                Scheme::sdirk_4}) {
        for (const double turn :
             {pi * (1.0 - 1e-9), half_turns(1, 0), half_turns(1, 1), 1.5 * pi, 4.0 * pi}) {
            INFO(static_cast<int>(scheme) << " " << turn);
            const Model model = make_spinning_body(turn);
            DynamicAnalysis analysis(model, make_settings(scheme, 4.0, 4));
            REQUIRE(analysis.start().converged());
            long rejected = 0;
            while (!analysis.finished()) {
                REQUIRE(analysis.advance().converged());
                rejected += analysis.solver_row().rejected_steps;
            }
            // Of stages that is a sum, whose last digits are round-off's.
            if (scheme != Scheme::sdirk_4 || std::abs(turn - pi) > 1e-14)
                CHECK((rejected > 0) == (turn >= pi));
            const Quat expected = exp_quaternion(4.0 * turn * Vec3::UnitY());
            CHECK(analysis.state().trial[0].Lambda.angularDistance(expected) < 1e-8);
        }
    }
}

TEST_CASE("A rod that its support turns by half turns and whole turns in time ends where it should",
          "[analyses][dynamic]") {
    for (const char* integrator :
         {"newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4"}) {
        for (const char* element : {"objective", "simo"}) {
            for (const int k : {1, 2, 3, -3}) {
                INFO(integrator << " " << element << " " << k);
                const Problem problem = read_carried_rod(k, element, integrator);
                run(problem.model, test::dynamic_of(problem), [&](const DynamicAnalysis& analysis) {
                    const auto& nodes = analysis.state().trial;
                    const Quat wanted = exp_quaternion(Vec3(0.0, 0.0, k * pi * analysis.state().time));
                    CHECK(nodes.front().Lambda.angularDistance(wanted) < 1e-14);
                    // The turning stretches it by 2.4e-3 at most, and that sets it swinging.
                    CHECK((nodes.back().r - wanted * Vec3(2.0, 0.0, 0.0)).norm() < 1e-2);
                    CHECK(nodes.back().Lambda.angularDistance(wanted) < 1e-2);
                });
            }
        }
    }
}

TEST_CASE("A body that its support turns by more than half a turn in a step ends where it should",
          "[analyses][dynamic]") {
    for (const Scheme scheme : {Scheme::newmark_simplified,
                                Scheme::newmark_ibrahimbegovic,
                                Scheme::generalized_alpha,
                                Scheme::sdirk_4}) {
        for (const int k : {1, 2, 3}) {
            for (const long steps : {1L, 2L, 3L, 6L}) {
                INFO(static_cast<int>(scheme) << " " << k << " " << steps);
                Model model = make_spinning_body(0.0);
                Support support{.fixed = {true, true, true, true, true, false}};
                support.moved[5] = true;
                support.motion[5] = TimeFunction([k](double t) { return k * pi * t; });
                model.supports.push_back(support);
                model.nodes[0].angular_velocity = Vec3(0.0, 0.0, k * pi);
                DynamicAnalysis analysis(model, make_settings(scheme, 1.0, steps));
                REQUIRE(analysis.start().converged());
                long rejected = 0;
                while (!analysis.finished()) {
                    REQUIRE(analysis.advance().converged());
                    rejected += analysis.solver_row().rejected_steps;
                }
                CHECK((rejected > 0) == (k >= steps));
                const Quat wanted = exp_quaternion(Vec3(0.0, 0.0, k * pi));
                CHECK(analysis.state().trial[0].Lambda.angularDistance(wanted) < 1e-14);
                CHECK((analysis.state().trial[0].omega - Vec3(0.0, 0.0, k * pi)).norm() < 1e-12);
            }
        }
    }
}
