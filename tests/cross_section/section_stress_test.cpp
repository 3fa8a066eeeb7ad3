#include "cross_section/section_stress.hpp"

#include <cmath>
#include <random>

#include "cross_section/failure_criteria.hpp"
#include "cross_section/section_meshes.hpp"
#include "cross_section/stress_measures.hpp"
#include "cross_section/walls/solid_meshes.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

ElasticMaterial make_steel(std::optional<double> yield_stress) {
    return {.name = "steel",
            .stiffness = compute_isotropic_stiffness(2.1e11, 0.3),
            .density = 7850.0,
            .yield_stress = yield_stress};
}

ElasticMaterial make_ply() {
    return {.name = "ply",
            .stiffness = compute_orthotropic_stiffness({.E1 = 141e9,
                                                        .E2 = 9.8e9,
                                                        .E3 = 9.8e9,
                                                        .G12 = 6e9,
                                                        .G13 = 6e9,
                                                        .G23 = 4.8e9,
                                                        .nu12 = 0.3,
                                                        .nu13 = 0.3,
                                                        .nu23 = 0.34}),
            .is_isotropic = false,
            .strength = PlyStrength{1500e6, 1200e6, 40e6, 200e6, 70e6, 50e6}};
}

// One half of each of two materials.
std::shared_ptr<const CrossSection> compute_halves(std::vector<ElasticMaterial> materials) {
    SectionMesh mesh = make_rectangle(0.04, 0.02, {.first = 8, .second = 4, .order = 3});
    mesh.layers = {{.name = "left", .material = 0, .fibre_angle = 0.4}, {.name = "right", .material = 1}};
    for (std::size_t i = mesh.cells.size() / 2; i < mesh.cells.size(); ++i) mesh.cells[i].layer = 1;
    return compute_cross_section("halves", std::move(mesh), std::move(materials));
}

// Resultants of random sizes, some of them zero.
class RandomResultants {
  public:
    Vec6 operator()() {
        std::uniform_real_distribution<double> number(-1.0, 1.0), size(-3.0, 3.0);
        Vec6 drawn;
        for (int i = 0; i < 6; ++i)
            drawn[i] = number(engine_) < -0.3 ? 0.0 : number(engine_) * std::pow(10.0, size(engine_));
        return drawn.cwiseProduct((Vec6() << 1e3, 1e3, 1e3, 1.0, 1.0, 1.0).finished());
    }

  private:
    std::mt19937 engine_{7};
};

template <class Measure>
double find_largest(const CrossSection& section, const Measure& measure) {
    double largest = 0.0;
    for (const StressPoint& point : section.stresses.points) {
        if (!point.is_singular) largest = std::max(largest, measure(point));
    }
    return largest;
}

}  // namespace

TEST_CASE("The worst point of a section is that of all its points", "[cross_section]") {
    const auto circle = compute_cross_section("circle", mesh_circle(0.02), {make_steel(235e6)});
    const auto halves = compute_halves({make_steel(235e6), make_steel(600e6)});
    RandomResultants draw;
    for (const auto& section : {circle, halves}) {
        const SectionStresses stresses(section, "");
        for (int i = 0; i < 200; ++i) {
            const Vec6 resultants = draw();
            const auto mises = [&](const StressPoint& point) {
                return compute_von_mises(point.stress_operator * resultants);
            };
            const auto found = stresses.find_von_mises(resultants);
            const double largest = find_largest(*section, mises);
            REQUIRE(found);
            CHECK(found->value == Approx(largest).epsilon(1e-12));
            CHECK(stresses.describe(found->point, resultants).von_mises == Approx(largest).epsilon(1e-12));
            CHECK_FALSE(stresses.find_von_mises(resultants, 1.001 * largest));
            CHECK(stresses.find_von_mises(resultants, 0.999 * largest));
            const double exposure = find_largest(*section, [&](const StressPoint& point) {
                const bool is_left = section == circle || point.layer == 0;
                return mises(point) / (is_left ? 235e6 : 600e6);
            });
            CHECK(stresses.find_exposure(resultants)->value == Approx(exposure).epsilon(1e-12));
        }
    }
}

TEST_CASE("Of equal stresses the first point is the worst", "[cross_section]") {
    const auto circle = compute_cross_section("circle", mesh_circle(0.02), {make_steel(235e6)});
    const SectionStresses stresses(circle, "");
    CHECK(stresses.find_von_mises(Vec6::Unit(0))->point == 0);
}

TEST_CASE("Each material is judged by what it has", "[cross_section]") {
    RandomResultants draw;
    const auto section = compute_halves({make_ply(), make_steel(235e6)});
    const SectionStresses stresses(section, "tsai-wu");
    const SectionStresses without(compute_halves({make_steel({}), make_steel({})}), "tsai-wu");
    const SectionStresses in_part(compute_halves({make_ply(), make_steel({})}), "hashin");
    CHECK(stresses.has_strength());
    CHECK(in_part.has_strength());
    CHECK_FALSE(without.has_strength());
    for (int i = 0; i < 50; ++i) {
        const Vec6 resultants = 1e3 * draw();
        const double largest = find_largest(*section, [&](const StressPoint& point) {
            const Vec6 stress = point.stress_operator * resultants;
            if (point.layer == 1) return compute_von_mises(stress) / 235e6;
            const Vec6 in_ply = turn_stress_to_ply(stress, 0.4, point.wall);
            return find_failure_criterion("tsai-wu")
                ->find_modes(in_ply, section->materials[0])
                .governing()
                .exposure();
        });
        const auto found = stresses.find_exposure(resultants);
        CHECK(found->value == Approx(largest).epsilon(1e-12));
        CHECK(stresses.describe(found->point, resultants).exposure == Approx(largest).epsilon(1e-12));
        // Linear in the load.
        CHECK(stresses.find_exposure(2.0 * resultants)->value == Approx(2.0 * largest).epsilon(1e-12));
        CHECK(in_part.describe(in_part.find_exposure(resultants)->point, resultants).layer == 0);
        CHECK_FALSE(without.find_exposure(resultants));
    }
}

TEST_CASE("A point of a section is the nearest one", "[cross_section]") {
    const auto circle = compute_cross_section("circle", mesh_circle(0.02), {make_steel(235e6)});
    const SectionStresses stresses(circle, "");
    const int top = stresses.find_nearest_point({0.0, 0.021});
    // My bends about y: σ = My z/I at the top.
    const double expected = 0.02 / (M_PI * std::pow(0.02, 4) / 4.0);
    CHECK(stresses.describe(top, Vec6::Unit(4)).stress[0] == Approx(expected).epsilon(1e-4));
    CHECK(stresses.describe(top, Vec6::Unit(4)).at.y() == Approx(0.02));
}
