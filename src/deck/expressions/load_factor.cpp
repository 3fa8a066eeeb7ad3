#include "deck/expressions/load_factor.hpp"

namespace gxrod {

TimeFunction apply_load_factor(const TimeFunction& function) {
    if (function.has_time() || function.is_zero()) return function;
    return TimeFunction([function](double t) { return t * function(t); });
}

LineFunction apply_load_factor(const LineExpression& expression) {
    if (expression.has_time || expression.function.is_zero()) return expression.function;
    const LineForm form = expression.function.form();
    const InTime in_time = form.in_time == InTime::constant ? InTime::proportional : InTime::varying;
    return LineFunction([function = expression.function](double t, double s) { return t * function(t, s); },
                        expression.function.switches(),
                        {in_time, form.is_even});
}

}  // namespace gxrod
