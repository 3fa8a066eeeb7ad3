#include <cmath>
#include <string>

#include "deck/expressions/expression.hpp"
#include "fuzz/expectation.hpp"
#include "fuzz/inputs.hpp"
#include "model/evaluation_error.hpp"

namespace gxrod::fuzz {
namespace {

Symbols make_symbols() {
    Symbols symbols;
    symbols.parameters = {{"EI", 500.0}, {"L", -0.25}, {"wrong", std::nullopt}};
    symbols.functions = {{"pulse", FunctionDefinition{{{0.0, 0.0}, {2.5, 200.0}, {5.0, 0.0}}, ""}},
                         {"wave", FunctionDefinition{{}, "sin(2*pi*t)*EI"}},
                         {"chain", FunctionDefinition{{}, "wave(t)+pulse(t/2)"}},
                         {"broken", std::nullopt}};
    return symbols;
}

template <class Action>
void try_kind(Action&& action) {
    try {
        action();
    } catch (const ExpressionError& error) {
        expect(!std::string(error.what()).empty(), "an expression is refused without a reason");
    } catch (const EvaluationError&) {
        return;
    }
}

}  // namespace

void try_expression(std::string_view input) {
    static const Symbols symbols = make_symbols();
    const std::string text(input);
    try_kind([&] {
        if (const auto value = evaluate_constant(text, symbols)) {
            expect(std::isfinite(*value), "a constant is not finite");
            expect(evaluate_constant(text, symbols) == value, "a constant has two values");
        }
    });
    for (const double time : {0.0, 1.3, -2e300}) {
        try_kind([&] {
            if (const auto function = compile_time_function(text, "key", symbols)) {
                expect(std::isfinite((*function)(time)), "a function of time is not finite");
            }
        });
        try_kind([&] {
            if (const auto function = compile_line_function(text, "key", symbols)) {
                expect(std::isfinite(function->function(time, 0.5)), "a function along a line is not finite");
            }
        });
        try_kind([&] {
            if (const auto function = compile_place_function(text, "key", symbols)) {
                expect(std::isfinite(function->function(Vec3(1.0, time, -3.0), 0.5)),
                       "a function of the place is not finite");
            }
        });
    }
}

}  // namespace gxrod::fuzz
