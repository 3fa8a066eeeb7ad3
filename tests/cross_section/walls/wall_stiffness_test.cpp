#include <cmath>
#include <utility>

#include "cross_section/walls/sample_walls.hpp"
#include "cross_section/walls/solid_meshes.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

// Reference values of prismatic bars: see docs/theory/sections.md. The tolerances are what the default mesh
// reaches, 1e-4 at most, rounded up.
TEST_CASE("A square of two materials has the reference stiffness", "[cross_section]") {
    const WallOutline strip{.corners = {{{0.0, -0.05}}, {{0.0, 0.05}}}, .layups = {0}};
    const SectionMesh mesh = mesh_walls(strip, {{"halves", {{0, 0.05, 0.0}, {1, 0.05, 0.0}}}});
    const Mat6 K = solve(mesh, {make_isotropic(10.0, 0.2), make_isotropic(100.0, 0.2)}).stiffness;
    CHECK(find_worst_entry(K,
                           {{1, 1, 0.55},
                            {1, 6, 0.01125},
                            {2, 2, 0.12631771},
                            {3, 3, 0.19061423},
                            {3, 4, -0.0038989274},
                            {4, 4, 2.7395315e-4},
                            {5, 5, 4.5833333e-4},
                            {6, 6, 4.5833333e-4},
                            {1, 5, 0.0},
                            {2, 4, 0.0}}) < 1e-5);
}

TEST_CASE("An orthotropic square has the reference stiffness", "[cross_section]") {
    SectionMesh mesh = mesh_rectangle(0.1, 0.1);
    mesh.layers[0].fibre_angle = 22.5 * degree;
    const ElasticMaterial wood = make_orthotropic({480.0, 120.0, 120.0, 60.0, 50.0, 60.0, 0.19, 0.19, 0.26});
    CHECK(find_worst_entry(solve(mesh, {wood}).stiffness,
                           {{1, 1, 3.4271267},
                            {1, 2, 0.73160405},
                            {2, 2, 0.75342845},
                            {3, 3, 0.40979254},
                            {4, 4, 9.4168816e-4},
                            {4, 5, -4.5720525e-4},
                            {5, 5, 2.4859098e-3},
                            {6, 6, 2.2639290e-3}}) < 1e-5);
}

TEST_CASE("A pipe of plies whose axes turn has the reference stiffness", "[cross_section]") {
    const SampleWalls pipe = make_pipe();
    CHECK(find_worst_entry(solve(pipe.mesh(), pipe.materials).stiffness,
                           {{1, 1, 10388591},
                            {1, 4, 98519.7},
                            {2, 2, 785267.4},
                            {2, 5, -8234.3},
                            {3, 3, 329035},
                            {3, 6, -52084},
                            {4, 4, 687073},
                            {5, 5, 1882278},
                            {6, 6, 5389347},
                            {1, 2, 0.0},
                            {2, 3, 0.0}}) < 1e-4);
}

TEST_CASE("A box of plies has the reference stiffness", "[cross_section]") {
    const auto stiffness_of = [](const std::vector<double>& degrees) {
        const SampleWalls box = make_box(degrees);
        return solve(box.mesh(), box.materials).stiffness;
    };
    CHECK(find_worst_entry(stiffness_of({15, 15, 15, 15, 15, 15}),
                           {{1, 1, 1437379.5},
                            {1, 4, 107400.6},
                            {2, 2, 90118},
                            {2, 5, -52009.6},
                            {3, 3, 39278.5},
                            {3, 6, -56335.0},
                            {4, 4, 16765.6},
                            {5, 5, 66188.0},
                            {6, 6, 172493.4}}) < 1e-4);
    CHECK(find_worst_entry(stiffness_of({0, 0, 0, 0, 0, 0}),
                           {{1, 1, 1757974.2},
                            {2, 2, 44391.5},
                            {3, 3, 18612.1},
                            {4, 4, 7970.6},
                            {5, 5, 84360.4},
                            {6, 6, 212814.7},
                            {1, 4, 0.0}}) < 1e-4);
    CHECK(find_worst_entry(stiffness_of({-30, 0, -30, 0, -30, 0}),
                           {{1, 1, 1243634},
                            {1, 4, -55316},
                            {2, 2, 98119},
                            {2, 5, 27416.2},
                            {3, 3, 40848.7},
                            {3, 6, 28526.1},
                            {4, 4, 18102.3},
                            {5, 5, 58773.5},
                            {6, 6, 149570}}) < 1e-4);
}

