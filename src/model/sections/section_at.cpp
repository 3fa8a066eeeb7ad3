#include "model/sections/section_at.hpp"

#include <fmt/format.h>

#include <cmath>
#include <unordered_set>

namespace gxrod {

const Section& section_at(const Model& model, const RodPlace& place) {
    const Rod& rod = model.rods[static_cast<std::size_t>(place.rod)];
    if (!rod.has_varying_sections()) return model.sections[static_cast<std::size_t>(rod.section)];
    const int first = place.element * (rod.order + 1);
    const auto nearest = static_cast<int>(std::lround(0.5 * (1.0 + place.xi) * rod.order));
    return rod.varying.at_nodes[static_cast<std::size_t>(first + nearest)];
}

double arc_length_at(const Model& model, const RodPlace& place) {
    const Rod& rod = model.rods[static_cast<std::size_t>(place.rod)];
    const auto first = static_cast<std::size_t>(place.element * (rod.order + 1));
    const double start = rod.arc_length[first];
    const double end = rod.arc_length[first + static_cast<std::size_t>(rod.order)];
    return start + 0.5 * (1.0 + place.xi) * (end - start);
}

std::shared_ptr<const CrossSection> find_shape(const Model& model, const RodPlace& place) {
    const Section& section = section_at(model, place);
    return section.law ? nullptr : section.shape;
}

std::vector<ListedShape> list_shapes(const Model& model) {
    std::vector<ListedShape> listed;
    std::unordered_set<const CrossSection*> known;
    for (std::size_t r = 0; r < model.rods.size(); ++r) {
        const Rod& rod = model.rods[r];
        const std::string& name = model.sections[static_cast<std::size_t>(rod.section)].name;
        const bool varies = rod.has_varying_sections();
        for (int element = 0; element < (varies ? rod.element_count() : 1); ++element) {
            for (const double xi : {-1.0, 0.0, 1.0}) {
                const RodPlace place{.rod = static_cast<int>(r), .element = element, .xi = xi};
                std::shared_ptr<const CrossSection> shape = find_shape(model, place);
                if (!shape || !known.insert(shape.get()).second) continue;
                const double s = arc_length_at(model, place);
                listed.push_back({std::move(shape),
                                  varies ? fmt::format("{} on {}, s = {:.6g}", name, rod.name, s) : name});
            }
        }
    }
    return listed;
}

}  // namespace gxrod
