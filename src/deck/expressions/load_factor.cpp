#include "deck/expressions/load_factor.hpp"

namespace gxrod {

TimeFunction apply_load_factor(const TimeFunction& function) {
    if (!function.is_constant() || function.is_zero()) return function;
    return TimeFunction([value = function(0.0)](double t) { return t * value; });
}

LineFunction apply_load_factor(const LineExpression& expression) {
    if (expression.has_time || expression.function.is_zero()) return expression.function;
    return LineFunction([function = expression.function](double t, double s) { return t * function(t, s); },
                        expression.function.switches(),
                        {InTime::proportional, expression.function.form().is_even});
}

}  // namespace gxrod
