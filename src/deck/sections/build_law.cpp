#include "deck/sections/build_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "deck/schema/choices.hpp"
#include "deck/sections/build_sections.hpp"
#include "laws/layered_law.hpp"
#include "laws/moment_curvature_law.hpp"
#include "laws/shape_layers.hpp"
#include "laws/trapeze_law.hpp"
#include "laws/viscoelastic_law.hpp"

namespace gxrod {
namespace {

using SharedLaw = std::shared_ptr<const SectionLaw>;

const CheckedTable& only(const CheckedTable& table, const char* key) { return table.tables(key).front(); }

void add_row_fault(const CheckedTable& table,
                   const char* key,
                   std::size_t row,
                   std::string message,
                   const BuildContext& context) {
    context.faults.add(table.get<CheckedPairs>(key).places[row],
                       fmt::format("{}[{}]", table.path_of(key), row),
                       std::move(message));
}

// Rows that start at (0, start), the first number rising and the second not falling.
std::optional<PiecewiseLine> find_line(const CheckedTable& table,
                                       const char* key,
                                       double start,
                                       const BuildContext& context) {
    const auto& rows = table.get<CheckedPairs>(key).rows;
    const auto refuse = [&](std::size_t row, std::string message) {
        add_row_fault(table, key, row, std::move(message), context);
        return std::nullopt;
    };
    if (rows.front() != std::pair(0.0, start)) {
        return refuse(
            0,
            fmt::format(
                "expected [0, {}] first, found [{}, {}]", start, rows.front().first, rows.front().second));
    }
    if (rows.size() < 2) return refuse(0, "expected another row after the first one");
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i].first <= rows[i - 1].first) {
            return refuse(i,
                          fmt::format("the first number must rise from row to row: {} follows {}",
                                      rows[i].first,
                                      rows[i - 1].first));
        }
        if (rows[i].second < rows[i - 1].second) {
            return refuse(i,
                          fmt::format("the second number must not fall from row to row: {} follows {}",
                                      rows[i].second,
                                      rows[i - 1].second));
        }
    }
    return PiecewiseLine(rows);
}

std::optional<Layer> find_layer(const CheckedTable& table, const BuildContext& context) {
    const Layer layer{.on = value_of(strain_part_choices, table.get<std::string>("on")),
                      .stiffness = table.get<double>("stiffness"),
                      .limit = table.get<double>("limit"),
                      .limit_per_tension = table.get<double>("limit_per_tension")};
    if (layer.on == StrainPart::tension && layer.limit_per_tension > 0.0) {
        context.add_fault(
            table, "limit_per_tension", "a layer on tension has a limit that does not depend on tension");
        return std::nullopt;
    }
    if (layer.limit > 0.0 || layer.limit_per_tension > 0.0) return layer;
    context.add_fault(
        table, "limit", "expected a number greater than 0, or limit_per_tension greater than 0, found 0");
    return std::nullopt;
}

SharedLaw make_layered_law(const CheckedTable& law, const Mat6& C, const BuildContext& context) {
    std::vector<Layer> layers;
    for (const CheckedTable& table : law.tables("layers")) {
        const std::optional<Layer> layer = find_layer(table, context);
        if (layer) layers.push_back(*layer);
    }
    return std::make_shared<LayeredLaw>(C, std::move(layers));
}

// nullopt, with a fault, if it is not what a curve of moments must be.
std::optional<MomentCurve> find_curve(
    const CheckedTable& table, const char* key, StrainPart on, const Mat6& C, const BuildContext& context) {
    const std::optional<PiecewiseLine> line = find_line(table, key, 0.0, context);
    if (!line) return std::nullopt;
    if (line->slope(0) <= 0.0) {
        add_row_fault(table, key, 1, "expected a moment greater than 0", context);
        return std::nullopt;
    }
    const std::optional<std::size_t> rising = find_rising_slope(*line);
    if (rising && value_of(hysteresis_choices, table.get<std::string>("hysteresis"))) {
        add_row_fault(
            table,
            key,
            *rising + 1,
            fmt::format("a section that yields gets softer from row to row; the slope {} follows {}",
                        line->slope(*rising),
                        line->slope(*rising - 1)),
            context);
        return std::nullopt;
    }
    const StrainEntries entries = entries_of(on);
    // A curve for both replaces what couples them, too.
    Mat6 others = C;
    if (entries.count == 2) others(4, 5) = others(5, 4) = 0.0;
    if (couples(others, entries.list())) {
        context.add_fault(table,
                          key,
                          "the stiffness couples this bending with another strain, which a table of moments "
                          "cannot; expected a stiffness without, such as stiffness = { … }");
        return std::nullopt;
    }
    return MomentCurve{on, *line};
}

