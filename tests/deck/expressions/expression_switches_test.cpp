#include "deck/expressions/expression_switches.hpp"

#include "model/time/breaks.hpp"
#include "tools/catch.hpp"

namespace gxrod {

namespace {

const Symbols symbols{{{"a", 2.0}},
                      {{"table", FunctionDefinition{{{0.0, 0.0}, {1.0, 2.0}, {4.0, 0.0}}, ""}},
                       {"ramp", FunctionDefinition{{}, "max(0, t - 3)"}},
                       {"nested", FunctionDefinition{{}, "ramp(2*t) + table(t)"}}},
                      {}};

// "argument [knots]; …"
std::string list(const std::string& expression) {
    std::string text;
    for (const SwitchSource& source : find_switches(expression, symbols)) {
        if (!text.empty()) text += "; ";
        for (std::size_t i = 0; i < source.chain.size(); ++i) text += (i == 0 ? "" : " > ") + source.chain[i];
        text += " [";
        for (const double knot : source.knots) text += " " + std::to_string(static_cast<int>(knot));
        text += " ]";
    }
    return text;
}

std::vector<double> breaks_along(const std::string& expression, double time = 0.0) {
    const auto line = compile_line_function(expression, "key", symbols);
    if (line->function.switches() == nullptr) return {};
    return find_breaks_along(*line->function.switches(), time, {0.0, 10.0}, 64);
}

}  // namespace

TEST_CASE("Switches of an expression are its comparisons and its functions with kinks", "[deck]") {
    CHECK(list("sin(s)*t^2 + a") == "");
    CHECK(list("a > 1 ? 1 : 0") == "");
    CHECK(list("s > 2 && s < 2*t + a ? -1 : 0") == "(s) - (2) [ 0 ]; (s) - (2*t + a) [ 0 ]");
    CHECK(list("(s > 1)*(s <= 2)") == "(s) - (1) [ 0 ]; (s) - (2) [ 0 ]");
    CHECK(list("abs(s - 2) < 0.1") == "s - 2 [ 0 ]; (abs(s - 2)) - (0.1) [ 0 ]");
    CHECK(list("min(s, t, 3)") == "(s) - (t) [ 0 ]; (s) - (3) [ 0 ]; (t) - (3) [ 0 ]");
    CHECK(list("sign(-s + 1) + sqrt(t) + acos(s/9)") == "-s + 1 [ 0 ]; t [ 0 ]; s/9 [ -1 1 ]");
    CHECK(list("(s - 1)^0.5 + s^2") == "(s - 1) [ 0 ]");
    CHECK(list("t < 1 ? (s < 2 ? 1 : 2) : s < 3") == "(t) - (1) [ 0 ]; (s) - (2) [ 0 ]; (s) - (3) [ 0 ]");
    CHECK(list("s > 1 || s > 1") == "(s) - (1) [ 0 ]");
}

TEST_CASE("Switches of functions are those of their tables and expressions, at the argument", "[deck]") {
    CHECK(list("table(s)") == "s [ 0 1 4 ]");
    CHECK(list("3*table(s - t)") == "s - t [ 0 1 4 ]");
    CHECK(list("ramp(t)") == "(0) - (t - 3) [ 0 ]");
    CHECK(list("ramp(2*s)") == "2*s > (0) - (t - 3) [ 0 ]");
    CHECK(list("nested(s)") == "s > 2*t > (0) - (t - 3) [ 0 ]; s [ 0 1 4 ]");
}

TEST_CASE("Breaks of compiled expressions are where their forms change", "[deck]") {
    CHECK(breaks_along("s > 2 && s < 2.5 ? -1 : 0") == std::vector{2.0, 2.5});
    CHECK(breaks_along("s < 2*t ? 1 : 0", 1.75) == std::vector{3.5});
    CHECK(breaks_along("table(s)") == std::vector{1.0, 4.0});
    CHECK(breaks_along("table(s - t)", 1.5).size() == 3);
    CHECK(breaks_along("nested(s)") == std::vector{1.0, 1.5, 4.0});
    CHECK(breaks_along("t > 1 ? s : 0").empty());
    const auto even = compile_line_function("sin(t)", "key", symbols);
    CHECK(even->function.form().is_even);
    CHECK(even->function.form().in_time == InTime::varying);
    const auto fixed = compile_line_function("sin(s)", "key", symbols);
    CHECK_FALSE(fixed->function.form().is_even);
    CHECK(fixed->function.form().in_time == InTime::constant);
    const auto time = compile_time_function("nested(t)", "key", symbols);
    CHECK(find_breaks_in_time(*time->switches(), {0.0, 10.0}, 64) == std::vector{1.0, 1.5, 4.0});
}

}  // namespace gxrod
