#include "deck/checks/check_functions.hpp"

#include "deck/build/acting.hpp"
#include "deck/build/part.hpp"
#include "deck/build/sample_times.hpp"
#include "deck/joints/joint_coordinates.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"
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

void check_vector(const CheckedTable& table,
                  const char* key,
                  const std::vector<double>& times,
                  const BuildContext& context) {
    if (!table.gives(key)) return;
    for (const CheckedTimeFunction& component : table.get<CheckedTimeVector>(key)) {
        check(component, times, context);
    }
}

void check_line_vector(const CheckedTable& table,
                       const char* key,
                       double length,
                       const BuildContext& context) {
    if (!table.gives(key)) return;
    const std::vector<double> times = sample_times(context.analysis(), most_line_samples);
    for (const CheckedLineFunction& component : table.get<CheckedLineVector>(key)) {
        report_error(component, context, [&] {
            for (const double time : times) {
                for (long i = 0; i <= most_line_samples; ++i) {
                    component.expression.function(
                        time, length * (static_cast<double>(i) / static_cast<double>(most_line_samples)));
                }
            }
        });
    }
}

}  // namespace

void check_functions(const BuildContext& context) {
    const std::vector<double> times = sample_times(context.analysis(), most_samples);
    check_vector(context.deck, "gravity", times, context);
    for (const CheckedTable& load : context.deck.tables("load")) {
        if (find_acting(load, context).is_absent) continue;
        if (load.gives("factor")) {
            for (const CheckedNamedFunction& factor : load.get<std::vector<CheckedNamedFunction>>("factor")) {
                if (factor.name.empty() || factor.name == context.stages[context.stage].name)
                    check(factor.value, times, context);
            }
        }
        if (load.gives("force")) {
            for (const CheckedMotionFunction& component : load.get<CheckedMotionVector>("force"))
                check({component.expression.by_time, component.place, component.path}, times, context);
        }
        check_vector(load, "moment", times, context);
        if (!load.gives("on")) continue;
        const std::optional<int> rod = find_index(context.deck.tables("rod"), load.get<std::string>("on"));
        if (!rod) continue;
        for (const char* key : {"force_per_length", "moment_per_length"}) {
            check_line_vector(load, key, context.model.rods[*rod].length, context);
        }
    }
    for (const CheckedTable& support : context.deck.tables("support")) {
        if (!support.gives("move") || !acts_in_stage(support, context)) continue;
        for (const CheckedValue& move : support.tables("move").front().values) {
            check(std::get<CheckedTimeFunction>(move.value), times, context);
        }
    }
    for (const CheckedTable& joint : context.deck.tables("joint")) {
        for (const CheckedTimeFunction* function : functions_of(joint)) check(*function, times, context);
    }
}

}  // namespace gxrod
