#include "deck/expressions/expression.hpp"

#include <cmath>
#include <random>

#include "deck/expressions/expression_built_ins.hpp"
#include "deck/schema/suggestion.hpp"
#include "model/evaluation_error.hpp"
#include "tools/catch.hpp"

namespace gxrod {
namespace {

const Symbols none;

double value(const std::string& expression, const Symbols& symbols = none) {
    return evaluate_constant(expression, symbols).value();
}

// What is said of an expression that is refused; "" if it is not.
std::string refusal(const std::string& expression, const Symbols& symbols = none) {
    try {
        evaluate_constant(expression, symbols);
    } catch (const ExpressionError& error) {
        return error.what();
    }
    return "";
}

std::string time_refusal(const std::string& expression, const Symbols& symbols = none) {
    try {
        compile_time_function(expression, "load[0].force[1]", symbols);
    } catch (const ExpressionError& error) {
        return error.what();
    }
    return "";
}

TimeFunction function(const std::string& expression, const Symbols& symbols = none) {
    return compile_time_function(expression, "load[0].force[1]", symbols).value();
}

Symbols pulse_symbols() {
    Symbols symbols;
    symbols.parameters["EI"] = 500.0;
    symbols.parameters["broken"] = std::nullopt;
    symbols.functions["pulse"] = FunctionDefinition{{{0.0, 0.0}, {2.5, 200.0}, {5.0, 0.0}}, ""};
    symbols.functions["twice"] = FunctionDefinition{{}, "2*pulse(2*t) + EI"};
    symbols.functions["broken_function"] = std::nullopt;
    symbols.functions["on_broken"] = FunctionDefinition{{}, "broken_function(t)"};
    return symbols;
}

}  // namespace

TEST_CASE("Expressions have the values of their operators", "[deck]") {
    CHECK(value("1 + 2*3 - 4/8") == 6.5);
    CHECK(value("(1 + 2)*3") == 9.0);
    CHECK(value("2^10") == 1024.0);
    CHECK(value("2^3^2") == 512.0);
    CHECK(value("-2^2") == -4.0);
    CHECK(value("(-2)^2") == 4.0);
    CHECK(value("2^-1") == 0.5);
    CHECK(value("2*-3") == -6.0);
    CHECK(value("2--3") == 5.0);
    CHECK(value("+3") == 3.0);
    CHECK(value("8/4/2") == 1.0);
    CHECK(value("5 - 2 - 1") == 2.0);
    CHECK(value("1 < 2") == 1.0);
    CHECK(value("(1 < 2) == 1") == 1.0);
    CHECK(value("1 <= 1 && 2 >= 3 || 1 != 1") == 0.0);
    CHECK(value("1 || 1 && 0") == 1.0);
    CHECK(value("1 > 2 ? 3 : 4 > 3 ? 5 : 6") == 5.0);
    CHECK(value("1 + 1 ? 2 : 3") == 2.0);
    CHECK(value("1.5e3 + 1. + .5") == 1501.5);
    CHECK(value("0.1") == 0.1);
    CHECK(value(" 1\t+ 1 ") == 2.0);
}

TEST_CASE("Constants are joined by logic as variables are", "[deck]") {
    CHECK(value("0.5 && 0.25") == 1.0);
    CHECK(value("0.5 || 0") == 1.0);
    CHECK(value("abs(0.5) && 1 - 0.5") == 1.0);
    CHECK(function("0.5 && t")(0.25) == 1.0);
}

TEST_CASE("Built-in functions are those of the mathematical library", "[deck]") {
    CHECK(value("sin(0.3)") == std::sin(0.3));
    CHECK(value("cos(0.3)") == std::cos(0.3));
    CHECK(value("tan(0.3)") == std::tan(0.3));
    CHECK(value("asin(0.3)") == std::asin(0.3));
    CHECK(value("acos(0.3)") == std::acos(0.3));
    CHECK(value("atan(0.3)") == std::atan(0.3));
    CHECK(value("sinh(0.3)") == std::sinh(0.3));
    CHECK(value("cosh(0.3)") == std::cosh(0.3));
    CHECK(value("tanh(0.3)") == std::tanh(0.3));
    CHECK(value("exp(0.3)") == std::exp(0.3));
    CHECK(value("log(0.3)") == std::log(0.3));
    CHECK(value("log10(1000)") == 3.0);
    CHECK(value("sqrt(2)") == std::sqrt(2.0));
    CHECK(value("abs(-2)") == 2.0);
    CHECK(value("sign(-2) + sign(0) + 4*sign(3)") == 3.0);
    CHECK(value("atan2(1, -2)") == std::atan2(1.0, -2.0));
    CHECK(value("min(3, -2, 5)") == -2.0);
    CHECK(value("max(3, -2, 5, 4)") == 5.0);
    CHECK(value("min(7)") == 7.0);
    CHECK(value("max(1 < 2, 3 < 2)") == 1.0);
    CHECK(value("pi") == std::acos(-1.0));
    CHECK(built_in_functions().size() == 18);
}

TEST_CASE("min and max do not hide what is not a number", "[deck]") {
    CHECK(refusal("min(1, sqrt(-1))") == "the value is nan, not a finite number");
    CHECK(refusal("max(sqrt(-1), 1)") == "the value is nan, not a finite number");
}

TEST_CASE("Expressions that muParser would misread are refused in plain words", "[deck]") {
    CHECK(refusal("") == "the expression is empty");
    CHECK(refusal("x = 5") == R"("=" would assign; write "==" to compare)");
    CHECK(refusal("1,2") ==
          R"(a "," is outside a function call; an expression has one value, and "." is its decimal point)");
    CHECK(refusal("(1,2)") ==
          R"(a "," is outside a function call; an expression has one value, and "." is its decimal point)");
    CHECK(refusal("1/0") == "the value is inf, not a finite number");
    CHECK(refusal("sqrt(-1)") == "the value is nan, not a finite number");
    CHECK(refusal("0x1F") == "hexadecimal, octal and binary numbers are not read; write a decimal number");
    CHECK(refusal("0b11") == "hexadecimal, octal and binary numbers are not read; write a decimal number");
    CHECK(refusal("#1") == "hexadecimal, octal and binary numbers are not read; write a decimal number");
    CHECK(refusal("2t") == R"(an operator is missing between "2" and "t")");
    CHECK(refusal("2 3") == R"(an operator is missing between "2" and "3")");
    CHECK(refusal("(2)(3)") == R"x(an operator is missing between ")" and "(")x");
    CHECK(refusal("2*") == "the expression ends too early");
    CHECK(refusal("*2") == R"(the operator "*" is out of place)");
    CHECK(refusal("(1") == R"x(a ")" is missing)x");
    CHECK(refusal("1)") == R"x(a ")" has no "(")x");
    CHECK(refusal("1 ? 2") == R"(a "?" has no ":"; write condition ? a : b)");
    CHECK(refusal("1 : 2") == R"(a ":" has no "?"; write condition ? a : b)");
    CHECK(refusal("sin") == R"("sin" is a function; write sin(…))");
    CHECK(refusal("sin 1") == R"("sin" is a function; write sin(…))");
    CHECK(refusal("sin()") == R"("sin" has too few arguments)");
    CHECK(refusal("sin(1,2)") == R"("sin" has too many arguments)");
    CHECK(refusal("min()") == R"("min" has too few arguments)");
    CHECK(refusal("atan2(1)") == R"("atan2" has too few arguments)");
    CHECK(refusal("sni(1)") ==
          R"(unknown function "sni"; did you mean "sin"? available: )" + plain_list(built_in_functions()));
    CHECK(refusal("ln(2)") == R"(unknown function "ln"; did you mean "log" (natural)? available: )" +
                                  plain_list(built_in_functions()));
    CHECK(refusal("pow(2,3)") ==
          R"(unknown function "pow"; write a^b for a power; available: )" + plain_list(built_in_functions()));
    CHECK(refusal("2**3") == R"("**" is not an operator; write "^" for a power)");
    CHECK(refusal("!1") == R"x("!" is not available; write "(x == 0)" for "not x")x");
    CHECK(refusal("1 & 2") == R"("&" is not available; write "&&")");
    CHECK(refusal("1 | 2") == R"("|" is not available; write "||")");
    CHECK(refusal("'a'") == "an expression has no text in it");
    CHECK(
        refusal("1 < 2 < 3") ==
        R"(comparisons in a row compare the result 0 or 1 of the first; write "a < b && b < c", or parentheses if you mean it)");
    CHECK(
        refusal("1 == 1 == 1") ==
        R"(comparisons in a row compare the result 0 or 1 of the first; write "a < b && b < c", or parentheses if you mean it)");
    CHECK(refusal("5 % 2") == R"("%" is not an operator; available: + - * / ^ < <= > >= == != && || ?:)");
    CHECK(refusal("1;2") == R"(";" is not an operator; available: + - * / ^ < <= > >= == != && || ?:)");
    CHECK(refusal("µ") == R"("µ" is not an operator; available: + - * / ^ < <= > >= == != && || ?:)");
    CHECK(refusal("1_000") == R"("1_" is not a number)");
    CHECK(refusal("1.2.3") == R"("1.2." is not a number)");
    CHECK(refusal("1e400") == "1e400 is too large for a number");
    CHECK(refusal("pi(2)") == R"("pi" is not a function; write pi*(…))");
    CHECK(refusal("--2") == R"(the operator "-" is out of place)");
    CHECK(refusal("3 <> 4") == R"("<>" is not an operator; write "!=")");
    CHECK(refusal("1 ? 2 : 3 : 4") == R"(a ":" has no "?"; write condition ? a : b)");
    CHECK(refusal("log(0)") == "the value is -inf, not a finite number");
    CHECK(refusal("1 +* 2") == R"(the operator "*" is out of place)");
    CHECK(refusal("min(1,)") == R"x(the ")" is out of place)x");
    CHECK(refusal("nan") == R"(unknown name "nan"; available: pi)");
    CHECK(refusal("()") == R"x(the ")" is out of place)x");
    CHECK(refusal("t") == R"("t" (time) is not allowed here: this value is a constant)");
}