namespace {

// A strip, width 20, of four plies .25 thick, about its middle.
SampleWalls make_strip(const std::vector<double>& degrees) {
    Layup layup{.name = "strip", .plies = {}};
    for (const double angle : degrees) layup.plies.push_back({0, 0.25, angle * degree});
    return {{.corners = {{{-10.0, 0.0}}, {{10.0, 0.0}}}, .layups = {0}},
            {layup},
            {make_orthotropic({140e9, 10e9, 10e9, 5e9, 5e9, 3.5e9, 0.3, 0.3, 0.4})}};
}

// The stress of some resultants at the node of a layer nearest to a point.
Vec6 find_stress(const SampleWalls& walls, const Vec6& resultants, int layer, const PlanePoint& at) {
    const SectionMesh mesh = walls.mesh();
    const SectionQuadrature quadrature(mesh, walls.materials);
    const CentralSolutions solutions = solve_section(quadrature);
    double nearest = 1e300;
    Vec6 stress = Vec6::Zero();
    for (const SectionCell& cell : mesh.cells) {
        if (cell.layer != layer) continue;
        const CellPoints points = quadrature.at_nodes(cell);
        const std::vector<Mat6> strains = compute_strain_operators(points, solutions);
        for (std::size_t i = 0; i < strains.size(); ++i) {
            const double distance = (points.at[i] - at).norm();
            if (distance > nearest) continue;
            nearest = distance;
            stress = points.stiffness_at(i) * strains[i] * resultants;
        }
    }
    return stress;
}

}  // namespace

TEST_CASE("A strip of plies is as stiff as its reference, and close to lamination theory",
          "[cross_section]") {
    const auto stiffness_of = [](const std::vector<double>& degrees) {
        const SampleWalls strip = make_strip(degrees);
        return solve(strip.mesh(), strip.materials).stiffness(0, 0) / 20.0;
    };
    CHECK(stiffness_of({0, 90, 90, 0}) == Approx(7.535061e10).epsilon(1e-6));
    // Its free edges are singular: finer meshes go on to 1.763681e10.
    CHECK(stiffness_of({45, -45, -45, 45}) == Approx(1.7637052e10).epsilon(1.5e-5));
}

TEST_CASE("Plies of a strip in tension have the reference stresses", "[cross_section]") {
    const Vec6 tension = 20.0 * Vec6::Unit(0);
    const SampleWalls crossed = make_strip({0, 90, 90, 0});
    const Vec6 along = find_stress(crossed, tension, 0, {0.0, -0.375});
    const Vec6 across = find_stress(crossed, tension, 1, {0.0, -0.125});
    CHECK(along[0] == Approx(1.868400).epsilon(1e-6));
    CHECK(along[1] == Approx(0.034729).epsilon(3e-5));
    CHECK(across[0] == Approx(0.131969).epsilon(1e-5));
    CHECK(across[1] == Approx(-0.034729).epsilon(3e-5));
    const SampleWalls angled = make_strip({45, -45, -45, 45});
    const Vec6 plus = find_stress(angled, tension, 0, {0.0, -0.375});
    const Vec6 minus = find_stress(angled, tension, 1, {0.0, -0.125});
    CHECK(plus[0] == Approx(1.005850).epsilon(2e-5));
    CHECK(plus[5] == Approx(0.419104).epsilon(2e-5));
    CHECK(minus[5] == Approx(-0.419104).epsilon(2e-5));
}

TEST_CASE("A bent pipe of plies has the reference stresses", "[cross_section]") {
    const SampleWalls pipe = make_pipe();
    const Vec6 bending = 1000.0 * Vec6::Unit(4);
    // Layers: flat 0 (outside, along x), flat 1 (inside, around).
    const auto check = [&](int layer, double z, double sigma_xx, double sigma_yy) {
        const Vec6 stress = find_stress(pipe, bending, layer, {0.0, z});
        CAPTURE(z);
        CHECK(stress[0] == Approx(sigma_xx).epsilon(2e-5));
        CHECK(stress[1] == Approx(sigma_yy).epsilon(0.0).margin(0.06));
    };
    check(1, 0.3, 226.184, -5.06);
    check(1, 0.35, 260.212, -132.616);
    check(1, 0.4, 294.239, -260.19);
    check(0, 0.4, 4418.38, 101.513);
    check(0, 0.45, 4967.93, 107.646);
    check(0, 0.5, 5517.47, 113.78);
}
