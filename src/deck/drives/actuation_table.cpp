#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cross_section/heat/heat_strains.hpp"
#include "deck/drives/build_drives.hpp"
#include "deck/loads/acting.hpp"
#include "deck/output/stress_criterion.hpp"
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
        .key("temperature", &T::temperature, "Above that of the stress-free shape. It acts by the expansion of the section or of its "
             "materials.")
            .unit("temperature").otherwise("0").also("t dt heat")
        .key("temperature_gradient", &T::temperature_gradient, "How fast the temperature rises along y and z.")
            .unit("temperature/length").otherwise("0")
        .key("factor", &T::factor, factor_sentence("value"))
            .unit("1").otherwise(factor_default)
        .key("stages", &T::stages, "The stages in which it acts.")
            .otherwise("all").names_of({"stage"})
        .with(add_load_case<T>)
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

// The sections that a rod has.
std::vector<std::reference_wrapper<const Section>> list_sections(const Rod& rod, const Model& model) {
    if (!rod.has_varying_sections()) return {model.sections[static_cast<std::size_t>(rod.section)]};
    return {rod.varying.at_forces.begin(), rod.varying.at_forces.end()};
}

// Free strains for each degree on the line, and for each degree per length along y and z.
using HeatStrains = Eigen::Matrix<double, 6, 3>;

// Sets strains to zero that are those of the cells, compared with the size of the section.
Vec6 without_cells(const Vec6& strains, const Mat6& stiffness) {
    constexpr double of_cells = 1e-7;
    const double size = std::sqrt(std::max(stiffness(4, 4), stiffness(5, 5)) / stiffness(0, 0));
    Vec6 scaled = strains.cwiseAbs();
    scaled.tail<3>() *= size;
    return (scaled.array() > of_cells * scaled.maxCoeff()).select(strains, 0.0);
}

// Those of a shape whose parts hold each other; zero if it expands alike all over, by Section::expansion.
HeatStrains find_heat_strains(const CrossSection* shape) {
    HeatStrains strains = HeatStrains::Zero();
    if (shape == nullptr || !expands(*shape) || find_even_expansion(*shape)) return strains;
    const SectionProperties& properties = shape->properties;
    strains.col(0) = without_cells(properties.thermal_strains, properties.stiffness);
    for (const int i : {0, 1})
        strains.col(1 + i) = without_cells(shape->gradient_strains.col(i), properties.stiffness);
    return strains;
}

HeatStrains find_heat_strains(const Section& section) {
    return (1.0 - section.other_part) * find_heat_strains(section.shape.get()) +
           section.other_part * find_heat_strains(section.other_shape.get());
}

// The free strains of a rod at its force points; at one arc length if they are the same everywhere.
struct HeatAlong {
    std::vector<double> s;
    std::vector<HeatStrains> strains;

    bool is_zero() const {
        return std::ranges::all_of(strains, [](const HeatStrains& one) { return one.isZero(0.0); });
    }
    // Linear between force points, at which alone elements ask for it.
    double at(double place, Eigen::Index row, Eigen::Index column) const {
        const auto entry = [&](std::size_t i) { return strains[i](row, column); };
        const auto next = static_cast<std::size_t>(std::ranges::lower_bound(s, place) - s.begin());
        if (next == 0) return entry(0);
        if (next == s.size()) return entry(next - 1);
        const double part = (place - s[next - 1]) / (s[next] - s[next - 1]);
        return std::lerp(entry(next - 1), entry(next), part);
    }
};

HeatAlong find_heat_along(const Rod& rod, const Model& model) {
    HeatAlong heat;
    for (const Section& section : list_sections(rod, model))
        heat.strains.push_back(find_heat_strains(section));
    heat.s = {0.0};
    if (rod.has_varying_sections()) heat.s = list_force_points(rod);
    return heat;
}

bool expands_by_heat(const Section& section) { return section.expansion != 0.0; }

// Whether a rod can have sections between one whose parts hold each other and one without cells, of which
// free strains are not known.
bool lacks_shapes(const Rod& rod, const Model& model) {
    const auto has_none = [](const Section& section) { return section.shape == nullptr; };
    const auto bends = [](const Section& section) {
        return !find_heat_strains(section.shape.get()).isZero(0.0);
    };
    return rod.has_varying_sections() && std::ranges::any_of(rod.varying.at_forces, has_none) &&
           std::ranges::any_of(model.sections, bends);
}

