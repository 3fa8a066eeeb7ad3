#include "cross_section/cross_section.hpp"

#include <Eigen/Eigenvalues>
#include <numbers>

#include "cross_section/moved_section.hpp"
#include "cross_section/plastic_capacity.hpp"
#include "cross_section/section_error.hpp"
#include "cross_section/section_meshes.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

constexpr double pi = std::numbers::pi;

std::shared_ptr<const CrossSection> solve(const SectionMesh& mesh, const ElasticMaterial& material) {
    return compute_cross_section("test", mesh, {material});
}

// Two halves of a square of side 0.1: left of material 0, right of material 1.
SectionMesh make_two_halves() {
    SectionMesh mesh = make_rectangle(0.1, 0.1, {6, 6, 4});
    mesh.layers.push_back({.name = "soft", .material = 1, .fibre_angle = 0.0});
    for (SectionCell& cell : mesh.cells) {
        if (mesh.nodes[static_cast<std::size_t>(cell.nodes[cell.nodes.size() / 2])].x() > 0.0) cell.layer = 1;
    }
    return mesh;
}

// Entries compared with the stiffnesses on the diagonal of their row and column.
double compare(const Mat6& matrix, const Mat6& with) {
    const Vec6 scale = with.diagonal().cwiseSqrt();
    return ((matrix - with).array() / (scale * scale.transpose()).array()).abs().maxCoeff();
}

void move_nodes(SectionMesh& mesh, const PlanePoint& by, double turn, double factor) {
    const Eigen::Rotation2Dd rotation(turn);
    for (PlanePoint& node : mesh.nodes) node = factor * (rotation * node) + by;
}

}  // namespace

TEST_CASE("A rectangle has the closed forms of torsion and shear", "[cross_section]") {
    const double nu = 0.3, G = 1.0 / 2.6;
    SECTION("a square, benchmark X1") {
        const Mat6 K = solve(make_rectangle(1.0, 1.0, {8, 8, 4}), isotropic(1.0, nu))->properties.stiffness;
        CHECK(K(3, 3) / G == Approx(0.140577014971491).epsilon(2e-7));
        CHECK(K(1, 1) / G == Approx(0.828216007340560).epsilon(2e-8));
        CHECK(K(4, 4) == Approx(1.0 / 12.0).epsilon(1e-12));
        CHECK(K(0, 0) == Approx(1.0).epsilon(1e-12));
    }
    SECTION("of side 0.1, benchmark X4") {
        const Mat6 K =
            solve(make_rectangle(0.1, 0.1, {8, 8, 4}), isotropic(100.0, 0.2))->properties.stiffness;
        CHECK(K(1, 1) == Approx(0.34610677).epsilon(2e-8));
        CHECK(K(3, 3) == Approx(5.8573756e-4).epsilon(2e-7));
        CHECK(K(4, 4) == Approx(8.3333333e-4).epsilon(1e-8));
    }
    SECTION("two by one, and of triangles") {
        const SectionMesh mesh = cut_into_triangles(make_rectangle(2.0, 1.0, {20, 10, 4}));
        const Mat6 K = solve(mesh, isotropic(1.0, nu))->properties.stiffness;
        CHECK(K(3, 3) / G == Approx(0.457363354255479).epsilon(2e-7));
        CHECK(K(1, 1) / (2.0 * G) == Approx(0.832941726831447).epsilon(1e-7));
        CHECK(K(2, 2) / (2.0 * G) == Approx(0.784441925213463).epsilon(1e-7));
    }
    SECTION("without contraction") {
        const Mat6 K = solve(make_rectangle(1.0, 1.0, {3, 3, 4}), isotropic(1.0, 0.0))->properties.stiffness;
        CHECK(K(1, 1) / 0.5 == Approx(5.0 / 6.0).epsilon(1e-12));
    }
    SECTION("too coarse a mesh is seen") {
        const Mat6 K = solve(make_rectangle(1.0, 1.0, {4, 4, 2}), isotropic(1.0, nu))->properties.stiffness;
        CHECK(K(3, 3) / G > 0.140577 * 1.0005);
    }
}

