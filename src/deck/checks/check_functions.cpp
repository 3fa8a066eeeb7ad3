#include "deck/checks/check_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/drives/chamber_table.hpp"
#include "deck/joints/joint_table.hpp"
#include "deck/loads/acting.hpp"
#include "deck/output/sample_times.hpp"
#include "deck/places/part.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/top_level.hpp"
#include "deck/supports/support_merge.hpp"
#include "deck/surroundings/presence.hpp"
#include "deck/table/place_kinds.hpp"
#include "model/evaluation_error.hpp"

namespace gxrod {
namespace {

constexpr long most_samples = 10000;
constexpr long most_line_samples = 100;  // in time and in space

// Calls `evaluate`, whose error becomes a fault of the value.
template <class Value, class Evaluate>
void report_error(const Value& value, const BuildContext& context, const Evaluate& evaluate) {
    try {
        evaluate();
    } catch (const EvaluationError& error) {
        context.add_evaluation_fault(value.place, value.path, error);
    }
}

void check(const CheckedTimeFunction& value, const std::vector<double>& times, const BuildContext& context) {
    if (value.function.is_constant()) return;
    report_error(value, context, [&] {
        for (const double time : times) value.function(time);
    });
}

template <class Value>
void check_along(const Value& value,
                 const LineFunction& function,
                 double length,
                 const BuildContext& context) {
    if (function.is_constant()) return;
    report_error(value, context, [&] {
        for (const double time : sample_times(context.analysis(), most_line_samples)) {
            for (long i = 0; i <= most_line_samples; ++i) {
                function(time, length * (static_cast<double>(i) / static_cast<double>(most_line_samples)));
            }
        }
    });
}

// The lengths of the rods that a table names, unless it concerns a part of them.
std::vector<double> list_lengths(const TableHead& table, const BuildContext& context) {
    std::vector<double> lengths;
    const auto add = [&](const std::string& name) {
        for (const int rod : context.names.find_rods(name))
            lengths.push_back(context.model.rods[static_cast<std::size_t>(rod)].length);
    };
    if (!values_of<PlaceCondition>(table).empty()) return lengths;
    for (const TableName& rod : values_of<TableName>(table)) add(rod.word);
    for (const TableNames& rods : values_of<TableNames>(table)) {
        if (table.key_of(&rods).name != "on") continue;
        for (const CheckedWord& rod : rods.names) add(rod.word);
    }
    return lengths;
}

void check_along(const TableHead& table, double length, const BuildContext& context) {
    const auto check_all = [&](const auto& vectors) {
        for (const auto& vector : vectors) {
            for (const CheckedLineFunction& component : vector.get())
                check_along(component, component.expression.function, length, context);
        }
    };
    for (const CheckedLineFunction& one : values_of<CheckedLineFunction>(table))
        check_along(one, one.expression.function, length, context);
    for (const CheckedLineMotionVector& vector : values_of<CheckedLineMotionVector>(table)) {
        for (const CheckedLineMotionFunction& component : vector)
            check_along(component, component.expression.by_line.function, length, context);
    }
    check_all(values_of<CheckedLinePair>(table));
    check_all(values_of<CheckedLineVector>(table));
}

// The factor of the stage at hand.
void check_factor(const ActingTable& table, const std::vector<double>& times, const BuildContext& context) {
    if (!table.factor) return;
    for (const CheckedNamedFunction& factor : *table.factor) {
        if (factor.name.empty() || factor.name == context.stages[context.stage].name)
            check(factor.value, times, context);
    }
}

// Forces and fields by what of them depends on time alone.
void check_by_time(const CheckedMotionVector& vector,
                   const std::vector<double>& times,
                   const BuildContext& context) {
    for (const CheckedMotionFunction& component : vector)
        check({component.expression.by_time, component.place, component.path}, times, context);
}

// All functions of a table, those of the arc length along the rod that it names.
void check_values(const ActingTable& table, const std::vector<double>& times, const BuildContext& context) {
    if (find_acting(table, context).is_absent) return;
    check_factor(table, times, context);
    for (const CheckedTimeFunction& one : values_of<CheckedTimeFunction>(table)) check(one, times, context);
    for (const CheckedTimeVector& vector : values_of<CheckedTimeVector>(table)) {
        for (const CheckedTimeFunction& component : vector) check(component, times, context);
    }
    for (const CheckedMotionVector& vector : values_of<CheckedMotionVector>(table))
        check_by_time(vector, times, context);
    for (const FieldVector& vector : values_of<FieldVector>(table))
        check_by_time(vector.components, times, context);
    for (const double length : list_lengths(table, context)) check_along(table, length, context);
}

// With friction a tendon only pulls.
void check_pull(const TendonTable& tendon, const std::vector<double>& times, const BuildContext& context) {
    constexpr double round_off = 1e-12;
    const Acting acting = find_acting(tendon, context);
    if (!tendon.tension || tendon.friction == 0.0 || acting.is_absent) return;
    const CheckedTimeFunction& tension = *tendon.tension;
    const TimeFunction pull = acting.apply(tension.function);
    double largest = 0.0, least = 0.0, when = 0.0;
    try {
        for (const double time : times) {
            const double value = pull(time);
            largest = std::max(largest, std::abs(value));
            if (value < least) when = time;
            least = std::min(least, value);
        }
    } catch (const EvaluationError&) {
        return;  // said already
    }
    if (least >= -round_off * largest) return;
    context.faults.add(tension.place,
                       tension.path,
                       fmt::format("is {} at t = {}; a tendon with friction only pulls: expected at least 0, "
                                   "such as max(…, 0)",
                                   least,
                                   when));
}

// The factor of water or ground that is there, which neither pulls out of itself.
void check_presence(const ActingTable& table, const std::vector<double>& times, const BuildContext& context) {
    check_factor(table, times, context);
    const TimeFunction factor = find_presence(table, context);
    const double round_off = -1e-12;
    for (const double time : times) {
        double value = 0.0;
        try {
            value = factor(time);
        } catch (const EvaluationError&) {
            return;  // said already
        }
        if (value >= round_off) continue;
        return context.add_fault(
            table, table.factor, fmt::format("is {:.6g} at t = {:.6g}; expected at least 0", value, time));
    }
}

}  // namespace

void check_functions(const BuildContext& context) {
    const std::vector<double> times = sample_times(context.analysis(), most_samples);
    if (const CheckedTimeVector* gravity = find_gravity(context.deck)) {
        for (const CheckedTimeFunction& component : *gravity) check(component, times, context);
    }
    for (const TableSpec* spec :
         {&load_table(), &tendon_table(), &chamber_table(), &actuation_table(), &magnetic_table()}) {
        for (const ActingTable& table : tables_of<ActingTable>(context.deck, *spec))
            check_values(table, times, context);
    }
    for (const ChamberTable& chamber : tables_of<ChamberTable>(context.deck, chamber_table())) {
        if (chamber.gas) check(chamber.gas->pressure, times, context);
    }
    for (const TendonTable& tendon : tables_of<TendonTable>(context.deck, tendon_table()))
        check_pull(tendon, times, context);
    for (const FluidTable& fluid : tables_of<FluidTable>(context.deck, fluid_table())) {
        check_presence(fluid, times, context);
        if (fluid.current) check_values(*fluid.current, times, context);
    }
    for (const AirTable& air : tables_of<AirTable>(context.deck, air_table())) {
        if (air.wind) check_values(*air.wind, times, context);
    }
    for (const SeabedTable& seabed : tables_of<SeabedTable>(context.deck, seabed_table()))
        check_presence(seabed, times, context);
    for (const SupportTable& support : tables_of<SupportTable>(context.deck, support_table())) {
        if (!support.move || !acts_in_stage(support, context)) continue;
        for (const CheckedTimeFunction& move : values_of<CheckedTimeFunction>(*support.move))
            check(move, times, context);
    }
    for (const JointTable& joint : tables_of<JointTable>(context.deck, joint_table())) {
        for (const CheckedTimeFunction* function : functions_of(joint)) check(*function, times, context);
    }
}

}  // namespace gxrod
