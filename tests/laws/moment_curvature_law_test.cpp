#include "laws/moment_curvature_law.hpp"

#include <cmath>

#include "laws/law_path.hpp"
#include "laws/layered_law.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const PiecewiseLine curve({{0.0, 0.0}, {0.02, 2500.0}, {0.1, 5000.0}, {0.3, 6000.0}});
const Mat6 C = Vec6(1e6, 1e5, 1e5, 1e4, 1.0, 2.0).asDiagonal();

// Read off by hand: the last slope is 5000.
double moment_of(double curvature) {
    if (curvature < 0.02) return 125000.0 * curvature;
    if (curvature < 0.1) return 2500.0 + 31250.0 * (curvature - 0.02);
    return 5000.0 + 5000.0 * (curvature - 0.1);
}

}  // namespace

TEST_CASE("A curve's moment is along the curvature, and goes on with the last slope", "[laws]") {
    const MomentCurvatureLaw law(C, {{StrainPart::bending, curve}});
    LawPath path(law);
    for (const double size : {0.001, 0.02, 0.05, 0.2, 0.29, 0.31, 4.0}) {
        const Vec6 strain = Vec6(0.1, 0.2, 0.3, 0.4, 0.6 * size, -0.8 * size);
        const Vec6 S = path.go(strain, 1.0).resultants;
        CHECK(S[4] == Approx(0.6 * moment_of(size)).epsilon(1e-13));
        CHECK(S[5] == Approx(-0.8 * moment_of(size)).epsilon(1e-13));
        CHECK(S.head<4>() == Eigen::Vector4d(C.diagonal().head<4>().cwiseProduct(strain.head<4>())));
    }
    CHECK(path.dissipated() == 0.0);
}

TEST_CASE("Curves of each axis do not know of each other", "[laws]") {
    const MomentCurvatureLaw law(C, {{StrainPart::bending_z, curve}});
    LawPath path(law);
    const Vec6 S = path.go(Vec6(strain_along(4, 0.3) + strain_along(5, -0.05)), 1.0).resultants;
    CHECK(S[4] == 1.0 * 0.3);
    CHECK(S[5] == Approx(-moment_of(0.05)).epsilon(1e-13));
}

TEST_CASE("A kinematic curve is the given one at first and Masing's after", "[laws]") {
    const auto law = make_kinematic_law(C, {{StrainPart::bending, curve}});
    LawPath path(*law);
    for (const double size : {0.001, 0.02, 0.05, 0.2, 0.31, 0.5}) {
        const Vec6 S =
            path.go(Vec6(strain_along(4, 0.6 * size) + strain_along(5, 0.8 * size)), 1.0).resultants;
        CHECK(S[4] == Approx(0.6 * moment_of(size)).epsilon(1e-12));
        CHECK(S[5] == Approx(0.8 * moment_of(size)).epsilon(1e-12));
    }
    for (const double drop : {0.01, 0.1, 0.3, 0.7}) {
        const double size = 0.5 - drop;
        const Vec6 S =
            path.go(Vec6(strain_along(4, 0.6 * size) + strain_along(5, 0.8 * size)), 1.0).resultants;
        CHECK(0.6 * S[4] + 0.8 * S[5] == Approx(moment_of(0.5) - 2.0 * moment_of(0.5 * drop)).epsilon(1e-12));
    }
    CHECK(path.dissipated() > 0.0);
}

TEST_CASE("Rising slopes are found", "[laws]") {
    CHECK_FALSE(find_rising_slope(curve));
    CHECK(find_rising_slope(PiecewiseLine({{0.0, 0.0}, {1.0, 1.0}, {2.0, 1.5}, {3.0, 2.5}})) == 2);
}

}  // namespace gxrod::test
