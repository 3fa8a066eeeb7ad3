// Rotations of exactly half turns and whole turns, and of a few units of the last place more or less.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "deck/decks.hpp"
#include "model/energy_round_off.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/run.hpp"
#include "tools/static_run.hpp"
#include "tools/tops.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double pi = std::numbers::pi;

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

// A body that turns about its second axis, for four steps of 1.
Model make_spinning_body(double rate) { return make_free_body(Vec3(1.0, 2.0, 4.0), Vec3(0.0, rate, 0.0)); }

}  // namespace

TEST_CASE("A rod that its support turns by half and whole turns comes where they end, free of strain",
          "[analyses][static]") {
    for (const char* element : {"objective", "simo"}) {
        for (const int k : {1, 2, 3, 12}) {
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
    for (const Scheme scheme :
         {Scheme::newmark_simplified, Scheme::newmark_ibrahimbegovic, Scheme::generalized_alpha}) {
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
            CHECK((rejected > 0) == (turn >= pi));
            const Quat expected = exp_quaternion(4.0 * turn * Vec3::UnitY());
            CHECK(analysis.state().trial[0].Lambda.angularDistance(expected) < 1e-8);
        }
    }
}
