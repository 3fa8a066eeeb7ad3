#include "cross_section/heat/heat_strains.hpp"
#include <algorithm>

namespace gxrod {
namespace {

const ElasticMaterial& material_of(const CrossSection& section, const SectionCell& cell) {
    const SectionLayer& layer = section.mesh.layers[static_cast<std::size_t>(cell.layer)];
    return section.materials[static_cast<std::size_t>(layer.material)];
}

bool is_even(const Vec6& expansion) {
    return expansion[0] == expansion[1] && expansion[0] == expansion[2] && expansion.tail<3>().isZero(0.0);
}

}  // namespace

bool expands(const CrossSection& section) {
    return std::ranges::any_of(section.mesh.cells, [&](const SectionCell& cell) {
        return !material_of(section, cell).expansion.isZero(0.0);
    });
}

std::optional<double> find_even_expansion(const CrossSection& section) {
    const Vec6& first = material_of(section, section.mesh.cells.front()).expansion;
    // Strains by axis are even where the axes are those of the section, along the rod and across.
    const auto has_section_axes = [&](const SectionCell& cell) {
        return cell.walls.empty() &&
               section.mesh.layers[static_cast<std::size_t>(cell.layer)].fibre_angle == 0.0;
    };
    const auto is_alike = [&](const SectionCell& cell) {
        return material_of(section, cell).expansion == first && (is_even(first) || has_section_axes(cell));
    };
    return std::ranges::all_of(section.mesh.cells, is_alike) ? std::optional(first[0]) : std::nullopt;
}

}  // namespace gxrod
