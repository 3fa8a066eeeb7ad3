#include "deck/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <cmath>
#include <memory>

#include "deck/expression_built_ins.hpp"
#include "deck/expression_syntax.hpp"
#include "deck/table_function.hpp"
#include "model/evaluation_error.hpp"

namespace gxrod {
namespace {

// muParser's complaint about an arrangement of operators, in a user's words.
std::string explain(const mu::ParserError& error) {
    switch (error.GetCode()) {
        case mu::ecUNEXPECTED_OPERATOR:
            return fmt::format("the operator \"{}\" is out of place", error.GetToken());
        case mu::ecUNEXPECTED_EOF:
            return "the expression ends too early";
        case mu::ecUNEXPECTED_PARENS:
            return fmt::format("the \"{}\" is out of place", error.GetToken());
        case mu::ecUNEXPECTED_ARG_SEP:
            return "a \",\" is out of place";
        case mu::ecTOO_MANY_PARAMS:
            return fmt::format("\"{}\" has too many arguments", error.GetToken());
        case mu::ecTOO_FEW_PARAMS:
            return fmt::format("\"{}\" has too few arguments", error.GetToken());
        case mu::ecMISSING_ELSE_CLAUSE:
            return "a \"?\" has no \":\"; write condition ? a : b";
        case mu::ecMISPLACED_COLON:
            return "a \":\" has no \"?\"; write condition ? a : b";
        default:
            return error.GetMsg();
    }
}

std::string describe_non_finite(double value) {
    return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}

class CompiledFunctions;

// One expression as bytecode.
class CompiledExpression {
  public:
    CompiledExpression(const std::string& text, const Symbols& symbols, CompiledFunctions& functions);
    CompiledExpression(const CompiledExpression&) = delete;  // the parser points into it
    CompiledExpression& operator=(const CompiledExpression&) = delete;

    double operator()(double time) {
        time_ = time;
        return parser_.Eval();
    }

  private:
    mu::Parser parser_;
    double time_ = 0.0;
};

// One [function.NAME], as the expressions of one TimeFunction call it.
struct CompiledFunction {
    std::vector<std::pair<double, double>> table;
    std::unique_ptr<CompiledExpression> expression;

    double operator()(double time) { return expression ? (*expression)(time) : interpolate(table, time); }
};

double call_function(void* function, double time) {
    return (*static_cast<CompiledFunction*>(function))(time);
}

// The deck's functions that one expression needs, each compiled once. Every TimeFunction owns its own, so
// that no two of them share what an evaluation writes to.
class CompiledFunctions {
  public:
    explicit CompiledFunctions(const Symbols& symbols) : symbols_(symbols) {}

    CompiledFunction* find(const std::string& name) {
        const auto [entry, is_new] = functions_.try_emplace(name);
        if (is_new) {
            const FunctionDefinition& definition = *symbols_.functions.find(name)->second;
            entry->second = std::make_unique<CompiledFunction>();
            entry->second->table = definition.table;
            if (definition.table.empty()) {
                entry->second->expression =
                    std::make_unique<CompiledExpression>(definition.expression, symbols_, *this);
            }
        }
        return entry->second.get();
    }

    std::map<std::string, std::unique_ptr<CompiledFunction>> release() { return std::move(functions_); }

  private:
    const Symbols& symbols_;
    std::map<std::string, std::unique_ptr<CompiledFunction>> functions_;
};

CompiledExpression::CompiledExpression(const std::string& text,
                                       const Symbols& symbols,
                                       CompiledFunctions& functions) {
    const ExpressionNames names = check_expression(text, symbols, TimeUse::free);
    try {
        // muParser 2.3 folds constant && and || through integers: 0.5 && 1 becomes 0. Unfolded they are
        // right.
        parser_.EnableOptimizer(false);
        define_built_ins(parser_);
        parser_.DefineVar("t", &time_);
        for (const std::string& name : names.parameters) {
            parser_.DefineConst(name, *symbols.parameters.find(name)->second);
        }
        for (const std::string& name : names.functions) {
            parser_.DefineFunUserData(name, call_function, functions.find(name), false);
        }
        parser_.SetExpr(text);
        parser_.Eval();  // compiles
    } catch (const mu::ParserError& error) {
        throw ExpressionError(explain(error));
    }
}

// An expression, the functions that it calls, and where it stands.
struct Program {
    Program(const std::string& text_, const Symbols& symbols, CompiledFunctions compiled)
        : text(text_), main(text, symbols, compiled), functions(compiled.release()) {}

    std::string text;
    std::string key;
    CompiledExpression main;
    std::map<std::string, std::unique_ptr<CompiledFunction>> functions;
};

double evaluate(Program& program, double time) {
    const double value = program.main(time);
    if (!std::isfinite(value)) {
        throw EvaluationError(fmt::format(
            "{}: \"{}\" is {} at t = {}", program.key, program.text, describe_non_finite(value), time));
    }
    return value;
}

// Whether every name that an expression rests on, directly or through functions, is a right one.
bool is_usable(const ExpressionNames& names, const Symbols& symbols, std::set<std::string>& visited) {
    for (const std::string& name : names.parameters) {
        if (!symbols.parameters.find(name)->second) return false;
    }
    for (const std::string& name : names.functions) {
        if (!visited.insert(name).second) continue;
        const auto& definition = symbols.functions.find(name)->second;
        if (!definition) return false;
        if (!definition->table.empty()) continue;
        if (!is_usable(check_expression(definition->expression, symbols, TimeUse::free), symbols, visited)) {
            return false;
        }
    }
    return true;
}

// The parts of an expression that depend on its value only through its names, for a syntax check when a name
// is wrong.
Symbols with_placeholders(const ExpressionNames& names) {
    Symbols symbols;
    for (const std::string& name : names.parameters) symbols.parameters[name] = 1.0;
    for (const std::string& name : names.functions)
        symbols.functions[name] = FunctionDefinition{{{0.0, 1.0}}, ""};
    return symbols;
}

std::shared_ptr<Program> compile(const std::string& expression, const Symbols& symbols, TimeUse time) {
    const ExpressionNames names = check_expression(expression, symbols, time);
    std::set<std::string> visited;
    if (!is_usable(names, symbols, visited)) {
        const Symbols placeholders = with_placeholders(names);
        const Program checked(expression, placeholders, CompiledFunctions(placeholders));
        return nullptr;
    }
    return std::make_shared<Program>(expression, symbols, CompiledFunctions(symbols));
}

double constant_value(Program& program) {
    const double value = program.main(0.0);
    if (!std::isfinite(value)) {
        throw ExpressionError(
            fmt::format("the value is {}, not a finite number", describe_non_finite(value)));
    }
    return value;
}

}  // namespace

std::optional<double> evaluate_constant(const std::string& expression, const Symbols& symbols) {
    const std::shared_ptr<Program> program = compile(expression, symbols, TimeUse::none);
    if (!program) return std::nullopt;
    return constant_value(*program);
}

std::optional<TimeFunction> compile_time_function(const std::string& expression,
                                                  const std::string& key,
                                                  const Symbols& symbols) {
    const std::shared_ptr<Program> program = compile(expression, symbols, TimeUse::free);
    if (!program) return std::nullopt;
    if (!check_expression(expression, symbols, TimeUse::free).time)
        return TimeFunction(constant_value(*program));
    program->key = key;
    return TimeFunction([program](double time) { return evaluate(*program, time); });
}

}  // namespace gxrod
