#include "laws/viscoelastic_law.hpp"

#include <cmath>
#include <limits>

#include "laws/law_path.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

namespace gxrod::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Mat6 bending(double EI) { return Vec6(1e3, 1e3, 1e3, 10.0, EI, EI).asDiagonal(); }

}  // namespace

// EI = 100, C(t) = C (1 + 0.5 e^(−t/0.2) + 0.3 e^(−t/2)): the curvature goes to 0.8 in 0.5 and is held.
TEST_CASE("A ramp that is held relaxes exactly, by steps of any length", "[laws]") {
    const ViscoelasticLaw law(bending(100.0), {{0.5, 0.2}, {0.3, 2.0}});
    const auto exact = [](double t) {
        double moment = 100.0 * 1.6 * std::min(t, 0.5);
        for (const auto& [r, tau] : {std::pair(0.5, 0.2), std::pair(0.3, 2.0)}) {
            const double pulled = 160.0 * r * tau * (1.0 - std::exp(-std::min(t, 0.5) / tau));
            moment += pulled * std::exp(-std::max(t - 0.5, 0.0) / tau);
        }
        return moment;
    };
    for (const int steps : {1, 3, 50}) {
        LawPath path(law);
        const auto moment = [&](double curvature, double elapsed) {
            return path.go(strain_along(4, curvature), elapsed, steps).resultants[4];
        };
        CHECK(moment(0.4, 0.25) == Approx(exact(0.25)).epsilon(1e-13));
        CHECK(moment(0.8, 0.25) == Approx(exact(0.5)).epsilon(1e-13));
        CHECK(moment(0.8, 0.5) == Approx(exact(1.0)).epsilon(1e-13));
        CHECK(moment(0.8, 2.0) == Approx(exact(3.0)).epsilon(1e-13));
        CHECK(moment(0.8, infinite) == Approx(80.0).epsilon(1e-14));
    }
    // As computed elsewhere, with 15 digits.
    CHECK(exact(0.25) == Approx(62.6962206021158).epsilon(1e-13));
    CHECK(exact(3.0) == Approx(86.0840198563426).epsilon(1e-13));
}

// EI = 100 with one branch (0.5, 1); the moment goes to 60 in 0.5 and is held. Its compliance is
// J(t) = (1 − (1/3) e^(−t/1.5))/100.
TEST_CASE("A held moment creeps, with an error of the second order in the step", "[laws]") {
    const ViscoelasticLaw law(bending(100.0), {{0.5, 1.0}});
    const auto creep = [&](int steps) {
        LawPath path(law);
        double curvature = 0.0;
        for (int i = 1; i <= steps; ++i) {
            const double moment = 60.0 * std::min(3.0 * i / steps / 0.5, 1.0);
            const SectionResponse guess = path.look(strain_along(4, curvature), 3.0 / steps);
            curvature += (moment - guess.resultants[4]) / guess.tangent(4, 4);
            path.go(strain_along(4, curvature), 3.0 / steps);
        }
        return curvature;
    };
    const auto ramp = [](double t) { return 120.0 / 100.0 * (t - 0.5 * (1.0 - std::exp(-t / 1.5))); };
    const double exact = ramp(3.0) - ramp(2.5);
    CHECK(exact == Approx(0.567875808239431).epsilon(1e-13));
    const double coarse = std::abs(creep(60) - exact);
    const double fine = std::abs(creep(120) - exact);
    CHECK(fine < 1e-5);
    CHECK(coarse / fine == Approx(4.0).margin(0.1));
}

// Strain is linear within a step, so that parts of it change nothing, and energies are exact.
TEST_CASE("Steps and their parts give the same resultants and energies", "[laws]") {
    const ViscoelasticLaw law(some_stiffness(), {{0.5, 0.2}, {0.3, 2.0}, {0.7, 1e4}, {0.4, 1e-4}});
    const auto run = [&](int parts) {
        LawPath path(law);
        path.go(Vec6(0.1, -0.2, 0.05, 0.3, 0.2, -0.1), 0.7, parts);
        path.go(Vec6(-0.1, 0.1, 0.0, 0.2, -0.4, 0.3), 1e-3, parts);
        path.go(Vec6(0.2, 0.1, 0.3, -0.3, 0.1, 0.2), 5.0, parts);
        return path;
    };
    const LawPath once = run(1);
    for (const int parts : {2, 13, 500}) {
        const LawPath often = run(parts);
        CHECK(often.now().resultants.isApprox(once.now().resultants, 1e-12));
        CHECK(often.now().stored == Approx(once.now().stored).epsilon(1e-12));
        CHECK(often.dissipated() == Approx(once.dissipated()).epsilon(1e-12));
    }
    const LawPath fine = run(20000);
    CHECK(fine.work() == Approx(once.now().stored + once.dissipated()).epsilon(1e-5));
}

// Both sides of where the series takes over from the closed form.
TEST_CASE("Energies have no step where their formula changes", "[laws]") {
    const ViscoelasticLaw law(bending(1.0), {{1.0, 1.0}});
    const auto dissipated = [&](double elapsed) {
        LawPath path(law);
        path.go(strain_along(4, 0.3), 0.1);
        return path.go(strain_along(4, 0.9), elapsed).dissipated;
    };
    const double below = dissipated(0.5 * (1.0 - 1e-9));
    const double above = dissipated(0.5 * (1.0 + 1e-9));
    CHECK(std::abs(above - below) < 1e-8 * below);
    // x/3 of the square of the change, and what the branch has already.
    CHECK(dissipated(1e-12) ==
          Approx(1e-12 * (0.36 / 3.0 + 0.6 * 0.3 * 0.95162581964040 + 0.0815070155)).epsilon(1e-4));
}

TEST_CASE("Branches on some strains leave the others elastic", "[laws]") {
    const Mat6 C = some_stiffness();
    const ViscoelasticLaw law(C, {{2.0, 1.0}}, {StrainPart::bending});
    LawPath path(law);
    const Vec6 strain(0.1, 0.2, 0.3, 0.4, 0.5, 0.6);
    const Vec6 S = path.go(strain, 0.0).resultants;
    Vec6 bent = Vec6::Zero();
    bent.tail<2>() = strain.tail<2>();
    Vec6 expected = C * strain;
    expected.tail<2>() += 2.0 * (C * bent).tail<2>();
    CHECK(S.isApprox(expected, 1e-14));
}

// Over no time the branches answer with their whole stiffness, over infinite time not at all, and what they
// had stored is dissipated.
TEST_CASE("Branches are stiff at once and gone in the end", "[laws]") {
    const Mat6 C = some_stiffness();
    const ViscoelasticLaw law(C, {{0.5, 1.0}, {0.25, 3.0}});
    LawPath path(law);
    const Vec6 strain(0.1, 0.2, 0.3, 0.4, 0.5, 0.6);
    const SectionResponse at_once = path.go(strain, 0.0);
    CHECK(at_once.resultants.isApprox(1.75 * C * strain, 1e-14));
    CHECK(at_once.tangent.isApprox(1.75 * C, 1e-14));
    CHECK(at_once.dissipated == 0.0);
    const SectionResponse after_all = path.go(strain, infinite);
    CHECK(after_all.resultants == Vec6(C * strain));
    CHECK(after_all.tangent == C);
    CHECK(after_all.dissipated == Approx(at_once.stored - after_all.stored).epsilon(1e-13));
}

}  // namespace gxrod::test
