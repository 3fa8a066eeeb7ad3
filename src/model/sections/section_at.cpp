#include "model/sections/section_at.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "cross_section/cross_section.hpp"
#include "model/sections/pressed_tube.hpp"
#include "model/sections/section_law.hpp"

namespace gxrod {
namespace {

// By how much the area that displaces water may differ from the area of the cells, relative.
constexpr double area_of_solid = 1e-3;

// The arc lengths of an element's nodes.
std::span<const double> nodes_of(const Rod& rod, int element) {
    const auto count = static_cast<std::size_t>(rod.order) + 1;
    return std::span(rod.arc_length).subspan(static_cast<std::size_t>(element) * count, count);
}

const Rod& rod_at(const Model& model, const RodPlace& place) {
    return model.rods[static_cast<std::size_t>(place.rod)];
}

// The index of the nearest node in its element.
std::size_t nearest_node(const Model& model, const RodPlace& place) {
    const std::span<const double> nodes = nodes_of(rod_at(model, place), place.element);
    const double s = arc_length_at(model, place);
    const auto distance = [&](double node) { return std::abs(node - s); };
    return static_cast<std::size_t>(std::ranges::min_element(nodes, {}, distance) - nodes.begin());
}

const Section& section_of_node(const Rod& rod, int element, std::size_t node) {
    return rod.varying.at_nodes[static_cast<std::size_t>(element * (rod.order + 1)) + node];
}

void add_parts(const Model& model, const Section& section, double part, std::vector<ShapePart>& parts) {
    // The largest stresses of a tube under pressure depend on more than its resultants.
    if (!explain_no_stress(model, section).empty() || find_pressed_tube(model, section)) return;
    const auto add = [&](const std::shared_ptr<const CrossSection>& shape, double share) {
        if (!shape || share == 0.0) return;
        const auto known = std::ranges::find(parts, shape, &ShapePart::shape);
        if (!section.other_shape && known != parts.end()) {
            known->part += share;
            return;
        }
        parts.push_back({shape, share, section.other_shape ? &section : nullptr});
    };
    add(section.shape, part * (1.0 - section.other_part));
    add(section.other_shape, part * section.other_part);
}

}  // namespace

const Section& section_at(const Model& model, const RodPlace& place) {
    const Rod& rod = rod_at(model, place);
    if (!rod.has_varying_sections()) return model.sections[static_cast<std::size_t>(rod.section)];
    return section_of_node(rod, place.element, nearest_node(model, place));
}

std::string explain_no_stress(const Model& model, const Section& section) {
    if (section.law) return "has a law, " + section.law->describe() + ", of which stresses do not follow";
    if (!section.shape) return "has numbers and no shape";
    if (!section.fluid || find_pressed_tube(model, section)) return "";
    if (section.fluid->contents_area > 0.0 && !model.surroundings.water && !model.surroundings.air)
        return "is under the pressure of its contents, which is found in water or air alone; expected "
               "[fluid] or [air], such as [air] with density = 1.2";
    if (has_unknown_pressures(model, *section.fluid))
        return "is under the pressures of its contents and of water that has a factor or stages, which its "
               "results do not tell apart; expected [fluid] without factor and stages, or contents without "
               "density";
    if (section.fluid->contents_area > 0.0)
        return "is under the pressure of its contents, and no round tube that they fill, of one material "
               "without strength";
    if (!model.surroundings.water) return "";
    // A solid section under the pressure p of water has the stresses by its effective tension, less p in all
    // directions.
    const bool is_solid =
        !section.other_shape &&
        std::abs(section.shape->properties.area - section.fluid->area) <= area_of_solid * section.fluid->area;
    if (!is_solid)
        return "is under the pressure of water, and hollow: it displaces more than its material fills";
    const bool has_strength = std::ranges::any_of(
        section.shape->materials, [](const ElasticMaterial& one) { return one.strength.has_value(); });
    return has_strength ? "is under the pressure of water, which the strength of its material leaves out"
                        : "";
}

double arc_length_at(const Model& model, const RodPlace& place) {
    const std::span<const double> nodes = nodes_of(rod_at(model, place), place.element);
    return nodes.front() + 0.5 * (1.0 + place.xi) * (nodes.back() - nodes.front());
}

bool is_at_node(const Model& model, const RodPlace& place) {
    const std::span<const double> nodes = nodes_of(rod_at(model, place), place.element);
    const double off = std::abs(nodes[nearest_node(model, place)] - arc_length_at(model, place));
    return off <= 1e-9 * (nodes.back() - nodes.front());
}

std::vector<RodPlace> list_stress_places(const Model& model, int rod, int element) {
    std::vector<RodPlace> places;
    const auto add = [&](double xi) { places.push_back({.rod = rod, .element = element, .xi = xi}); };
    const Rod& of = model.rods[static_cast<std::size_t>(rod)];
    if (!of.has_varying_sections()) {
        for (const double xi : {-1.0, 0.0, 1.0}) add(xi);
        return places;
    }
    const std::span<const double> nodes = nodes_of(of, element);
    for (const double s : nodes) add(2.0 * (s - nodes.front()) / (nodes.back() - nodes.front()) - 1.0);
    return places;
}

std::vector<ShapePart> find_shapes(const Model& model, const RodPlace& place) {
    std::vector<ShapePart> parts;
    const Rod& rod = rod_at(model, place);
    if (!rod.has_varying_sections() || is_at_node(model, place)) {
        add_parts(model, section_at(model, place), 1.0, parts);
    } else {
        const std::span<const double> nodes = nodes_of(rod, place.element);
        const double s = arc_length_at(model, place);
        const auto next = static_cast<std::size_t>(std::ranges::upper_bound(nodes, s) - nodes.begin());
        const double t = (s - nodes[next - 1]) / (nodes[next] - nodes[next - 1]);
        add_parts(model, section_of_node(rod, place.element, next - 1), 1.0 - t, parts);
        add_parts(model, section_of_node(rod, place.element, next), t, parts);
    }
    double whole = 0.0;
    for (const ShapePart& one : parts) whole += one.part;
    if (whole < 1.0 - 1e-9) return {};  // a section next to it has no stresses
    std::ranges::stable_sort(parts, std::greater{}, &ShapePart::part);
    return parts;
}

std::vector<ListedShape> list_shapes(const Model& model) {
    std::vector<ListedShape> listed;
    std::unordered_set<const CrossSection*> known;
    for (int r = 0; r < static_cast<int>(model.rods.size()); ++r) {
        const Rod& rod = model.rods[static_cast<std::size_t>(r)];
        const std::string& name = model.sections[static_cast<std::size_t>(rod.section)].name;
        const bool varies = rod.has_varying_sections();
        for (int element = 0; element < (varies ? rod.element_count() : 1); ++element) {
            for (const RodPlace& place : list_stress_places(model, r, element)) {
                for (ShapePart& one : find_shapes(model, place)) {
                    if (!known.insert(one.shape.get()).second) continue;
                    const double s = arc_length_at(model, place);
                    listed.push_back(
                        {std::move(one.shape), varies ? fmt::format("{}, s = {:.6g}", name, s) : name});
                }
            }
        }
    }
    return listed;
}

}  // namespace gxrod
