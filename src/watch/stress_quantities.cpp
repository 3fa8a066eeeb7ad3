#include <algorithm>

#include "cross_section/cross_section.hpp"
#include "model/sections/pressed_tube.hpp"
#include "model/sections/section_at.hpp"
#include "watch/quantity_tables.hpp"
#include "watch/sight.hpp"

namespace gxrod {
namespace {

std::string lacks_stress(const Watched& target, const Model& model) {
    const RodPlace& place = std::get<WatchedPoint>(target).place;
    const Section& section = section_at(model, place);
    const std::string reason = explain_no_stress(model, section);
    if (!reason.empty()) return "the section " + reason;
    if (section.other_shape) return "the section is mixed of two there; stresses are known at the stations";
    if (model.rods[static_cast<std::size_t>(place.rod)].has_varying_sections() && !is_at_node(model, place))
        return "where a section varies, stresses are known at nodes";
    return "";
}

std::string lacks_exposure(const Watched& target, const Model& model) {
    std::string reason = lacks_stress(target, model);
    if (!reason.empty()) return reason;
    const auto has_strength = [](const ElasticMaterial& one) { return one.yield_stress || one.strength; };
    const Section& section = section_at(model, std::get<WatchedPoint>(target).place);
    return std::ranges::any_of(section.shape->materials, has_strength)
               ? ""
               : "no material of the section has yield_stress or strength";
}

double find_exposure_in(const Sight& see) {
    const Section& section = section_at(*see.of.model, std::get<WatchedPoint>(see.of.target).place);
    return find_pressed_tube(*see.of.model, section) ? see.stress().exposure : see.exposure();
}

// clang-format off
constexpr Quantity stress_lines[]{
    Quantity("stress", "stress (xx, yy, zz, yz, xz, xy)", "force/length²", Axes::material,
             [](const Sight& see) { return see.stress().stress; }).with_strain_order().unless(lacks_stress),
    Quantity("von_mises", "von Mises stress", "force/length²", Axes::none,
             [](const Sight& see) { return see.stress().von_mises; }).with_strain_order().unless(lacks_stress),
    Quantity("principal_stress", "principal stresses, the largest first", "force/length²", Axes::principal,
             [](const Sight& see) { return see.stress().principal; }).with_strain_order().unless(lacks_stress),
    Quantity("exposure", "exposure: 1/(factor on all resultants at which the material fails)", "1", Axes::none,
             [](const Sight& see) { return find_exposure_in(see); }).with_strain_order().unless(lacks_exposure),
    Quantity("stress_place", "where in the section (y, z) the stress is", "length", Axes::material,
             [](const Sight& see) { return see.stress().at; }).unless(lacks_stress)};
// clang-format on

}  // namespace

constinit const QuantityTable quantities_of_stresses{stress_lines, SnapshotPart::section, "points"};

bool is_stress_quantity(std::string_view word) {
    return std::ranges::find(stress_lines, word, &Quantity::word) != std::end(stress_lines);
}

}  // namespace gxrod
