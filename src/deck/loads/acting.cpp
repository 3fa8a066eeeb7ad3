#include "deck/loads/acting.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/drives/chamber_table.hpp"
#include "deck/expressions/load_factor.hpp"
#include "deck/loads/combinations.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/schema/top_level.hpp"
#include "deck/surroundings/surroundings_tables.hpp"
#include "model/settings/analysis_traits.hpp"

namespace gxrod {
namespace {

std::optional<std::size_t> find_stage(const std::string& name, const BuildContext& context) {
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        if (context.stages[i].name == name) return i;
    }
    return std::nullopt;
}

// Where what has no t begins to act: at once in time, growing in statics.
const StagePlan& find_first_with_steps(const BuildContext& context) {
    const auto end = context.stages.begin() + static_cast<std::ptrdiff_t>(context.stage);
    return *std::find_if(
        context.stages.begin(), end, [](const StagePlan& stage) { return has_steps(stage.analysis); });
}

TimeFunction hold(const TimeFunction& value, const Acting& acting) {
    const std::optional<TimeFunction>& factor = acting.factor;
    const std::shared_ptr<const double>& end = acting.held_at;
    if (factor)
        return TimeFunction([value, factor = *factor, end](double) { return value(*end) * factor(*end); });
    if (value.has_time() || value.is_zero()) return value;
    return TimeFunction([value, end](double t) { return *end * value(t); });
}

// What switches with the arc length alone stays where it is at that time.
std::shared_ptr<const Switches> hold_switches(const LineFunction& function,
                                              const std::shared_ptr<const double>& end) {
    if (!function.switches()) return nullptr;
    auto switches = std::make_shared<Switches>();
    for (Switch one : *function.switches()) {
        if (!one.has_arc_length) continue;
        one.argument = [argument = one.argument, end](double, double s) { return argument(*end, s); };
        one.has_time = false;
        switches->push_back(std::move(one));
    }
    return switches->empty() ? nullptr : switches;
}

LineFunction hold(const LineExpression& value, const Acting& acting) {
    const std::optional<TimeFunction>& factor = acting.factor;
    const std::shared_ptr<const double>& end = acting.held_at;
    const LineFunction& function = value.function;
    if (!factor && value.has_time) return function;
    const LineForm form{InTime::constant, function.form().is_even};
    const auto scale = factor.value_or(TimeFunction([](double t) { return t; }));
    return LineFunction([function, scale, end](double, double s) { return scale(*end) * function(*end, s); },
                        hold_switches(function, end),
                        form);
}

const CheckedTimeFunction* find_factor(const StageFunctions& functions, const std::string& stage) {
    const auto found = std::find_if(functions.begin(), functions.end(), [&](const CheckedNamedFunction& one) {
        return one.name.empty() || one.name == stage;
    });
    return found == functions.end() ? nullptr : &found->value;
}

// The last stage before the one at hand that names a factor.
std::optional<std::size_t> find_earlier(const StageFunctions& functions, const BuildContext& context) {
    for (std::size_t i = context.stage; i-- > 0;) {
        if (find_factor(functions, context.stages[i].name) != nullptr) return i;
    }
    return std::nullopt;
}

void check_name(const Place& place,
                const std::string& path,
                const std::string& name,
                const BuildContext& context) {
    const std::optional<std::size_t> stage = find_stage(name, context);
    if (!stage || name.empty()) {
        std::vector<std::string> known;
        for (const StagePlan& one : context.stages) {
            if (!one.name.empty()) known.push_back(one.name);
        }
        const std::string nearest = did_you_mean(name, known);
        const std::string hint = !nearest.empty() ? nearest
                                 : known.empty()  ? "; the deck has no [[stage]]"
                                                  : "; the deck has " + plain_list(known);
        return context.faults.add(place, path, fmt::format("no stage \"{}\"{}", name, hint));
    }
    if (has_steps(context.stages[*stage].analysis)) return;
    context.faults.add(
        place,
        path,
        fmt::format("stage \"{}\" moves nothing: it has the loads and supports of the stage before it",
                    name));
}

void check_stage_names(const ActingTable& table, const BuildContext& context) {
    if (table.relative_to && !follows_limits(context.stages))
        context.add_fault(table, table.relative_to, "no stage follows a limit point");
    if (table.stages) {
        for (const CheckedWord& word : table.stages->names)
            check_name(word.place, word.path, word.word, context);
    }
    if (!table.factor) return;
    for (const CheckedNamedFunction& one : *table.factor) {
        if (!one.name.empty()) check_name(one.value.place, one.value.path, one.name, context);
    }
}

}  // namespace