SharedLaw make_curve_law(const CheckedTable& table, const Mat6& C, const BuildContext& context) {
    std::vector<MomentCurve> curves;
    const auto add = [&](const char* key, StrainPart on) {
        if (!table.gives(key)) return;
        std::optional<MomentCurve> curve = find_curve(table, key, on, C, context);
        if (curve) curves.push_back(std::move(*curve));
    };
    add("table", StrainPart::bending);
    add("y", StrainPart::bending_y);
    add("z", StrainPart::bending_z);
    if (value_of(hysteresis_choices, table.get<std::string>("hysteresis")))
        return make_kinematic_law(C, curves);
    return std::make_shared<MomentCurvatureLaw>(C, std::move(curves));
}

// A factor on limits over plastic strain; nullopt without one, or with a fault.
std::optional<PiecewiseLine> find_isotropic(const CheckedTable& table, const BuildContext& context) {
    const CheckedValue* value = table.find("isotropic");
    if (value == nullptr) return std::nullopt;
    if (const auto* slope = std::get_if<double>(&value->value)) {
        if (*slope == 0.0) return std::nullopt;
        return PiecewiseLine({{0.0, 1.0}, {1.0, 1.0 + *slope}});
    }
    return find_line(table, "isotropic", 1.0, context);
}

SharedLaw make_plastic_law(const CheckedTable& table, const Mat6& C, const BuildContext& context) {
    YieldLimits yield{
        .limits = {},
        .interaction = value_of(yield_interaction_choices, table.get<std::string>("interaction")),
        .isotropic = find_isotropic(table, context),
        .kinematic = table.get<double>("kinematic")};
    const CheckedTable& limits = only(table, "yield");
    std::vector<int> entries;
    for (const auto& [word, entry] : resultant_choices) {
        if (!limits.gives(word)) continue;
        yield.limits.emplace_back(entry, limits.get<double>(word));
        entries.push_back(entry);
    }
    if (yield.interaction == YieldInteraction::none && couples_within(C, entries)) {
        context.add_fault(table,
                          "interaction",
                          "the stiffness couples resultants that yield, so that none yields by itself; "
                          "expected \"ellipsoid\"");
        return nullptr;
    }
    return std::make_shared<PlasticLaw>(C, yield);
}

SharedLaw make_viscoelastic_law(const CheckedTable& table, const Mat6& C, const BuildContext& context) {
    std::vector<PronyBranch> branches;
    const CheckedPairs& prony = table.get<CheckedPairs>("prony");
    for (std::size_t i = 0; i < prony.rows.size(); ++i) {
        const auto& [ratio, time] = prony.rows[i];
        if (time > 0.0)
            branches.push_back({ratio, time});
        else
            add_row_fault(table, "prony", i, "expected a time tau greater than 0, found 0", context);
    }
    std::vector<StrainPart> on;
    if (table.gives("on")) {
        for (const CheckedWord& word : table.get<std::vector<CheckedWord>>("on"))
            on.push_back(value_of(strain_part_choices, word.word));
    }
    return std::make_shared<ViscoelasticLaw>(C, std::move(branches), on);
}