TEST_CASE("Parameters and functions have their values", "[deck]") {
    const Symbols symbols = pulse_symbols();
    CHECK(value("EI/2", symbols) == 250.0);
    CHECK(function("pulse(t)/10", symbols)(1.25) == 10.0);
    CHECK(function("-pulse(t - 1)", symbols)(2.25) == -100.0);
    CHECK(function("pulse(pulse(t)/100)", symbols)(1.25) == 80.0);
    CHECK(function("twice(t)", symbols)(1.25) == 900.0);
    CHECK(function("twice(t) - pulse(t)", symbols)(1.25) == 800.0);
    CHECK(function("200*sin(pi*t/5)^2")(2.0) == Approx(200.0 * std::pow(std::sin(0.4 * std::acos(-1.0)), 2)));
    CHECK(function("t < 2.5 ? 8 : (t == 2.5 ? 4 : 0)")(2.5) == 4.0);
}

TEST_CASE("An expression without time is a constant function", "[deck]") {
    const Symbols symbols = pulse_symbols();
    CHECK(function("3*EI", symbols).is_constant());
    CHECK(function("3*EI", symbols)(7.0) == 1500.0);
    CHECK(function("pulse(2.5)", symbols).is_constant());
    CHECK(function("pulse(2.5)", symbols)(0.0) == 200.0);
    CHECK(function("0").is_zero());
    CHECK_FALSE(function("0*t").is_constant());
    CHECK(time_refusal("1/0") == "the value is inf, not a finite number");
}