TimeFunction Acting::apply(const TimeFunction& value) const {
    const TimeFunction own = scale_own(apply_own(value));
    if (!limit_load_factor || own.is_zero()) return own;
    return TimeFunction([own, limit = limit_load_factor](double t) { return *limit * own(t); },
                        own.switches());
}

LineFunction Acting::apply(const LineExpression& value) const {
    const LineFunction own = scale_own(apply_own(value));
    if (!limit_load_factor || own.is_zero()) return own;
    return LineFunction([own, limit = limit_load_factor](double t, double s) { return *limit * own(t, s); },
                        own.switches(),
                        own.form());
}

TimeFunction Acting::scale_own(const TimeFunction& own) const {
    if (scale == 1.0 || own.is_zero()) return own;
    if (own.is_constant() || scale == 0.0) return TimeFunction(scale * own(0.0));
    return TimeFunction([own, by = scale](double t) { return by * own(t); }, own.switches(), own.has_time());
}

LineFunction Acting::scale_own(const LineFunction& own) const {
    if (scale == 1.0 || own.is_zero()) return own;
    if (own.is_constant()) return LineFunction(scale * own(0.0, 0.0));
    return LineFunction(
        [own, by = scale](double t, double s) { return by * own(t, s); }, own.switches(), own.form());
}

PointFunction Acting::apply(const PointFunction& by_motion, bool has_time) const {
    if (is_absent) return {};
    const TimeFunction factor_now = find_motion_factor(has_time);
    const auto held = held_at && (factor || !has_time) ? held_at : nullptr;
    return [own = by_motion, factor_now, held, by = scale, limit = limit_load_factor](
               double time, double s, const PointMotion& motion) {
        const double t = held ? *held : time;
        return by * (limit ? *limit : 1.0) * factor_now(t) * own(t, s, motion);
    };
}

TimeFunction Acting::find_motion_factor(bool has_time) const {
    if (factor) return *factor;
    const bool scales = !has_time && (held_at || grows);
    return scales ? TimeFunction([](double t) { return t; }) : TimeFunction(1.0);
}

TimeFunction Acting::apply_own(const TimeFunction& value) const {
    if (is_absent) return TimeFunction(0.0);
    if (value.is_zero()) return value;
    if (held_at) return hold(value, *this);
    if (!factor) return grows ? apply_load_factor(value) : value;
    if (factor->is_constant() && value.is_constant()) return TimeFunction(value(0.0) * (*factor)(0.0));
    const auto& switches = factor->switches() ? factor->switches() : value.switches();
    if (factor->switches() && value.switches()) {
        auto both = std::make_shared<Switches>(*factor->switches());
        both->insert(both->end(), value.switches()->begin(), value.switches()->end());
        return TimeFunction([value, factor = *factor](double t) { return factor(t) * value(t); }, both);
    }
    return TimeFunction([value, factor = *factor](double t) { return factor(t) * value(t); }, switches);
}

LineFunction Acting::apply_own(const LineExpression& value) const {
    const LineFunction& function = value.function;
    if (is_absent) return LineFunction(0.0);
    if (function.is_zero()) return function;
    if (held_at) return hold(value, *this);
    if (!factor) return grows ? apply_load_factor(value) : function;
    auto switches = std::make_shared<Switches>();
    if (function.switches()) *switches = *function.switches();
    if (factor->switches())
        switches->insert(switches->end(), factor->switches()->begin(), factor->switches()->end());
    return LineFunction(
        [function, factor = *factor](double t, double s) { return factor(t) * function(t, s); },
        switches->empty() ? nullptr : switches,
        {InTime::varying, function.form().is_even});
}

