#include <fmt/format.h>

#include <algorithm>

#include "deck/drives/build_drives.hpp"
#include "deck/loads/acting.hpp"
#include "deck/places/part.hpp"
#include "deck/reading/copies.hpp"
#include "deck/schema/schema_tables.hpp"
#include "model/sections/element_means.hpp"

namespace gxrod {
namespace {

struct ActuationTable : ActingTable {
    TableName on;
    std::optional<CheckedLineFunction> stretch;
    std::optional<CheckedLinePair> shear;
    std::optional<CheckedLineVector> curvature;
    std::optional<CheckedLineFunction> temperature;
    std::optional<CheckedLinePair> temperature_gradient;
    Copies copies;
};

}  // namespace

const TableSpec& actuation_table() {
    using T = ActuationTable;
    // clang-format off
    static const TableSpec table = Table<T>("[[actuation]]",
            "Strains that the sections of a rod would take by themselves: those of muscles, growth and heat. They add "
            "to the stress-free shape. In section axes; s is the arc length from the rod's start.")
        .key("on", &T::on, "The name of a rod.")
            .required().names_of({"rod"}).also("rod beam along")
        .key("stretch", &T::stretch, "Along the rod.")
            .unit("1").otherwise("0").also("strain axial extension elongation")
        .key("shear", &T::shear, "Along y and z.")
            .unit("1").otherwise("0")
        .key("curvature", &T::curvature, "About x (twist), y and z.")
            .unit("1/length").otherwise("0").also("kappa bending")
        .key("temperature", &T::temperature, "Above that of the stress-free shape. It acts by the section's expansion.")
            .unit("temperature").otherwise("0").also("t dt heat")
        .key("temperature_gradient", &T::temperature_gradient, "How fast the temperature rises along y and z.")
            .unit("temperature/length").otherwise("0")
        .key("factor", &T::factor, factor_sentence("value"))
            .unit("1").otherwise(factor_default)
        .key("stages", &T::stages, "The stages in which it acts.")
            .otherwise("all").names_of({"stage"})
        .with(add_copies<T>)
        .at_least_one_of({"stretch", "shear", "curvature", "temperature", "temperature_gradient"})
        .shown_by(
            "[[actuation]]\n"
            "on        = \"tail\"\n"
            "curvature = [0, 0, \"0.1*s*sin(t)\"]\n");
    // clang-format on
    return table;
}

namespace {

bool expands(const Section& section) { return section.expansion != 0.0; }

// Heat needs a section that expands.
void check_expansion(const ActuationTable& given, const Rod& rod, const BuildContext& context) {
    if ((!given.temperature && !given.temperature_gradient) || context.model.sections.empty()) return;
    const Section& section = context.model.sections[static_cast<std::size_t>(rod.section)];
    if (std::ranges::any_of(rod.varying.at_forces, expands) ||
        (!rod.has_varying_sections() && expands(section)))
        return;
    const void* field = &given.temperature_gradient;
    if (given.temperature) field = &given.temperature;
    context.faults.add(
        given.place_of(field),
        given.path_of(field),
        fmt::format("the section of the rod {} has no expansion, so that heat does nothing; expected "
                    "a key expansion of its [section.NAME]",
                    rod.name));
}

void add_actuation(const ActuationTable& given, BuildContext& context) {
    const std::optional<Part> part = find_part(given, given.on, context);
    const Acting acting = find_acting(given, context);
    if (!part || acting.is_absent) return;
    const Rod& rod = context.model.rods[static_cast<std::size_t>(part->rod)];
    check_expansion(given, rod, context);
    const auto mean = [&](const CheckedLineFunction* one) {
        return take_element_means(one == nullptr ? LineFunction() : acting.apply(one->expression), rod);
    };
    const auto of = [&](const auto& field) { return mean(field ? &*field : nullptr); };
    const auto component = [&](const auto& field, std::size_t i) {
        return mean(field ? &(*field)[i] : nullptr);
    };
    context.model.actuations.push_back({.key = given.path,
                                        .rod = part->rod,
                                        .strain = {of(given.stretch),
                                                   component(given.shear, 0),
                                                   component(given.shear, 1),
                                                   component(given.curvature, 0),
                                                   component(given.curvature, 1),
                                                   component(given.curvature, 2)},
                                        .temperature = of(given.temperature),
                                        .temperature_gradient = {component(given.temperature_gradient, 0),
                                                                 component(given.temperature_gradient, 1)}});
}

}  // namespace

void build_actuations(BuildContext& context) {
    for (const ActuationTable& given : tables_of<ActuationTable>(context.deck, actuation_table()))
        add_actuation(given, context);
}

}  // namespace gxrod
