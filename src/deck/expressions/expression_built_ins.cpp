#include "deck/expressions/expression_built_ins.hpp"

#include <muParser.h>

#include <array>
#include <cmath>
#include <numbers>

namespace gxrod {
namespace {

using Unary = double (*)(double);
using Binary = double (*)(double, double);
using Variadic = double (*)(const double*, int);

template <class Function>
struct BuiltIn {
    const char* name;
    Function function;
};

double sign(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x; }

// A value that is not a number wins, so that it is noticed. muParser sees to it that there is one value at
// least.
double smallest(const double* values, int count) {
    double result = values[0];
    for (int i = 1; i < count; ++i) result = values[i] < result || std::isnan(values[i]) ? values[i] : result;
    return result;
}

double largest(const double* values, int count) {
    double result = values[0];
    for (int i = 1; i < count; ++i) result = values[i] > result || std::isnan(values[i]) ? values[i] : result;
    return result;
}

constexpr std::array<BuiltIn<Unary>, 15> unary{{{"sin", std::sin},
                                                {"cos", std::cos},
                                                {"tan", std::tan},
                                                {"asin", std::asin},
                                                {"acos", std::acos},
                                                {"atan", std::atan},
                                                {"sinh", std::sinh},
                                                {"cosh", std::cosh},
                                                {"tanh", std::tanh},
                                                {"exp", std::exp},
                                                {"log", std::log},
                                                {"log10", std::log10},
                                                {"sqrt", std::sqrt},
                                                {"abs", std::fabs},
                                                {"sign", sign}}};
constexpr std::array<BuiltIn<Binary>, 1> binary{{{"atan2", std::atan2}}};
constexpr std::array<BuiltIn<Variadic>, 2> variadic{{{"min", smallest}, {"max", largest}}};

template <class BuiltIns>
void add_names(const BuiltIns& built_ins, std::vector<std::string>& names) {
    for (const auto& built_in : built_ins) names.emplace_back(built_in.name);
}

template <class BuiltIns>
void define(const BuiltIns& built_ins, mu::Parser& parser) {
    for (const auto& built_in : built_ins) parser.DefineFun(built_in.name, built_in.function);
}

}  // namespace

const std::vector<std::string>& built_in_functions() {
    static const std::vector<std::string> all = [] {
        std::vector<std::string> names;
        add_names(unary, names);
        add_names(binary, names);
        add_names(variadic, names);
        return names;
    }();
    return all;
}

void define_built_ins(mu::Parser& parser) {
    parser.ClearFun();
    parser.ClearConst();
    define(unary, parser);
    define(binary, parser);
    define(variadic, parser);
    parser.DefineConst("pi", std::numbers::pi);
}

}  // namespace gxrod