// Heat needs a section that expands.
void check_expansion(const ActuationTable& given,
                     const Rod& rod,
                     const HeatAlong& heat,
                     const BuildContext& context) {
    if ((!given.temperature && !given.temperature_gradient) || context.model.sections.empty()) return;
    const void* field = &given.temperature_gradient;
    if (given.temperature) field = &given.temperature;
    if (lacks_shapes(rod, context.model)) {
        return context.faults.add(
            given.place_of(field),
            given.path_of(field),
            fmt::format(
                "heat bends a section of this deck, and the rod {} has sections without cells; expected one "
                "section, or sections of walls, meshes, profiles or polygons alone",
                rod.name));
    }
    if (!heat.is_zero()) {
        if (!asks_for_stresses(context.deck)) return;
        return context.notes.push_back(
            fmt::format("{}: stresses of the rod {} leave out those by which its materials hold each other "
                        "when they get hotter",
                        given.path_of(field),
                        rod.name));
    }
    if (std::ranges::any_of(list_sections(rod, context.model), expands_by_heat)) return;
    context.faults.add(
        given.place_of(field),
        given.path_of(field),
        fmt::format("the section of the rod {} has no expansion, so that heat does nothing; expected "
                    "a key expansion of its [section.NAME] or of its materials",
                    rod.name));
}

// Adds the free strains that a temperature, or one of its gradients, gives sections whose parts hold each
// other.
void add_heat_strains(const Actuation& base,
                      const std::shared_ptr<const HeatAlong>& heat,
                      Eigen::Index column,
                      const LineFunction& temperature,
                      BuildContext& context) {
    if (temperature.is_zero()) return;
    Actuation added{.key = base.key, .rod = base.rod};
    const bool is_even = heat->s.size() == 1;
    LineForm form = temperature.is_constant() ? LineForm{InTime::constant, true} : temperature.form();
    form.is_even = form.is_even && is_even;
    for (Eigen::Index i = 0; i < 6; ++i) {
        const auto is_zero = [&](const HeatStrains& one) { return one(i, column) == 0.0; };
        if (std::ranges::all_of(heat->strains, is_zero)) continue;
        const auto strain = [heat, temperature, column, i](double time, double s) {
            return heat->at(s, i, column) * temperature(time, s);
        };
        added.strain[static_cast<std::size_t>(i)] = is_even && temperature.is_constant()
                                                        ? LineFunction(strain(0.0, 0.0))
                                                        : LineFunction(strain, temperature.switches(), form);
    }
    context.model.actuations.push_back(std::move(added));
}

void add_actuation(const ActuationTable& given, BuildContext& context) {
    const std::optional<Part> part = find_part(given, given.on, context);
    const Acting acting = find_acting(given, context);
    if (!part || acting.is_absent) return;
    const Rod& rod = context.model.rods[static_cast<std::size_t>(part->rod)];
    const auto heat = std::make_shared<const HeatAlong>(
        context.model.sections.empty() ? HeatAlong{} : find_heat_along(rod, context.model));
    check_expansion(given, rod, *heat, context);
    const auto mean = [&](const CheckedLineFunction* one) {
        return take_element_means(one == nullptr ? LineFunction() : acting.apply(one->expression), rod);
    };
    const auto of = [&](const auto& field) { return mean(field ? &*field : nullptr); };
    const auto component = [&](const auto& field, std::size_t i) {
        return mean(field ? &(*field)[i] : nullptr);
    };
    const Actuation actuation{.key = given.path,
                              .rod = part->rod,
                              .strain = {of(given.stretch),
                                         component(given.shear, 0),
                                         component(given.shear, 1),
                                         component(given.curvature, 0),
                                         component(given.curvature, 1),
                                         component(given.curvature, 2)},
                              .temperature = of(given.temperature),
                              .temperature_gradient = {component(given.temperature_gradient, 0),
                                                       component(given.temperature_gradient, 1)}};
    context.model.actuations.push_back(actuation);
    if (heat->is_zero()) return;
    add_heat_strains(actuation, heat, 0, actuation.temperature, context);
    add_heat_strains(actuation, heat, 1, actuation.temperature_gradient[0], context);
    add_heat_strains(actuation, heat, 2, actuation.temperature_gradient[1], context);
}

}  // namespace

void build_actuations(BuildContext& context) {
    for (const ActuationTable& given : tables_of<ActuationTable>(context.deck, actuation_table()))
        add_actuation(given, context);
}

}  // namespace gxrod
