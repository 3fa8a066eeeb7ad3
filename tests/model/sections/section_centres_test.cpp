#include "model/sections/section_centres.hpp"

#include <cmath>

#include "model/sections/section_frame.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

Mat6 diagonal(double a, double b, double c, double d, double e, double f) {
    Mat6 matrix = Mat6::Zero();
    matrix.diagonal() << a, b, c, d, e, f;
    return matrix;
}

const Mat6 no_mass = Mat6::Zero();

}  // namespace

TEST_CASE("a section about its centroid has its centres there", "[model][sections]") {
    const SectionCentres centres(diagonal(100, 40, 30, 5, 6, 7), diagonal(2, 2, 2, 0.3, 0.1, 0.2));
    CHECK(centres.tension_centre().norm() == 0.0);
    CHECK(centres.shear_centre().norm() == 0.0);
    CHECK(centres.centre_of_mass()->norm() == 0.0);
    CHECK(centres.bending().turn == 0.0);
    CHECK(centres.bending().about_y == Approx(6.0).epsilon(1e-14));
    CHECK(centres.bending().about_z == Approx(7.0).epsilon(1e-14));
    CHECK(centres.inertia()->about_y == Approx(0.1).epsilon(1e-14));
    CHECK(centres.size() == Approx(std::sqrt(0.07)).epsilon(1e-14));
    CHECK_FALSE(SectionCentres(diagonal(1, 1, 1, 1, 1, 1), no_mass).centre_of_mass());
}

TEST_CASE("centres and axes are found wherever a section is moved", "[model][sections]") {
    for (const double turn : {0.3, -0.7, 0.0, 0.78}) {
        const SectionFrame frame{0.7, -0.3, turn};
        const Mat6 stiffness = move_from(frame, diagonal(100, 40, 30, 5, 6, 7));
        const Mat6 mass = move_from(frame, diagonal(2, 2, 2, 0.3, 0.1, 0.2));
        const SectionCentres centres(stiffness, mass);
        for (const SectionPoint& point :
             {centres.tension_centre(), centres.shear_centre(), *centres.centre_of_mass()}) {
            CHECK(point.x() == Approx(0.7).epsilon(1e-12));
            CHECK(point.y() == Approx(-0.3).epsilon(1e-12));
        }
        CHECK(centres.bending().turn == Approx(turn).margin(1e-12));
        CHECK(centres.bending().about_y == Approx(6.0).epsilon(1e-12));
        CHECK(centres.bending().about_z == Approx(7.0).epsilon(1e-12));
        CHECK(centres.inertia()->turn == Approx(turn).margin(1e-12));
        CHECK(centres.inertia()->about_y == Approx(0.1).epsilon(1e-12));
    }
}

TEST_CASE("a channel has its shear centre apart from its tension centre", "[model][sections]") {
    // Stretching and bending about one point, shear and torsion about another.
    const Mat6 about_tension = move_from({0.2, 0.1, 0.0}, diagonal(100, 1e-9, 1e-9, 1e-9, 6, 7));
    const Mat6 about_shear = move_from({-0.4, 0.3, 0.0}, diagonal(1e-9, 40, 30, 5, 1e-9, 1e-9));
    const SectionCentres centres(about_tension + about_shear, no_mass);
    CHECK(centres.tension_centre().isApprox(SectionPoint(0.2, 0.1), 1e-8));
    CHECK(centres.shear_centre().isApprox(SectionPoint(-0.4, 0.3), 1e-8));
    CHECK(centres.bending().about_y == Approx(6.0).epsilon(1e-8));
    CHECK(centres.bending().about_z == Approx(7.0).epsilon(1e-8));
}

TEST_CASE("forces at the centres of any section do not couple", "[model][sections]") {
    Mat6 root;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) root(i, j) = std::sin(1.0 + 7.0 * i + 3.0 * j * j);
    }
    const Mat6 stiffness = root * root.transpose() + Mat6::Identity();
    const SectionCentres centres(stiffness, no_mass);
    const auto strains = [&](const Vec3& force, const SectionPoint& at) {
        Vec6 resultants;
        resultants << force, Vec3(0.0, at.x(), at.y()).cross(force);
        return Vec6(stiffness.inverse() * resultants);
    };
    const Vec6 pulled = strains(Vec3::UnitX(), centres.tension_centre());
    CHECK(std::abs(pulled[4]) < 1e-13);
    CHECK(std::abs(pulled[5]) < 1e-13);
    CHECK(std::abs(strains({0.0, 2.0, -3.0}, centres.shear_centre())[3]) < 1e-13);
    // A moment about a principal axis bends about that axis alone.
    const double turn = centres.bending().turn;
    REQUIRE(turn != 0.0);
    CHECK(std::abs(turn) <= M_PI / 4.0 + 1e-12);
    const Eigen::Vector2d axis(std::cos(turn), std::sin(turn));
    Vec6 moment = Vec6::Zero();
    moment.tail<2>() = axis;
    const Eigen::Vector2d curvature = (stiffness.inverse() * moment).tail<2>();
    CHECK((curvature * centres.bending().about_y).isApprox(axis, 1e-12));
}

}  // namespace gxrod::test