TEST_CASE("Tubes have their closed forms, benchmark X3", "[cross_section]") {
    const auto tube = solve(make_ring({0.1, 0.09, 0.0, 2.0 * pi, true}, {24, 1, 4}), isotropic(100.0, 0.2));
    const Mat6& K = tube->properties.stiffness;
    CHECK(K(0, 0) == Approx(0.5969026042).epsilon(1e-8));
    CHECK(K(1, 1) == Approx(0.1249250954).epsilon(1e-8));
    CHECK(K(3, 3) == Approx(0.002250820237).epsilon(1e-8));
    CHECK(K(4, 4) == Approx(0.002700984284).epsilon(1e-8));
    CHECK(std::abs(tube->properties.warping_stiffness) < 1e-15);
    ElasticMaterial steel = isotropic(73e9, 0.33);
    steel.density = 2800.0;
    const auto thick = solve(make_ring({0.3, 0.1, 0.0, 2.0 * pi, true}, {36, 5, 4}), steel);
    const Mat6& C = thick->properties.stiffness;
    CHECK(C(0, 0) == Approx(1.834690110e10).epsilon(1e-8));
    CHECK(C(1, 1) == Approx(4.681763908e9).epsilon(1e-7));
    CHECK(C(3, 3) == Approx(3.44866562e8).epsilon(1e-8));
    CHECK(C(5, 5) == Approx(4.586725274e8).epsilon(1e-8));
    const Mat6& M = thick->properties.mass;
    CHECK(M(0, 0) == Approx(703.7167544).epsilon(1e-8));
    CHECK(M(3, 3) == Approx(35.18583772).epsilon(1e-8));
    CHECK(M(4, 4) == Approx(17.59291886).epsilon(1e-8));
}

TEST_CASE("Half a tube couples extension, bending, shear and twist, benchmark X7", "[cross_section]") {
    const auto half =
        solve(make_ring({0.1, 0.09, pi / 2, 3 * pi / 2, false}, {32, 2, 4}), isotropic(100.0, 0.2));
    const Mat6& K = half->properties.stiffness;
    CHECK(K(0, 0) == Approx(0.29845130).epsilon(2e-8));
    CHECK(K(0, 5) == Approx(0.018066667).epsilon(2e-8));
    CHECK(K(1, 1) == Approx(0.049592131).epsilon(2e-7));
    CHECK(K(2, 2) == Approx(0.062463872).epsilon(2e-7));
    CHECK(K(2, 3) == Approx(-0.0075346529).epsilon(2e-7));
    CHECK(K(3, 3) == Approx(9.1291962e-4).epsilon(2e-7));
    CHECK(half->properties.warping_stiffness == Approx(3.067323e-7).epsilon(1e-6));
    CHECK(half->properties.centroid.x() == Approx(-0.060534722).epsilon(1e-7));
}

TEST_CASE("Two materials side by side have the stiffness of benchmark X5", "[cross_section]") {
    const auto both =
        compute_cross_section("two", make_two_halves(), {isotropic(100.0, 0.2), isotropic(10.0, 0.2)});
    const Mat6& K = both->properties.stiffness;
    CHECK(K(0, 0) == Approx(0.55).epsilon(1e-10));
    CHECK(K(0, 5) == Approx(0.01125).epsilon(1e-10));
    CHECK(K(1, 1) == Approx(0.12631771).epsilon(1e-5));
    CHECK(K(2, 2) == Approx(0.19061423).epsilon(1e-5));
    CHECK(K(2, 3) == Approx(-0.0038989274).epsilon(1e-5));
    CHECK(K(3, 3) == Approx(2.7395315e-4).epsilon(1e-5));
    CHECK(K(5, 5) == Approx(4.5833333e-4).epsilon(1e-8));
}

