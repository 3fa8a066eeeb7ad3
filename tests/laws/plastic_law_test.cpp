#include "laws/plastic_law.hpp"

#include <cmath>
#include <limits>

#include "laws/law_path.hpp"
#include "laws/layered_law.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

namespace gxrod::test {
namespace {

const std::vector<std::pair<int, double>> axial_and_moments{{0, 3.0}, {4, 0.5}, {5, 0.7}};

double size_of(const Vec6& S, const std::vector<std::pair<int, double>>& limits) {
    double sum = 0.0;
    for (const auto& [i, limit] : limits) sum += std::pow(S[i] / limit, 2);
    return std::sqrt(sum);
}

Vec6 random_strain(tools::RandomValues& random, double size) { return size * random.matrix<6, 1>(); }

}  // namespace

TEST_CASE("Resultants do not leave the yield surface, and reach it where they yield", "[laws]") {
    const PlasticLaw law(some_stiffness(), {.limits = axial_and_moments, .isotropic = {}});
    tools::RandomValues random(1);
    LawPath path(law);
    int yielded = 0;
    // A trial far outside the surface leaves its round-off.
    const double round_off = 8.0 * std::numeric_limits<double>::epsilon() *
                             size_of(some_stiffness().cwiseAbs() * Vec6::Constant(30.0), axial_and_moments);
    for (int i = 0; i < 300; ++i) {
        const SectionResponse& response = path.go(random_strain(random, i % 3 == 0 ? 30.0 : 0.5), 1.0);
        const double size = size_of(response.resultants, axial_and_moments);
        CHECK(size <= 1.0 + round_off);
        if (response.dissipated == 0.0) continue;
        ++yielded;
        CHECK(size >= 1.0 - round_off);
    }
    CHECK(yielded > 150);
}

// Among all resultants within the surface that of the return is nearest in the energy norm: no other one
// within it, taken at random, is nearer.
TEST_CASE("A return finds the closest point", "[laws]") {
    const Mat6 C = some_stiffness();
    const Mat6 compliance = C.inverse();
    const PlasticLaw law(C, {.limits = axial_and_moments, .isotropic = {}});
    tools::RandomValues random(4);
    for (int i = 0; i < 50; ++i) {
        LawPath path(law);
        const Vec6 strain = random_strain(random, 1.0);
        const Vec6 S = path.go(strain, 1.0).resultants;
        const auto distance = [&](const Vec6& other) -> double {
            const Vec6 from = C * strain - other;
            return from.dot(compliance * from);
        };
        for (int j = 0; j < 50; ++j) {
            Vec6 other = S + random_strain(random, j % 2 == 0 ? 1.0 : 1e-3);
            const double size = size_of(other, axial_and_moments);
            if (size > 1.0) {
                for (const auto& [k, limit] : axial_and_moments) other[k] /= size;
            }
            CHECK(distance(other) >= distance(S) * (1.0 - 1e-12));
        }
    }
}

// N²/Np² + M²/Mp² = 1: stretched to n Np and bent far, M → Mp √(1 − n²) where N is held by the strains.
TEST_CASE("Axial force takes from the moment as the ellipse says", "[laws]") {
    const Mat6 C = Vec6(100.0, 50.0, 50.0, 2.0, 4.0, 4.0).asDiagonal();
    const PlasticLaw law(C, {.limits = {{0, 10.0}, {4, 1.0}}, .isotropic = {}});
    LawPath path(law);
    path.go(strain_along(0, 0.06), 1.0);
    CHECK(path.now().resultants[0] == Approx(6.0).epsilon(1e-14));
    // One large step: the closest point, by an independent search along the ellipse.
    const Vec6 strain = strain_along(0, 0.06) + strain_along(4, 0.5);
    const Vec6 S = path.go(strain, 1.0).resultants;
    double best = 1e9, angle = 0.0;
    for (int i = 0; i <= 1000000; ++i) {
        const double a = 0.5 * M_PI * i / 1000000;
        const double distance =
            std::pow(6.0 - 10.0 * std::sin(a), 2) / 100.0 + std::pow(2.0 - std::cos(a), 2) / 4.0;
        if (distance < best) {
            best = distance;
            angle = a;
        }
    }
    CHECK(S[0] == Approx(10.0 * std::sin(angle)).epsilon(1e-5));
    CHECK(S[4] == Approx(std::cos(angle)).epsilon(1e-5));
}

// EI = 1000, My = 500, then a slope of 100: docs/verification has the same along a rod.
TEST_CASE("A bilinear section hardens kinematically and isotropically as it should", "[laws]") {
    const Mat6 C = Vec6(1e6, 4e5, 4e5, 1e3, 1000.0, 1000.0).asDiagonal();
    const double hardening = 1.0 / 9.0;  // 1000 h/(1 + h) = 100
    const PlasticLaw kinematic(C, {.limits = {{4, 500.0}}, .isotropic = {}, .kinematic = hardening});
    const PlasticLaw isotropic(
        C, {.limits = {{4, 500.0}}, .isotropic = PiecewiseLine({{0.0, 1.0}, {1.0, 1.0 + hardening}})});
    const double top = 500.0 + 100.0 * (1.2 - 0.5);
    LawPath moving(kinematic), growing(isotropic);
    CHECK(moving.go(strain_along(4, 1.2), 1.0).resultants[4] == Approx(top).epsilon(1e-13));
    CHECK(growing.go(strain_along(4, 1.2), 1.0).resultants[4] == Approx(top).epsilon(1e-13));
    // Back: kinematic yields after 2 My, isotropic at −top.
    CHECK(moving.go(strain_along(4, -0.8), 1.0).resultants[4] ==
          Approx(top - 1000.0 - 100.0 * (2.0 - 1.0)).epsilon(1e-13));
    CHECK(growing.go(strain_along(4, -0.8), 1.0).resultants[4] ==
          Approx(-top - 100.0 * (2.0 - 2.0 * top / 1000.0)).epsilon(1e-13));
    // What is dissipated is the first limit times the plastic curvature gone through.
    const double gone = (1.2 - 0.5) * 0.9 + 0.9 * (2.0 - 1.0);
    CHECK(moving.dissipated() == Approx(500.0 * gone).epsilon(1e-12));
    // A layer does what kinematic hardening does.
    Mat6 beyond = C;
    beyond(4, 4) = 100.0;
    const LayeredLaw layered(beyond, {{StrainPart::bending_y, 900.0, 450.0, 0.0}});
    LawPath path(layered);
    path.go(strain_along(4, 1.2), 1.0);
    CHECK(path.go(strain_along(4, -0.8), 1.0).resultants[4] ==
          Approx(moving.now().resultants[4]).epsilon(1e-13));
    CHECK(path.dissipated() == Approx(moving.dissipated()).epsilon(1e-12));
    CHECK(path.now().stored == Approx(moving.now().stored).epsilon(1e-12));
}

// In one dimension steps of any size are exact: so is the balance of work by the exact path.
TEST_CASE("Stored and dissipated energies of one yielding resultant do not depend on the steps", "[laws]") {
    const PlasticLaw law(some_stiffness(),
                         {.limits = {{3, 0.4}},
                          .isotropic = PiecewiseLine({{0.0, 1.0}, {0.5, 1.2}, {3.0, 1.3}}),
                          .kinematic = 0.1});
    const auto run = [&](int steps) {
        LawPath path(law);
        for (const double twist : {1.5, -0.7, 0.9}) path.go(strain_along(3, twist), 1.0, steps);
        return path;
    };
    const LawPath coarse = run(1);
    const LawPath fine = run(4000);
    CHECK(coarse.now().resultants.isApprox(fine.now().resultants, 1e-11));
    CHECK(coarse.now().stored == Approx(fine.now().stored).epsilon(1e-11));
    CHECK(coarse.dissipated() == Approx(fine.dissipated()).epsilon(1e-11));
    CHECK(fine.work() == Approx(fine.now().stored + fine.dissipated()).epsilon(1e-6));
}

TEST_CASE("Resultants without interaction yield each by itself", "[laws]") {
    const Mat6 C = some_stiffness({0, 4, 5});
    const PlasticLaw law(
        C, {.limits = axial_and_moments, .interaction = YieldInteraction::none, .isotropic = {}});
    LawPath path(law);
    const Vec6 strain(2.0, 0.1, 0.1, 0.1, 0.01, -3.0);
    const Vec6 S = path.go(strain, 1.0).resultants;
    CHECK(S[0] == Approx(3.0).epsilon(1e-14));
    CHECK(S[4] == Approx(C(4, 4) * 0.01).epsilon(1e-14));
    CHECK(S[5] == Approx(-0.7).epsilon(1e-14));
    CHECK(S.segment<3>(1).isApprox((C * strain).segment<3>(1), 1e-14));
}

}  // namespace gxrod::test
