#include "cross_section/strength/section_fibres.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cross_section/cross_section.hpp"
#include "cross_section/examination/raised_order.hpp"
#include "cross_section/heat/heat_strains.hpp"
#include "cross_section/plastic_capacity.hpp"
#include "cross_section/section_meshes.hpp"
#include "cross_section/strength/section_exposure.hpp"
#include "tools/catch.hpp"

namespace gxrod {
namespace {

using std::numbers::pi;

ElasticMaterial steel(double yield_stress) {
    ElasticMaterial material = isotropic(1.0, 0.3);
    material.yield_stress = yield_stress;
    return material;
}

// Area, centre and second moments as a matrix of 1, y and z by pairs.
Mat3 sum_moments(const std::vector<SectionFibre>& fibres, int material) {
    Mat3 sum = Mat3::Zero();
    for (const SectionFibre& fibre : fibres) {
        if (fibre.material != material) continue;
        const Vec3 monomials(1.0, fibre.at.x(), fibre.at.y());
        sum += fibre.area * monomials * monomials.transpose();
    }
    return sum;
}

Mat3 sum_moments(const SectionQuadrature& quadrature, int material) {
    Mat3 sum = Mat3::Zero();
    for (const CellPoints& cell : quadrature.cells()) {
        if (quadrature.mesh().layers[static_cast<std::size_t>(cell.cell->layer)].material != material)
            continue;
        for (std::size_t q = 0; q < cell.at.size(); ++q) {
            const Vec3 monomials(1.0, cell.at[q].x(), cell.at[q].y());
            sum += cell.weights[q] * monomials * monomials.transpose();
        }
    }
    return sum;
}

// ∫ |x − x₀| dA of a coordinate about the line that halves the area.
double find_plastic_modulus(std::vector<SectionFibre> fibres, int axis) {
    std::ranges::sort(fibres, {}, [axis](const SectionFibre& fibre) { return fibre.at[axis]; });
    double total = 0.0, below = 0.0, modulus = 0.0;
    for (const SectionFibre& fibre : fibres) total += fibre.area;
    for (const SectionFibre& fibre : fibres) {
        const double upper = std::clamp(below + fibre.area - 0.5 * total, 0.0, fibre.area);
        modulus += fibre.at[axis] * (2.0 * upper - fibre.area);
        below += fibre.area;
    }
    return modulus;
}

}  // namespace

TEST_CASE("Fibres of a section have its area and second moments, and its plastic moments to 2.2e-3",
          "[cross_section]") {
    const std::vector<ElasticMaterial> materials{steel(1.0)};
    for (const SectionMesh& mesh : {make_rectangle(1.0, 2.0, {4, 8, 3}),
                                    make_rectangle(1.0, 0.01, {60, 4, 2}),
                                    cut_into_triangles(make_rectangle(0.01, 1.0, {4, 100, 3})),
                                    make_ring({1.0, 0.9, 0.0, 2.0 * pi, true}, {24, 1, 3}),
                                    make_ring({0.1, 0.09, 0.3, 3.9, false}, {20, 2, 3})}) {
        const SectionQuadrature quadrature(mesh, materials);
        const std::vector<SectionFibre> fibres = make_section_fibres(quadrature);
        CHECK(fibres.size() == 512);
        const Mat3 exact = sum_moments(quadrature, 0), found = sum_moments(fibres, 0);
        CHECK((found - exact).cwiseAbs().maxCoeff() < 1e-13 * exact.cwiseAbs().maxCoeff());
        const PlasticCapacity capacity = *compute_plastic_capacity(quadrature);
        CHECK(find_plastic_modulus(fibres, 1) == Approx(capacity.moment_y).epsilon(2.2e-3));
        CHECK(find_plastic_modulus(fibres, 0) == Approx(capacity.moment_z).epsilon(2.2e-3));
    }
}

TEST_CASE("Fibres of two materials have the moments of each", "[cross_section]") {
    SectionMesh mesh = make_rectangle(0.4, 1.0, {4, 8, 3});
    mesh.layers.push_back({.name = "upper", .material = 1, .fibre_angle = 0.0});
    for (SectionCell& cell : mesh.cells) {
        if (mesh.nodes[static_cast<std::size_t>(cell.nodes[5])].y() > 0.25) cell.layer = 1;
    }
    const std::vector<ElasticMaterial> materials{steel(1.0), steel(5.0)};
    const SectionQuadrature quadrature(mesh, materials);
    const std::vector<SectionFibre> fibres = make_section_fibres(quadrature);
    for (const int material : {0, 1}) {
        const Mat3 exact = sum_moments(quadrature, material);
        CHECK((sum_moments(fibres, material) - exact).cwiseAbs().maxCoeff() < 1e-14);
    }
    const PlasticCapacity capacity = *compute_plastic_capacity(quadrature);
    CHECK(capacity.centre.y() == Approx((0.75 * -0.125 + 1.25 * 0.375) / (0.75 + 1.25)));
}

TEST_CASE("An order more leaves a section what it is", "[cross_section]") {
    for (const SectionMesh& mesh : {make_ring({0.1, 0.05, 0.3, 3.9, false}, {12, 3, 2}),
                                    make_ring({0.1, 0.05, 0.0, 2.0 * pi, true}, {16, 3, 3}),
                                    cut_into_triangles(make_rectangle(1.0, 2.0, {5, 8, 3}))}) {
        const auto before = compute_cross_section("s", mesh, {isotropic(1.0, 0.3)});
        const auto after = compute_cross_section("s", raise_order(mesh), {isotropic(1.0, 0.3)});
        CHECK(after->mesh.cells.front().order == mesh.cells.front().order + 1);
        const Mat6 &a = before->properties.stiffness, &b = after->properties.stiffness;
        const Vec6 scale = a.diagonal().cwiseSqrt();
        const double change = ((a - b).array() / (scale * scale.transpose()).array()).abs().maxCoeff();
        CHECK(change > 0.0);
        CHECK(change < 1e-3);
        CHECK(after->properties.area == Approx(before->properties.area).epsilon(1e-12));
    }
}

TEST_CASE("A temperature that rises across a section bends it, wherever its origin is", "[cross_section]") {
    ElasticMaterial metal = isotropic(2.0, 0.3);
    metal.expansion.head<3>().setConstant(12e-6);
    SectionMesh mesh = make_rectangle(0.4, 1.0, {4, 6, 3});
    for (PlanePoint& node : mesh.nodes) node += PlanePoint(0.3, -0.7);
    const auto section = compute_cross_section("s", mesh, {metal});
    Eigen::Matrix<double, 6, 2> expected = Eigen::Matrix<double, 6, 2>::Zero();
    expected(5, 0) = -12e-6;
    expected(4, 1) = 12e-6;
    CHECK((section->gradient_strains - expected).cwiseAbs().maxCoeff() < 1e-16);
    CHECK(find_even_expansion(*section) == 12e-6);
}

TEST_CASE("A section is as near to failure as its worst point", "[cross_section]") {
    const auto section = compute_cross_section("s", make_rectangle(0.1, 0.2, {4, 8, 3}), {steel(300.0)});
    const Vec6 resultants(0.0, 0.0, 0.0, 0.0, 0.1, 0.0);
    const std::vector<SectionExposure> found = find_exposures(*section, resultants);
    REQUIRE(found.size() == 1);
    CHECK(found[0].criterion->word == "von-mises");
    CHECK(found[0].exposure == Approx(0.1 / (0.1 * 0.04 / 6.0) / 300.0).epsilon(1e-8));
    CHECK(std::abs(found[0].point->at.y()) == Approx(0.1));
}

}  // namespace gxrod
