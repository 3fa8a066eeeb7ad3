#include "model/sections/pressed_tube.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cross_section/cross_section.hpp"

namespace gxrod {
namespace {

// By how much areas and radii of cells may differ from those of the tube, relative.
constexpr double roundness = 1e-3;

// What p_i A_i − p_o A_o grows by for each p of a column of unit density.
double growth_of(const SectionInFluid& section, const std::optional<Water>& water, bool is_wet) {
    return section.contents_density * section.contents_area - (is_wet ? water->density * section.area : 0.0);
}

// Of the weights of contents and water: what differs by less is in balanced.
constexpr double balanced = 1e-6;

bool is_about(double a, double b, double size) { return std::abs(a - b) <= roundness * size; }

}  // namespace

Pressures compute_pressures(const SectionInFluid& section,
                            const std::optional<Water>& water,
                            double gravity,
                            double z) {
    const double depth = (water ? water->surface.value_or(0.0) : 0.0) - z;
    const bool is_wet = water && water->surface && depth > 0.0;
    return {.inside = section.contents_pressure + section.contents_density * gravity * depth,
            .outside = is_wet ? water->density * gravity * depth : 0.0};
}

Pressures recover_pressures(const SectionInFluid& section,
                            const std::optional<Water>& water,
                            double pressure_force,
                            double z) {
    const bool is_wet = water && water->surface && *water->surface > z;
    const double at_rest = section.contents_pressure * section.contents_area;
    // By contents without weight the pressure of water follows from the force alone, whatever its factor.
    const double growth = growth_of(section, water, is_wet);
    const double head = growth == 0.0 ? 0.0 : (pressure_force - at_rest) / growth;
    return {.inside = section.contents_pressure + section.contents_density * head,
            .outside = is_wet ? water->density * head : 0.0};
}

// With a = r_i, b = r_o: σ_r, σ_θ = (p_i a² − p_o b²)/(b² − a²) ∓ (p_i − p_o) a² b²/((b² − a²) r²).
Vec6 PressedTube::compute_stress(const Pressures& pressures, const Eigen::Vector2d& at) const {
    const double a2 = inner * inner, b2 = outer * outer, r2 = at.squaredNorm();
    const double mean = (pressures.inside * a2 - pressures.outside * b2) / (b2 - a2);
    const double change = (pressures.inside - pressures.outside) * a2 * b2 / ((b2 - a2) * r2);
    const Eigen::Vector2d out = at / std::sqrt(r2);
    const double radial = mean - change, hoop = mean + change;
    Vec6 stress = Vec6::Zero();
    stress[0] = mean;  // (p_i A_i − p_o A_o)/A of the wall
    stress[1] = radial * out.x() * out.x() + hoop * out.y() * out.y();
    stress[2] = radial * out.y() * out.y() + hoop * out.x() * out.x();
    stress[3] = (radial - hoop) * out.x() * out.y();
    return stress;
}

bool has_unknown_pressures(const Model& model, const SectionInFluid& section) {
    const std::optional<Water>& water = model.surroundings.water;
    return water && water->surface && water->changes && section.contents_area > 0.0 &&
           section.contents_density > 0.0;
}

std::optional<PressedTube> find_pressed_tube(const Model& model, const Section& section) {
    if (section.law || !section.shape || section.other_shape || !section.fluid) return std::nullopt;
    const double area = section.fluid->area, contents = section.fluid->contents_area;
    const double hole = area - section.shape->properties.area;
    const bool is_pressed = contents > 0.0 || (model.surroundings.water && hole > roundness * area);
    if (!is_pressed || !(hole > 0.0) || (contents > 0.0 && !is_about(contents, hole, area)))
        return std::nullopt;
    const std::optional<Water>& water = model.surroundings.water;
    // Without water and air nothing finds the pressure of contents along rods.
    if (!water && !model.surroundings.air) return std::nullopt;
    if (has_unknown_pressures(model, *section.fluid)) return std::nullopt;
    if (water && water->surface &&
        std::abs(growth_of(*section.fluid, water, true)) < balanced * water->density * area)
        return std::nullopt;
    const std::vector<ElasticMaterial>& materials = section.shape->materials;
    if (materials.size() != 1 || materials.front().strength) return std::nullopt;
    const PressedTube tube{.inner = std::sqrt((contents > 0.0 ? contents : hole) / std::numbers::pi),
                           .outer = std::sqrt(area / std::numbers::pi)};
    double nearest = tube.outer, farthest = 0.0;
    for (const StressPoint& point : section.shape->stresses.points) {
        nearest = std::min(nearest, point.at.norm());
        farthest = std::max(farthest, point.at.norm());
    }
    // Of the tube's area between its radii, so it is the whole ring.
    if (!is_about(nearest, tube.inner, tube.outer) || !is_about(farthest, tube.outer, tube.outer))
        return std::nullopt;
    return tube;
}

}  // namespace gxrod