std::string factor_sentence(const std::string& what) {
    return "What the " + what +
           " is multiplied by, in a stage's own t. By stage: a stage that is not named keeps the last "
           "value, and before the first one there is no " +
           what + ".";
}

Acting find_acting(const BuildContext& context) {
    const StagePlan& first = find_first_with_steps(context);
    const bool is_first = &first == &context.stages[context.stage];
    if (is_first) return {.grows = !is_timed(context.analysis())};
    const bool grew_elsewhere = is_path(first.analysis);
    return {.held_at = grew_elsewhere ? first.end : nullptr};
}

namespace {

Acting find_own_acting(const ActingTable& load, const BuildContext& context) {
    if (!load.factor) return find_acting(context);
    const StageFunctions& functions = *load.factor;
    if (const CheckedTimeFunction* own = find_factor(functions, context.stages[context.stage].name))
        return {.factor = own->function};
    const std::optional<std::size_t> earlier = find_earlier(functions, context);
    if (!earlier) return {.is_absent = true};
    const StagePlan& stage = context.stages[*earlier];
    return {.factor = find_factor(functions, stage.name)->function, .held_at = stage.end};
}

// It grows in the stage that follows the limit point, and stays in later ones.
Acting find_relative_acting(const ActingTable& load, const BuildContext& context) {
    for (std::size_t i = context.stage + 1; i-- > 0;) {
        const auto* path = std::get_if<PathSettings>(&context.stages[i].analysis);
        if (path == nullptr || !path->limit_load_factor) continue;
        Acting acting{.grows = true};
        if (load.factor) acting = find_own_acting(load, context);
        if (i < context.stage && !acting.held_at && !acting.factor) acting.held_at = context.stages[i].end;
        acting.limit_load_factor = path->limit_load_factor;
        return acting;
    }
    return {.is_absent = true};
}

}  // namespace

Acting find_acting(const ActingTable& load, const BuildContext& context) {
    if (!acts_in_stage(load, context)) return {.is_absent = true};
    const double scale = find_case_factor(load.load_case, context);
    if (scale == 0.0) return {.is_absent = true};
    Acting acting = load.relative_to ? find_relative_acting(load, context) : find_own_acting(load, context);
    acting.scale = scale;
    return acting;
}

bool acts_in_stage(const ActingTable& table, const BuildContext& context) {
    return acts_in_stage(table, context.stage, context);
}

bool acts_in_stage(const ActingTable& table, std::size_t stage, const BuildContext& context) {
    if (!table.stages) return true;
    return std::ranges::any_of(table.stages->names, [&](const CheckedWord& word) {
        return word.word == context.stages[stage].name;
    });
}

void check_stage_names(const BuildContext& context) {
    for (const TableSpec* spec : {&load_table(),
                                  &support_table(),
                                  &joint_table(),
                                  &tendon_table(),
                                  &chamber_table(),
                                  &actuation_table(),
                                  &magnetic_table(),
                                  &wave_table()}) {
        for (const ActingTable& table : tables_of<ActingTable>(context.deck, *spec))
            check_stage_names(table, context);
    }
    if (const auto& given = top_level_of(context.deck).gravity) {
        if (const auto* gravity = std::get_if<GravityTable>(&*given)) check_stage_names(*gravity, context);
    }
    for (const FluidTable& fluid : tables_of<FluidTable>(context.deck, fluid_table())) {
        check_stage_names(fluid, context);
        if (fluid.current) check_stage_names(*fluid.current, context);
    }
    for (const AirTable& air : tables_of<AirTable>(context.deck, air_table())) {
        if (air.wind) check_stage_names(*air.wind, context);
    }
    for (const SeabedTable& seabed : tables_of<SeabedTable>(context.deck, seabed_table())) {
        check_stage_names(seabed, context);
        if (const auto* friction =
                seabed.friction ? std::get_if<BedFrictionTable>(&*seabed.friction) : nullptr)
            check_stage_names(*friction, context);
    }
}

}  // namespace gxrod