TEST_CASE("Two functions of time of one deck share nothing that they write to", "[deck]") {
    const Symbols symbols = pulse_symbols();
    const TimeFunction first = function("twice(t)", symbols);
    const TimeFunction second = function("twice(t) + t", symbols);
    const TimeFunction copy = first;
    CHECK(first(1.25) == 900.0);
    CHECK(second(0.0) == 500.0);
    CHECK(copy(1.25) == 900.0);
    CHECK(second(1.25) == 901.25);
}

TEST_CASE("A function of time says where it has no finite value", "[deck]") {
    const TimeFunction pole = function("1/(t - 2)");
    CHECK(pole(3.0) == 1.0);
    CHECK_THROWS_AS(pole(2.0), EvaluationError);
    CHECK_THROWS_WITH(pole(2.0), R"x(load[0].force[1]: "1/(t - 2)" is inf at t = 2)x");
    CHECK_THROWS_WITH(function("-sqrt(1 - t)")(1.5),
                      R"x(load[0].force[1]: "-sqrt(1 - t)" is nan at t = 1.5)x");
    CHECK_THROWS_WITH(function("log(t)")(0.0), R"x(load[0].force[1]: "log(t)" is -inf at t = 0)x");
    CHECK(pole(3.0) == 1.0);
}

TEST_CASE("Unknown names are named with what is available", "[deck]") {
    const Symbols symbols = pulse_symbols();
    CHECK(refusal("EJ + 1", symbols) == R"(unknown name "EJ"; available: pi, EI, broken)");
    CHECK(refusal("borken", symbols) ==
          R"(unknown name "borken"; did you mean "broken"? available: pi, EI, broken)");
    CHECK(time_refusal("2*tt", symbols) == R"(unknown name "tt"; available: pi, t, EI, broken)");
    CHECK(time_refusal("puls(t)", symbols) ==
          R"(unknown function "puls"; did you mean "pulse"? available: )" + plain_list(built_in_functions()) +
              ", broken_function, on_broken, pulse, twice");
    CHECK(time_refusal("pulse", symbols) == R"("pulse" is a function; write pulse(…))");
    CHECK(time_refusal("EI(t)", symbols) == R"("EI" is not a function; write EI*(…))");
    CHECK(time_refusal("t(2)", symbols) == R"("t" is not a function; write t*(…))");
    CHECK(time_refusal("t = 15 ? 1 : 2", symbols) == R"("=" would assign; write "==" to compare)");
    CHECK(
        time_refusal("0 < t < 5", symbols) ==
        R"(comparisons in a row compare the result 0 or 1 of the first; write "a < b && b < c", or parentheses if you mean it)");
    CHECK(refusal("pulse(1)", symbols) ==
          R"("pulse" is a function of time, which is not allowed here: this value is a constant)");
}

