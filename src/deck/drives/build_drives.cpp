#include "deck/drives/build_drives.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/checks/check_moves.hpp"
#include "deck/drives/place_field.hpp"
#include "deck/drives/tendon_path.hpp"
#include "deck/loads/acting.hpp"
#include "deck/places/part.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"
#include "model/element_means.hpp"

namespace gxrod {
namespace {

// The rod of a table; nullopt, with a fault, if there is none.
std::optional<int> find_rod(const CheckedTable& table, const TableSpec& spec, const BuildContext& context) {
    const std::optional<Part> part = find_part(table, *spec.find("on"), context);
    return part ? std::optional(part->rod) : std::nullopt;
}

const Rod& rod_of(int index, const BuildContext& context) {
    return context.model.rods[static_cast<std::size_t>(index)];
}

// What is wrong with a path where elements look at it.
void check_path(const CheckedTable& table, const Tendon& tendon, const BuildContext& context) {
    try {
        for (const double s : list_force_points(rod_of(tendon.rod, context))) {
            if (s > tendon.from && s < tendon.to) tendon.path(s);
        }
    } catch (const EvaluationError& error) {
        // Its text begins with the key, "tendon.pull.offset[1]".
        const std::string text = error.what();
        const std::size_t end = text.find(": ");
        context.faults.add(table.place_of("offset"), text.substr(0, end), text.substr(end + 2));
    }
}

bool is_explicit(const AnalysisSettings& analysis) {
    const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
    return dynamic != nullptr && dynamic->scheme == Scheme::runge_kutta_4;
}

// Keys that need a winch, or do not go with one.
void check_winch_keys(const CheckedTable& table, const BuildContext& context) {
    if (table.gives("tension") && table.gives("slack"))
        context.add_fault(table, "slack", "goes with shortening or length, not with a tension");
    if (table.gives("tension") && table.gives("stiffness") && !table.gives("friction"))
        context.add_fault(
            table, "stiffness", "goes with shortening or length, or with a tension and friction");
    if (table.gives("length") && table.gives("factor"))
        context.add_fault(table, "factor", "of a length has no meaning; expected shortening in its place");
}

// How a value of a length that grows without t comes from the length at t = 0 to its own.
TimeFunction find_share(const TimeFunction& length, const Acting& acting) {
    return length.has_time() ? TimeFunction(1.0) : acting.apply(TimeFunction(1.0));
}

std::optional<TendonWinch> make_winch(const CheckedTable& table,
                                      double length,
                                      const Acting& acting,
                                      const BuildContext& context) {
    if (table.gives("tension")) return std::nullopt;
    TendonWinch winch{.pulls_only = !table.gives("slack") || table.get<bool>("slack"),
                      .is_released = acting.is_absent};
    if (table.gives("stiffness")) winch.stiffness = table.get<double>("stiffness");
    if (winch.stiffness == 0.0 && winch.pulls_only && is_explicit(context.analysis()))
        context.add_fault(table,
                          "slack",
                          "a tendon that does not stretch cannot become taut in an explicit scheme; expected "
                          "a stiffness, or slack = false");
    if (table.gives("length")) {
        const auto& function = table.get<CheckedTimeFunction>("length").function;
        winch.length = function;
        winch.share = find_share(function, acting);
        return winch;
    }
    const auto& shortening = table.get<CheckedTimeFunction>("shortening");
    winch.shortening = acting.apply(shortening.function);
    if (winch.stiffness == 0.0) check_move(shortening, length, context);
    return winch;
}

// A winch's length would depend on the tension all along.
std::optional<CapstanFriction> make_friction(const CheckedTable& table, const BuildContext& context) {
    const double coefficient = table.get<double>("friction");
    if (coefficient == 0.0) {
        if (table.gives("pulled_at") && !table.gives("friction"))
            context.add_fault(table, "pulled_at", "goes with friction; without it both ends are alike");
        return std::nullopt;
    }
    if (!table.gives("tension")) {
        context.add_fault(table,
                          "friction",
                          "goes with a tension, not with shortening or length; expected tension, which an "
                          "input can control");
        return std::nullopt;
    }
    return CapstanFriction{
        .coefficient = coefficient,
        .stiffness = table.gives("stiffness") ? table.get<double>("stiffness") : 0.0,
        .is_pulled_at_start = value_of(tendon_end_choices, table.get<std::string>("pulled_at"))};
}

void add_tendon(const CheckedTable& table, BuildContext& context) {
    const std::optional<int> rod = find_rod(table, tendon_table(), context);
    const std::optional<TendonRange> range = find_tendon_range(table, context);
    if (!rod || !range) return;
    if (context.deck.tables("rod")[static_cast<std::size_t>(*rod)].gives("mesh"))
        return context.add_fault(table, "on", "a rod from a mesh has no tendons; expected one along a line");
    const double length = rod_of(*rod, context).length;
    check_winch_keys(table, context);
    const Acting acting = find_acting(table, context);
    Tendon tendon{.name = table.name,
                  .rod = *rod,
                  .from = range->from * length,
                  .to = range->to * length,
                  .path = make_tendon_path(table.get<CheckedTendonPath>("offset"), *range, length),
                  .winch = make_winch(table, length, acting, context),
                  .friction = make_friction(table, context)};
    if (!tendon.winch) tendon.tension = acting.apply(table.get<CheckedTimeFunction>("tension").function);
    if (context.stage == 0) check_path(table, tendon, context);
    context.model.tendons.push_back(std::move(tendon));
}

bool expands(const Section& section) { return section.expansion != 0.0; }

// Heat needs a section that expands.
void check_expansion(const CheckedTable& table, const Rod& rod, const BuildContext& context) {
    const char* key = table.gives("temperature") ? "temperature" : "temperature_gradient";
    if (!table.gives(key) || context.model.sections.empty()) return;
    const Section& section = context.model.sections[static_cast<std::size_t>(rod.section)];
    if (std::ranges::any_of(rod.varying.at_forces, expands) ||
        (!rod.has_varying_sections() && expands(section)))
        return;
    context.add_fault(
        table,
        key,
        fmt::format("the section of the rod {} has no expansion, so that heat does nothing; expected "
                    "a key expansion of its [section.NAME]",
                    rod.name));
}

// Components of a key that the deck gives.
template <std::size_t Count>
std::array<LineFunction, Count> functions_of(const CheckedTable& table,
                                             const char* key,
                                             const Acting& acting) {
    std::array<LineFunction, Count> functions;
    if (!table.gives(key)) return functions;
    const auto& components = table.get<std::array<CheckedLineFunction, Count>>(key);
    for (std::size_t i = 0; i < Count; ++i) functions[i] = acting.apply(components[i].expression);
    return functions;
}

LineFunction function_of(const CheckedTable& table, const char* key, const Acting& acting) {
    if (!table.gives(key)) return {};
    return acting.apply(table.get<CheckedLineFunction>(key).expression);
}

void add_actuation(const CheckedTable& table, BuildContext& context) {
    const std::optional<int> rod = find_rod(table, actuation_table(), context);
    const Acting acting = find_acting(table, context);
    if (!rod || acting.is_absent) return;
    check_expansion(table, rod_of(*rod, context), context);
    const std::array<LineFunction, 2> shear = functions_of<2>(table, "shear", acting);
    const std::array<LineFunction, 3> curvature = functions_of<3>(table, "curvature", acting);
    const std::array<LineFunction, 2> gradient = functions_of<2>(table, "temperature_gradient", acting);
    const auto means = [&](const LineFunction& one) {
        return take_element_means(one, rod_of(*rod, context));
    };
    context.model.actuations.push_back({.key = table.path,
                                        .rod = *rod,
                                        .strain = {means(function_of(table, "stretch", acting)),
                                                   means(shear[0]),
                                                   means(shear[1]),
                                                   means(curvature[0]),
                                                   means(curvature[1]),
                                                   means(curvature[2])},
                                        .temperature = means(function_of(table, "temperature", acting)),
                                        .temperature_gradient = {means(gradient[0]), means(gradient[1])}});
}

void add_magnetic(const CheckedTable& table, BuildContext& context) {
    const std::optional<int> rod = find_rod(table, magnetic_table(), context);
    const Acting acting = find_acting(table, context);
    if (!rod || acting.is_absent) return;
    DistributedLoad load{
        .key = table.path, .rod = *rod, .force = {}, .moment = {}, .frame = Frame::body, .field = {}};
    const auto& moment = table.get<CheckedLineVector>("moment");
    for (std::size_t i = 0; i < 3; ++i) load.moment[i] = moment[i].expression.function;
    // The field grows and follows factors; the moment does not, or their product would grow twice.
    PlaceField field = make_field(table.get<CheckedMotionVector>("field"), acting);
    load.field = MagneticField{std::move(field.uniform), std::move(field.by_place)};
    context.model.distributed_loads.push_back(std::move(load));
}

}  // namespace

void build_drives(BuildContext& context) {
    for (const CheckedTable& table : context.deck.tables("tendon")) add_tendon(table, context);
    for (const CheckedTable& table : context.deck.tables("actuation")) add_actuation(table, context);
    for (const CheckedTable& table : context.deck.tables("magnetic")) add_magnetic(table, context);
}

}  // namespace gxrod