TEST_CASE("Turning, moving and scaling a section changes nothing", "[cross_section]") {
    const SectionMesh mesh = make_ring({0.1, 0.09, 0.3, 3.9, false}, {12, 1, 3});
    const ElasticMaterial material = isotropic(100.0, 0.3);
    const auto section = solve(mesh, material);
    const double turn = 0.7;
    SectionMesh moved = mesh;
    move_nodes(moved, {0.3, -0.2}, turn, 1.0);
    // Strains about the old point, in the old axes, by those about the new: Γ′ = Rᵀ (Γ + K × d), K′ = Rᵀ K.
    const Mat3 R(Eigen::AngleAxisd(turn, Vec3::UnitX()));
    Mat6 map = Mat6::Zero();
    map.topLeftCorner<3, 3>() = map.bottomRightCorner<3, 3>() = R.transpose();
    Mat3 across;  // d × of d = (0, 0.3, −0.2)
    across << 0.0, 0.2, 0.3, -0.2, 0.0, 0.0, -0.3, 0.0, 0.0;
    map.topRightCorner<3, 3>() = -R.transpose() * across;
    const Mat6 expected = map.transpose() * section->properties.stiffness * map;
    const auto after = solve(moved, material);
    CHECK(compare(after->properties.stiffness, expected) < 1e-10);
    CHECK(after->properties.warping_stiffness == Approx(section->properties.warping_stiffness).epsilon(1e-9));
    for (const double factor : {1e-3, 1e3}) {
        SectionMesh scaled = mesh;
        move_nodes(scaled, PlanePoint::Zero(), 0.0, factor);
        Vec6 powers;
        powers << factor, factor, factor, factor * factor, factor * factor, factor * factor;
        const Mat6 grown = powers.asDiagonal() * section->properties.stiffness * powers.asDiagonal();
        CHECK(compare(solve(scaled, material)->properties.stiffness, grown) < 1e-12);
    }
}

TEST_CASE("Stresses integrate to the resultants they belong to", "[cross_section]") {
    SectionMesh mesh = make_two_halves();
    for (SectionCell& cell : mesh.cells) {
        for (std::size_t i = 0; i < cell.nodes.size(); ++i)
            cell.walls.emplace_back(std::cos(0.4 + cell.layer), std::sin(0.4 + cell.layer));
    }
    mesh.layers[0].fibre_angle = 0.5;
    ElasticMaterial ply = isotropic(10.0, 0.3);
    ply.is_isotropic = false;
    ply.stiffness = compute_orthotropic_stiffness({480.0, 120.0, 120.0, 60.0, 50.0, 60.0, 0.19, 0.19, 0.26});
    const std::vector<ElasticMaterial> materials{ply, isotropic(10.0, 0.3)};
    const SectionQuadrature quadrature(mesh, materials);
    const CentralSolutions solutions = solve_section(quadrature);
    CHECK((integrate_stresses(quadrature, solutions) - Mat6::Identity()).cwiseAbs().maxCoeff() < 1e-12);
    CHECK(solutions.shear_defect < 1e-12);
    CHECK((solutions.stiffness * solutions.flexibility - Mat6::Identity()).cwiseAbs().maxCoeff() < 1e-9);
    CHECK(Eigen::SelfAdjointEigenSolver<Mat6>(solutions.stiffness).eigenvalues().minCoeff() > 0.0);
}

TEST_CASE("Constants of one isotropic material do not depend on Poisson's ratio", "[cross_section]") {
    const SectionMesh mesh = make_ring({0.1, 0.08, 0.0, 4.0, false}, {12, 2, 3});
    const auto with = [&](double nu) { return solve(mesh, isotropic(2.0 * (1.0 + nu), nu))->properties; };
    const SectionProperties a = with(0.0), b = with(0.45);
    const auto torsion = [](const SectionProperties& of) { return 1.0 / of.stiffness.inverse()(3, 3); };
    CHECK(torsion(b) == Approx(torsion(a)).epsilon(1e-8));
    CHECK(b.warping_stiffness / 2.9 == Approx(a.warping_stiffness / 2.0).epsilon(1e-7));
}

TEST_CASE("Heat bends a strip of two metals, benchmark X35", "[cross_section]") {
    for (const double nu : {0.0, 0.3}) {
        SectionMesh mesh = make_rectangle(0.4, 1.0, {4, 6, 3});
        mesh.layers.push_back({.name = "upper", .material = 1, .fibre_angle = 0.0});
        for (SectionCell& cell : mesh.cells) {
            if (mesh.nodes[static_cast<std::size_t>(cell.nodes[5])].y() > 0.0) cell.layer = 1;
        }
        ElasticMaterial steel = isotropic(210e9, nu), aluminium = isotropic(70e9, nu);
        steel.expansion.head<3>().setConstant(12e-6);
        aluminium.expansion.head<3>().setConstant(23e-6);
        const auto strip = compute_cross_section("strip", mesh, {steel, aluminium});
        Vec6 expected = Vec6::Zero();
        expected[0] = 0.0000166538462;
        expected[4] = 1.52307692e-5;
        CHECK((strip->properties.thermal_strains - expected).cwiseAbs().maxCoeff() < 1e-13);
        const auto one = compute_cross_section("strip", mesh, {steel, steel});
        CHECK((one->properties.thermal_strains - 12e-6 * Vec6::Unit(0)).cwiseAbs().maxCoeff() < 1e-17);
    }
}

