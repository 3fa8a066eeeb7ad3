#include "laws/layered_law.hpp"

#include <cmath>

#include "laws/law_path.hpp"
#include "laws/plastic_law.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

namespace gxrod::test {
namespace {

Mat6 bending_stiffness(double EI) {
    Vec6 diagonal;
    diagonal << 1e4, 1e4, 1e4, 10.0, EI, EI;
    return diagonal.asDiagonal();
}

// A strand that sticks up to M0: docs/verification has the same along a rod.
LayeredLaw make_strand(double slipping, double sticking, double limit) {
    return {bending_stiffness(slipping), {{StrainPart::bending, sticking - slipping, limit, 0.0}}};
}

// Moments about y over curvatures that go back and forth.
double moment_at(LawPath& path, double curvature) {
    return path.go(strain_along(4, curvature), 1.0).resultants[4];
}

}  // namespace

// M0 = 120, EI 5000 → 800, slips at 2 κs on the way back: loops 4 M0 (κa − κs) wide.
TEST_CASE("A strand's loop has the area of its friction", "[laws]") {
    const double slip_at = 120.0 / 4200.0;
    for (const double amplitude : {0.1, 0.3}) {
        const LayeredLaw strand = make_strand(800.0, 5000.0, 120.0);
        for (const int steps : {1, 7, 100}) {
            LawPath path(strand);
            path.go(strain_along(4, amplitude), 1.0, steps);
            CHECK(path.now().resultants[4] == Approx(800.0 * amplitude + 120.0).epsilon(1e-14));
            const double start = path.dissipated();
            path.go(strain_along(4, -amplitude), 1.0, steps);
            path.go(strain_along(4, amplitude), 1.0, steps);
            CHECK(path.dissipated() - start == Approx(4.0 * 120.0 * (amplitude - slip_at)).epsilon(1e-12));
        }
    }
}

// Masing's rule: from a turning point on, the curve is the first one, twice as large.
TEST_CASE("Layers follow Masing's rule", "[laws]") {
    const LayeredLaw law(bending_stiffness(50.0),
                         {{StrainPart::bending, 300.0, 30.0, 0.0},
                          {StrainPart::bending, 400.0, 80.0, 0.0},
                          {StrainPart::bending, 250.0, 100.0, 0.0}});
    const auto first = [&](double curvature) {
        LawPath path(law);
        return moment_at(path, curvature);
    };
    LawPath path(law);
    const double top = moment_at(path, 0.7);
    for (const double down : {0.01, 0.2, 0.35, 0.5, 0.8, 1.3})
        CHECK(moment_at(path, 0.7 - down) == Approx(top - 2.0 * first(0.5 * down)).epsilon(1e-12));
    const double bottom = path.now().resultants[4];
    CHECK(bottom == Approx(-first(0.6)).epsilon(1e-12));
    for (const double up : {0.02, 0.4, 0.9, 1.3})
        CHECK(moment_at(path, -0.6 + up) == Approx(bottom + 2.0 * first(0.5 * up)).epsilon(1e-12));
    // The loop is closed.
    CHECK(path.now().resultants[4] == Approx(top).epsilon(1e-12));
}

// |M| ≤ 200, EI = 1000, first about y to twice the curvature at yield 0.2, then about z by n of it: the
// moment turns as M = 200 (sech n, tanh n); radial return is of the first order in the step.
TEST_CASE("A layer's moment turns after the slip", "[laws]") {
    const Mat6 none = bending_stiffness(0.0);
    const LayeredLaw layered(none, {{StrainPart::bending, 1000.0, 200.0, 0.0}});
    const PlasticLaw plastic(bending_stiffness(1000.0),
                             {.limits = {{4, 200.0}, {5, 200.0}}, .isotropic = {}});
    for (const SectionLaw* law :
         {static_cast<const SectionLaw*>(&layered), static_cast<const SectionLaw*>(&plastic)}) {
        for (const double n : {1.0, 2.0}) {
            const auto error = [&](int steps) {
                LawPath path(*law);
                path.go(strain_along(4, 0.4), 1.0);
                const Vec6& M =
                    path.go(Vec6(strain_along(4, 0.4) + strain_along(5, 0.2 * n)), 1.0, steps).resultants;
                CHECK(std::hypot(M[4], M[5]) == Approx(200.0).epsilon(1e-13));
                return std::hypot(M[4] - 200.0 / std::cosh(n), M[5] - 200.0 * std::tanh(n)) / 200.0;
            };
            CHECK(error(1000) < 1e-3);
            CHECK(error(1000) / error(2000) == Approx(2.0).margin(0.05));
        }
    }
}

TEST_CASE("A limit grows with tension and not with compression", "[laws]") {
    const LayeredLaw law(bending_stiffness(100.0),
                         {{StrainPart::bending, 1000.0, 5.0, 0.1}, {StrainPart::tension, 2e4, 100.0, 0.0}});
    const auto layer_moment = [&](double extension) {
        LawPath path(law);
        Vec6 strain = strain_along(0, extension) + strain_along(5, 1.0);
        return path.go(strain, 1.0).resultants[5] - 100.0;
    };
    CHECK(layer_moment(0.0) == Approx(5.0).epsilon(1e-12));
    CHECK(layer_moment(-0.01) == Approx(5.0).epsilon(1e-12));
    CHECK(layer_moment(0.002) == Approx(5.0 + 0.1 * (1e4 + 2e4) * 0.002).epsilon(1e-12));
    // The layer on tension slips, too.
    CHECK(layer_moment(0.01) == Approx(5.0 + 0.1 * (1e4 * 0.01 + 100.0)).epsilon(1e-12));
}

TEST_CASE("A layer that only tension holds slips freely without it", "[laws]") {
    const LayeredLaw law(bending_stiffness(100.0), {{StrainPart::bending, 1000.0, 0.0, 0.1}});
    LawPath path(law);
    const SectionResponse& response = path.go(strain_along(4, 0.3), 1.0);
    CHECK(response.resultants[4] == Approx(30.0).epsilon(1e-14));
    CHECK(response.dissipated == 0.0);
    CHECK(tools::relative_difference(response.tangent, law.stiffness()) < 1e-15);
    // Nor does it resist where it has not slipped yet.
    CHECK(LawPath(law).look(Vec6::Zero(), 1.0).tangent == law.stiffness());
}

}  // namespace gxrod::test