TEST_CASE("What rests on a wrong name is neither a value nor a second fault", "[deck]") {
    const Symbols symbols = pulse_symbols();
    CHECK_FALSE(evaluate_constant("2*broken", symbols).has_value());
    CHECK_FALSE(compile_time_function("t*broken", "", symbols).has_value());
    CHECK_FALSE(compile_time_function("broken_function(t)", "", symbols).has_value());
    CHECK_FALSE(compile_time_function("on_broken(t)", "", symbols).has_value());
    CHECK(refusal("2*broken*", symbols) == "the expression ends too early");
}

TEST_CASE("Any text is either an expression or refused", "[deck]") {
    const std::vector<std::string> pieces{"1", "0.5", "t",  "pi", "sin", "min", "pulse", "EI",
                                          "(", ")",   ",",  "+",  "-",   "*",   "/",     "^",
                                          "<", "==",  "&&", "?",  ":",   "=",   " ",     "x"};
    const Symbols symbols = pulse_symbols();
    std::mt19937 random(7);
    int read = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text;
        for (auto length = 1 + random() % 9; length > 0; --length) text += pieces[random() % pieces.size()];
        try {
            const auto compiled = compile_time_function(text, "key", symbols);
            REQUIRE(compiled.has_value());
            (*compiled)(0.5);
            ++read;
        } catch (const ExpressionError&) {
        } catch (const EvaluationError&) {
        }
    }
    CHECK(read > 100);
}