TEST_CASE("Stresses of a circle, a square and a tube are those of benchmarks X20, X21 and X23",
          "[cross_section]") {
    const auto stress_at = [](const CrossSection& section, const PlanePoint& at) {
        const StressPoint* nearest = &section.stresses.points.front();
        for (const StressPoint& point : section.stresses.points) {
            if ((point.at - at).norm() < (nearest->at - at).norm()) nearest = &point;
        }
        REQUIRE((nearest->at - at).norm() < 1e-6);
        return nearest->stress_operator;
    };
    SECTION("square") {
        const auto square = solve(make_rectangle(1.0, 1.0, {12, 12, 4}), isotropic(1.0, 0.3));
        CHECK(stress_at(*square, {0.0, 0.5})(5, 3) == Approx(-4.803875538).epsilon(1e-4));
        CHECK(stress_at(*square, {0.0, 0.0})(5, 1) == Approx(1.39658929).epsilon(1e-6));
        CHECK(stress_at(*square, {0.0, 0.5})(5, 1) == Approx(1.71853322).epsilon(1e-4));
    }
    SECTION("tube") {
        const auto tube = solve(make_ring({0.1, 0.09, 0.0, 2.0 * pi, true}, {24, 1, 4}), isotropic(1.0, 0.3));
        CHECK(stress_at(*tube, {0.0, 0.09})(5, 1) == Approx(348.590870).epsilon(1e-5));
        CHECK(stress_at(*tube, {0.0, 0.1})(5, 1) == Approx(321.535206).epsilon(1e-5));
        CHECK(stress_at(*tube, {0.1, 0.0})(4, 3) == Approx(1851.177006).epsilon(1e-6));
    }
}

TEST_CASE("A section in two pieces is refused", "[cross_section]") {
    SectionMesh mesh = make_rectangle(1.0, 1.0, {1, 1, 2});
    const SectionMesh other = make_rectangle(1.0, 1.0, {1, 1, 2});
    for (const PlanePoint& node : other.nodes) mesh.nodes.emplace_back(node.x() + 1.0, node.y());
    SectionCell cell = other.cells.front();
    for (int& node : cell.nodes) node += static_cast<int>(other.nodes.size());
    mesh.cells.push_back(cell);
    CHECK_THROWS_AS(solve(mesh, isotropic(1.0, 0.3)), SectionError);
}

TEST_CASE("A section moved after it was solved equals one that was moved before", "[cross_section]") {
    SectionMesh mesh = make_ring({0.1, 0.09, 0.3, 3.9, false}, {10, 1, 3});
    mesh.layers[0].fibre_angle = 0.4;
    ElasticMaterial ply = isotropic(10.0, 0.3);
    ply.is_isotropic = false;
    ply.density = 3.0;
    ply.expansion << 1e-5, 3e-5, 3e-5, 0.0, 0.0, 0.0;
    ply.stiffness = compute_orthotropic_stiffness({480.0, 120.0, 120.0, 60.0, 50.0, 60.0, 0.19, 0.19, 0.26});
    const PlanePoint by(0.3, -0.2);
    const auto after = move_cross_section(solve(mesh, ply), by, 0.7);
    const Eigen::Rotation2Dd rotation(0.7);
    for (PlanePoint& node : mesh.nodes) node = rotation * node + by;
    for (SectionCell& cell : mesh.cells) cell.walls.assign(cell.nodes.size(), rotation * PlanePoint::UnitX());
    const auto before = solve(mesh, ply);
    const SectionProperties& a = after->properties;
    const SectionProperties& b = before->properties;
    CHECK(compare(a.stiffness, b.stiffness) < 1e-9);
    CHECK((a.mass - b.mass).cwiseAbs().maxCoeff() < 1e-14);
    CHECK((a.thermal_strains - b.thermal_strains).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((a.centroid - b.centroid).norm() < 1e-13);
    CHECK(a.second_moment_y == Approx(b.second_moment_y).epsilon(1e-10));
    CHECK(a.product_moment == Approx(b.product_moment).epsilon(1e-10));
    double largest = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < before->stresses.points.size(); ++i) {
        const StressPoint& of_a = after->stresses.points[i];
        const StressPoint& of_b = before->stresses.points[i];
        REQUIRE((of_a.at - of_b.at).norm() < 1e-12);
        largest = std::max(largest, of_b.stress_operator.cwiseAbs().maxCoeff());
        difference =
            std::max(difference, (of_a.stress_operator - of_b.stress_operator).cwiseAbs().maxCoeff());
    }
    CHECK(difference < 1e-9 * largest);
}