// Layers in place of all stiffness but that of shear.
SharedLaw make_shape_law(const CheckedTable& table, const Mat6& C, const BuildContext& context) {
    const CheckedTable& material = only(table, "material");
    const CheckedTable& shape = only(table, "shape");
    const auto number = [](const CheckedTable& of, const char* key) { return of.get<double>(key); };
    const double E = number(material, "E");
    const double G = material.gives("G") ? number(material, "G") : E / (2.0 * (1.0 + number(material, "nu")));
    const YieldingMaterial yielding{E, G, number(material, "yield_stress")};
    constexpr double least_yield_strain = 1e-5;
    if (yielding.yield_stress < least_yield_strain * E) {
        context.notes.push_back(fmt::format(
            "{}: it is {:.2g} of E, where metals have 1e-3 and lead 2e-4; are both in one unit of stress?",
            material.path_of("yield_stress"),
            yielding.yield_stress / E));
    }
    std::vector<Layer> layers;
    if (shape.gives("circle")) {
        layers = make_tube_layers(number(only(shape, "circle"), "radius"), 0.0, yielding);
    } else if (shape.gives("tube")) {
        const CheckedTable& tube = only(shape, "tube");
        layers = make_tube_layers(number(tube, "outer_radius"), number(tube, "inner_radius"), yielding);
    } else {
        const CheckedTable& rectangle = only(shape, "rectangle");
        layers = make_rectangle_layers(
            number(rectangle, "width_y"), number(rectangle, "height_z"), C(3, 3) / G, yielding);
    }
    Mat6 shear = Mat6::Zero();
    shear.block<2, 2>(1, 1) = C.block<2, 2>(1, 1);
    return std::make_shared<LayeredLaw>(shear, std::move(layers));
}

SharedLaw make_law(const CheckedTable& table, const Mat6& C, const BuildContext& context) {
    const CheckedTable& law = only(table, "law");
    if (law.gives("layers")) return make_layered_law(law, C, context);
    if (law.gives("moment_curvature")) return make_curve_law(only(law, "moment_curvature"), C, context);
    if (law.gives("plastic")) return make_plastic_law(only(law, "plastic"), C, context);
    return make_viscoelastic_law(only(law, "viscoelastic"), C, context);
}

bool is_trapeze(const CheckedTable& section) {
    return section.gives("trapeze") && section.get<bool>("trapeze");
}

bool yields(const CheckedTable& section) {
    return section.gives("material") && only(section, "material").gives("yield_stress");
}

// Adds a fault at the key that gives the section its law.
void add_law_fault(const CheckedTable& table, const std::string& message, const BuildContext& context) {
    if (table.gives("law"))
        context.add_fault(table, "law", message);
    else if (yields(table))
        context.add_fault(only(table, "material"), "yield_stress", message);
    else
        context.add_fault(table, "trapeze", message);
}

}  // namespace

bool has_law(const CheckedTable& section) {
    return section.gives("law") || is_trapeze(section) || yields(section);
}

void set_law(const CheckedTable& table, Section& section, const BuildContext& context) {
    if (!has_law(table)) return;
    if (varies_along_rod(table)) {
        return add_law_fault(
            table,
            "a section with a law is the same all along a rod; expected no function of s in it",
            context);
    }
    if (table.gives("at") || table.gives("turn")) {
        return add_law_fault(
            table,
            "a law is about the rod and in its section axes; expected neither at nor turn in "
            "a section that has one",
            context);
    }
    if (table.gives("law") && yields(table)) {
        return add_law_fault(
            table, "yield_stress of the material is given too; only one of them can be", context);
    }
    // One that is at fault itself.
    const Mat6 C = section.stiffness;
    if (!(C.diagonal().array() > 0.0).all()) return;
    SharedLaw law;
    if (table.gives("law")) law = make_law(table, C, context);
    if (yields(table)) law = make_shape_law(table, C, context);
    if (is_trapeze(table)) law = std::make_shared<TrapezeLaw>(C, std::move(law));
    if (!law) return;
    const std::vector<double> memory(static_cast<std::size_t>(law->memory_size()));
    section.stiffness =
        law->respond(Vec6::Zero(), memory, std::numeric_limits<double>::infinity(), {}).tangent;
    section.law = std::move(law);
}

}  // namespace gxrod