TEST_CASE("Functions along a rod have t and s", "[deck]") {
    const auto line = [](const std::string& expression, const Symbols& symbols = none) {
        return compile_line_function(expression, "load[0].force_per_length[1]", symbols).value();
    };
    CHECK(line("2*t + s").function(3.0, 0.5) == 6.5);
    CHECK(line("2*t + s").has_time);
    CHECK_FALSE(line("s^2").has_time);
    CHECK(line("s^2").function(7.0, 3.0) == 9.0);
    CHECK(line("0").function.is_zero());
    CHECK_FALSE(line("0*s").function.is_zero());
    CHECK(line("pulse(s)", pulse_symbols()).function(0.0, 2.5) == 200.0);
    CHECK(line("twice(t) + s", pulse_symbols()).has_time);
    CHECK_FALSE(compile_line_function("s*broken", "", pulse_symbols()).has_value());
    CHECK_THROWS_WITH(line("1/(t - s)").function(2.0, 2.0),
                      "load[0].force_per_length[1]: \"1/(t - s)\" is inf at t = 2, s = 2");
    CHECK_THROWS_WITH(line("1/0"), "the value is inf, not a finite number");
    CHECK_THROWS_WITH(line("x"), "unknown name \"x\"; available: pi, t, s");
    CHECK_THROWS_WITH(line("s(2)"), "\"s\" is not a function; write s*(…)");
}

TEST_CASE("Functions of place have x, y, z and s, not t", "[deck]") {
    const auto place = [](const std::string& expression, const Symbols& symbols = none) {
        return compile_place_function(expression, "initial[0].velocity[1]", symbols).value();
    };
    CHECK(place("x + 10*y + 100*z + 1000*s").function(Vec3(1, 2, 3), 4.0) == 4321.0);
    CHECK(place("s").has_arc_length);
    CHECK_FALSE(place("x").has_arc_length);
    CHECK(place("3").function(Vec3(1, 2, 3), 4.0) == 3.0);
    CHECK(place("twice(x)", pulse_symbols()).function(Vec3(1.25, 0, 0), 0.0) == 900.0);
    CHECK_FALSE(compile_place_function("x*broken", "", pulse_symbols()).has_value());
    CHECK_THROWS_WITH(place("1/x + y").function(Vec3(0, 1, 2), 0.0),
                      "initial[0].velocity[1]: \"1/x + y\" is inf at x = 0, y = 1, z = 2");
    CHECK_THROWS_WITH(place("1/s").function(Vec3(0, 1, 2), 0.0),
                      "initial[0].velocity[1]: \"1/s\" is inf at x = 0, y = 1, z = 2, s = 0");
    CHECK_THROWS_WITH(place("2*t"), "\"t\" (time) is not allowed here: this value is that at t = 0");
    CHECK_THROWS_WITH(place("q"), "unknown name \"q\"; available: pi, x, y, z, s");
}

TEST_CASE("A parameter does not hide a variable", "[deck]") {
    Symbols symbols;
    symbols.parameters["s"] = 3.0;
    symbols.parameters["x"] = 4.0;
    CHECK(value("s*x", symbols) == 12.0);
    CHECK(function("s*x*t", symbols)(2.0) == 24.0);
    CHECK_THROWS_WITH(compile_line_function("2*s", "", symbols),
                      "\"s\" is the arc length here and also a parameter; give the parameter another name");
    CHECK(compile_line_function("2*x", "", symbols)->function(0.0, 0.0) == 8.0);
    CHECK_THROWS_WITH(compile_place_function("2*x", "", symbols),
                      "\"x\" is a coordinate here and also a parameter; give the parameter another name");
}

}  // namespace gxrod