TEST_CASE("Plastic moments of a rectangle, a tube and two materials are exact", "[cross_section]") {
    ElasticMaterial steel = isotropic(1.0, 0.3);
    steel.yield_stress = 2.0;
    const auto capacity = [](const SectionMesh& mesh, const std::vector<ElasticMaterial>& materials) {
        const auto found = compute_plastic_capacity(SectionQuadrature(mesh, materials));
        REQUIRE(found);
        return *found;
    };
    SECTION("rectangle") {
        const PlasticCapacity found = capacity(make_rectangle(2.0, 3.0, {3, 3, 2}), {steel});
        CHECK(found.axial_force == Approx(12.0));
        CHECK(found.moment_y == Approx(2.0 * 2.0 * 9.0 / 4.0).epsilon(1e-12));
        CHECK(found.moment_z == Approx(2.0 * 3.0 * 4.0 / 4.0).epsilon(1e-12));
    }
    SECTION("triangles and a ring") {
        const PlasticCapacity cut =
            capacity(cut_into_triangles(make_rectangle(2.0, 3.0, {3, 3, 3})), {steel});
        CHECK(cut.moment_y == Approx(9.0).epsilon(1e-12));
        const PlasticCapacity ring =
            capacity(make_ring({1.0, 0.5, 0.0, 2.0 * pi, true}, {48, 2, 3}), {steel});
        CHECK(ring.moment_y == Approx(2.0 * 4.0 / 3.0 * (1.0 - 0.125)).epsilon(1e-6));
    }
    SECTION("two strengths") {
        ElasticMaterial hard = steel;
        hard.yield_stress = 6.0;
        // Forces 0.01 and 0.03 in the halves: the level that halves the sum lies in the hard one.
        const SectionMesh mesh = make_two_halves();
        const PlasticCapacity found = capacity(mesh, {steel, hard});
        const double level = 0.05 - 0.02 / (6.0 * 0.1);
        CHECK(found.axial_force == Approx(0.04));
        const double left = 2.0 * 0.1 * 0.05 * (level + 0.025) + 6.0 * 0.1 * level * level / 2.0;
        const double right = 6.0 * 0.1 * (0.05 - level) * (0.05 - level) / 2.0;
        CHECK(found.moment_z == Approx(left + right).epsilon(1e-10));
    }
    SECTION("without a yield stress nothing yields") {
        const std::vector<ElasticMaterial> materials{isotropic(1.0, 0.3)};
        const SectionMesh mesh = make_rectangle(2.0, 3.0, {1, 1, 2});
        CHECK_FALSE(compute_plastic_capacity(SectionQuadrature(mesh, materials)));
    }
}

TEST_CASE("Corners of cells on a smooth curve have no say in stresses", "[cross_section]") {
    // A square taken to a circle: at its four corners two sides of a cell lie on one curve.
    const SectionMesh mesh = make_block({4, 4, 4}, false, [](double a, double b) {
        const double y = 2.0 * a - 1.0, z = 2.0 * b - 1.0;
        return PlanePoint(y * std::sqrt(1.0 - z * z / 2.0), z * std::sqrt(1.0 - y * y / 2.0));
    });
    const auto circle = solve(mesh, isotropic(1.0, 0.3));
    int corners = 0;
    for (const StressPoint& point : circle->stresses.points) {
        corners += point.is_singular ? 1 : 0;
        REQUIRE(point.stress_operator.allFinite());
        if (!point.is_singular)
            CHECK(point.stress_operator(0, 4) == Approx(4.0 / pi * point.at.y()).margin(2e-2));
    }
    CHECK(corners == 4);
}
