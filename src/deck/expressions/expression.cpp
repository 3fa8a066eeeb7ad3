#include "deck/expressions/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "deck/expressions/expression_built_ins.hpp"
#include "deck/expressions/expression_switches.hpp"
#include "deck/expressions/expression_syntax.hpp"
#include "deck/expressions/table_function.hpp"
#include "model/evaluation_error.hpp"

namespace gxrod {
namespace {

using namespace std::string_literals;

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

// An expression and what it can use.
struct Formula {
    const std::string& text;
    const Symbols& symbols;
    Variables variables;
};

// What the variables of an expression stand for.
struct Values {
    double t = 0.0;
    double s = 0.0;
    PointMotion motion = {};
    double length = 0.0;
    double rate = 0.0;
    double angle = 0.0;
};

// An input as an expression reads it.
struct InputValue {
    std::shared_ptr<const Input> input;
    double value = 0.0;
};

// One expression as bytecode.
class CompiledExpression {
  public:
    CompiledExpression(const Formula& formula, CompiledFunctions& functions);
    CompiledExpression(const CompiledExpression&) = delete;  // the parser points into it
    CompiledExpression& operator=(const CompiledExpression&) = delete;

    double operator()(const Values& values) {
        values_ = values;
        for (InputValue& input : inputs_) input.value = (*input.input)(*clock_);
        return parser_.Eval();
    }

  private:
    double* find(const std::string& variable);

    mu::Parser parser_;
    Values values_;
    std::vector<InputValue> inputs_;
    std::shared_ptr<const double> clock_;  // the time, which is not t in a function that is called
};

// One [function.NAME], as the expressions of one TimeFunction call it.
struct CompiledFunction {
    std::shared_ptr<const TableFunction> table;
    std::unique_ptr<CompiledExpression> expression;

    double operator()(double argument) {
        return expression ? (*expression)({.t = argument}) : (*table)(argument);
    }
};

std::shared_ptr<const TableFunction> curve_of(const FunctionDefinition& definition) {
    if (definition.curve) return definition.curve;
    return std::make_shared<const TableFunction>(definition.table, definition.interpolation);
}

double call_function(void* function, double argument) {
    return (*static_cast<CompiledFunction*>(function))(argument);
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
            if (definition.table.empty()) {
                entry->second->expression = std::make_unique<CompiledExpression>(
                    Formula{definition.expression, symbols_, Variables::time}, *this);
            } else {
                entry->second->table = curve_of(definition);
            }
        }
        return entry->second.get();
    }

    std::map<std::string, std::unique_ptr<CompiledFunction>> release() { return std::move(functions_); }

    // The time, of all expressions compiled with these; set before they are evaluated.
    const std::shared_ptr<double>& clock() const { return clock_; }
    bool have_inputs() const { return have_inputs_; }
    void note_inputs() { have_inputs_ = true; }

  private:
    const Symbols& symbols_;
    std::map<std::string, std::unique_ptr<CompiledFunction>> functions_;
    std::shared_ptr<double> clock_ = std::make_shared<double>(0.0);
    bool have_inputs_ = false;
};

double* CompiledExpression::find(const std::string& variable) {
    if (variable == "t") return &values_.t;
    if (variable == "s") return &values_.s;
    if (variable == "length") return &values_.length;
    if (variable == "rate") return &values_.rate;
    if (variable == "angle") return &values_.angle;
    Vec3& vector = variable.size() == 1 ? values_.motion.position
                   : variable[0] == 'v' ? values_.motion.velocity
                   : variable[0] == 'r' ? values_.motion.rotation
                                        : values_.motion.spin;
    return &vector[static_cast<Eigen::Index>("xyz"s.find(variable.back()))];
}

CompiledExpression::CompiledExpression(const Formula& formula, CompiledFunctions& functions)
    : clock_(functions.clock()) {
    const ExpressionNames names = check_expression(formula.text, formula.symbols, formula.variables);
    try {
        // muParser 2.3 folds constant && and || through integers: 0.5 && 1 becomes 0. Unfolded they are
        // right.
        parser_.EnableOptimizer(false);
        define_built_ins(parser_);
        for (const std::string& name : names.variables) parser_.DefineVar(name, find(name));
        for (const std::string& name : names.parameters) {
            parser_.DefineConst(name, *formula.symbols.parameters.find(name)->second);
        }
        inputs_.reserve(names.inputs.size());
        for (const std::string& name : names.inputs) {
            inputs_.push_back({formula.symbols.inputs.find(name)->second});
            parser_.DefineVar(name, &inputs_.back().value);
            functions.note_inputs();
        }
        for (const std::string& name : names.functions) {
            parser_.DefineFunUserData(name, call_function, functions.find(name), false);
        }
        parser_.SetExpr(formula.text);
        parser_.Eval();  // compiles
    } catch (const mu::ParserError& error) {
        throw ExpressionError(explain(error));
    }
}

// An expression, the functions that it calls, and where it is.
struct Program {
    Program(const Formula& formula, CompiledFunctions compiled)
        : text(formula.text),
          main(formula, compiled),
          clock(compiled.clock()),
          has_inputs(compiled.have_inputs()),
          functions(compiled.release()) {}

    double evaluate(const Values& values) {
        *clock = values.t;
        return main(values);
    }

    // The value; throws EvaluationError if that is not finite. `where` says so: "t = 0.5".
    template <class Where>
    double evaluate(const Values& values, const Where& where) {
        const double value = evaluate(values);
        if (!std::isfinite(value)) {
            throw EvaluationError(
                fmt::format("{}: \"{}\" is {} at {}", key, text, describe_non_finite(value), where()));
        }
        return value;
    }

    std::string text;
    std::string key;
    CompiledExpression main;
    std::shared_ptr<double> clock;
    bool has_inputs;
    std::map<std::string, std::unique_ptr<CompiledFunction>> functions;
};

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
        if (!is_usable(
                check_expression(definition->expression, symbols, Variables::time), symbols, visited)) {
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

// The program and the names of its variables; nullptr if the expression rests on a wrong name.
struct Compiled {
    std::shared_ptr<Program> program;
    std::set<std::string> variables;

    bool is_constant() const { return variables.empty() && !program->has_inputs; }
};

Compiled compile(const Formula& formula, const std::string& key = "") {
    const ExpressionNames names = check_expression(formula.text, formula.symbols, formula.variables);
    std::set<std::string> visited;
    if (!is_usable(names, formula.symbols, visited)) {
        const Symbols placeholders = with_placeholders(names);
        const Program checked({formula.text, placeholders, formula.variables},
                              CompiledFunctions(placeholders));
        return {nullptr, {}};
    }
    auto program = std::make_shared<Program>(formula, CompiledFunctions(formula.symbols));
    program->key = key;
    return {std::move(program), names.variables};
}

double constant_value(Program& program) {
    const double value = program.main({});
    if (!std::isfinite(value)) {
        throw ExpressionError(
            fmt::format("the value is {}, not a finite number", describe_non_finite(value)));
    }
    return value;
}

// The value of an expression that is the name of a parameter: no parser is needed.
std::optional<double> find_parameter(const Formula& formula) {
    const ExpressionNames names = check_expression(formula.text, formula.symbols, formula.variables);
    const bool has_others = !names.variables.empty() || !names.functions.empty() || !names.inputs.empty();
    if (has_others || names.parameters.size() != 1 || formula.text != *names.parameters.begin())
        return std::nullopt;
    const std::optional<double> value = formula.symbols.parameters.find(formula.text)->second;
    return value && std::isfinite(*value) ? value : std::nullopt;
}

// The compiled chain of one switch.
struct SwitchProgram {
    SwitchProgram(const SwitchSource& source, const Symbols& symbols, Variables variables)
        : compiled(symbols) {
        for (const std::string& text : source.chain) {
            const Variables own = chain.empty() ? variables : Variables::time;
            chain.push_back(std::make_unique<CompiledExpression>(Formula{text, symbols, own}, compiled));
        }
        functions = compiled.release();
    }

    double operator()(double time, double s) {
        *compiled.clock() = time;
        Values values{.t = time, .s = s};
        for (const auto& expression : chain) values.t = (*expression)(values);
        return values.t;
    }

    CompiledFunctions compiled;
    std::vector<std::unique_ptr<CompiledExpression>> chain;
    std::map<std::string, std::unique_ptr<CompiledFunction>> functions;
};

Switch compile_switch(const SwitchSource& source, const Formula& formula) {
    Switch one{.argument = {},
               .knots = source.knots,
               .has_time = source.has_time,
               .has_arc_length = source.has_arc_length,
               .is_variable = false};
    const std::string& text = source.chain.front();
    if (source.chain.size() == 1 && (text == "t" || text == "s")) {
        one.is_variable = true;
        one.argument = [is_time = text == "t"](double time, double s) { return is_time ? time : s; };
        return one;
    }
    one.argument = [program = std::make_shared<SwitchProgram>(source, formula.symbols, formula.variables)](
                       double time, double s) { return (*program)(time, s); };
    return one;
}

// nullptr if there are none.
std::shared_ptr<const Switches> compile_switches(const Formula& formula) {
    const std::vector<SwitchSource> sources = find_switches(formula.text, formula.symbols);
    if (sources.empty()) return nullptr;
    auto switches = std::make_shared<Switches>();
    for (const SwitchSource& source : sources) switches->push_back(compile_switch(source, formula));
    return switches;
}

}  // namespace

std::optional<double> evaluate_constant(const std::string& expression, const Symbols& symbols) {
    if (const auto value = find_parameter({expression, symbols, Variables::none})) return value;
    const Compiled compiled = compile({expression, symbols, Variables::none});
    if (!compiled.program) return std::nullopt;
    return constant_value(*compiled.program);
}

std::optional<TimeFunction> compile_time_function(const std::string& expression,
                                                  const std::string& key,
                                                  const Symbols& symbols) {
    const Formula formula{expression, symbols, Variables::time};
    if (const auto value = find_parameter(formula)) return TimeFunction(*value);
    const Compiled compiled = compile(formula, key);
    if (!compiled.program) return std::nullopt;
    if (compiled.is_constant()) return TimeFunction(constant_value(*compiled.program));
    const auto evaluate = [program = compiled.program](double time) {
        return program->evaluate({.t = time}, [=] { return fmt::format("t = {}", time); });
    };
    return TimeFunction(evaluate, compile_switches(formula), compiled.variables.contains("t"));
}

std::optional<LineExpression> compile_line_function(const std::string& expression,
                                                    const std::string& key,
                                                    const Symbols& symbols) {
    const Formula formula{expression, symbols, Variables::line};
    if (const auto value = find_parameter(formula)) return LineExpression{LineFunction(*value)};
    const Compiled compiled = compile(formula, key);
    if (!compiled.program) return std::nullopt;
    if (compiled.is_constant()) return LineExpression{LineFunction(constant_value(*compiled.program))};
    const auto evaluate = [program = compiled.program](double time, double s) {
        return program->evaluate({.t = time, .s = s}, [=] { return fmt::format("t = {}, s = {}", time, s); });
    };
    const bool has_time = compiled.variables.contains("t");
    const bool is_varying = has_time || compiled.program->has_inputs;
    const LineForm form{is_varying ? InTime::varying : InTime::constant, !compiled.variables.contains("s")};
    return LineExpression{LineFunction(evaluate, compile_switches(formula), form), has_time};
}

std::optional<ArcExpression> compile_arc_function(const std::string& expression,
                                                  const std::string& key,
                                                  const Symbols& symbols) {
    if (const auto value = find_parameter({expression, symbols, Variables::arc}))
        return ArcExpression{{}, *value};
    const Compiled compiled = compile({expression, symbols, Variables::arc}, key);
    if (!compiled.program) return std::nullopt;
    if (compiled.is_constant()) return ArcExpression{{}, constant_value(*compiled.program)};
    const auto evaluate = [program = compiled.program](double s) {
        return program->evaluate({.s = s}, [=] { return fmt::format("s = {}", s); });
    };
    return ArcExpression{evaluate};
}

std::optional<PlaceExpression> compile_place_function(const std::string& expression,
                                                      const std::string& key,
                                                      const Symbols& symbols) {
    const Compiled compiled = compile({expression, symbols, Variables::place}, key);
    if (!compiled.program) return std::nullopt;
    if (compiled.is_constant()) {
        const double constant = constant_value(*compiled.program);
        return PlaceExpression{[constant](const Vec3&, double) { return constant; }};
    }
    const bool has_arc_length = compiled.variables.contains("s");
    const auto evaluate = [program = compiled.program, has_arc_length](const Vec3& position, double s) {
        return program->evaluate({.s = s, .motion = {.position = position}}, [&] {
            const std::string at =
                fmt::format("x = {}, y = {}, z = {}", position[0], position[1], position[2]);
            return has_arc_length ? fmt::format("{}, s = {}", at, s) : at;
        });
    };
    return PlaceExpression{evaluate, has_arc_length};
}

namespace {

bool is_of_motion(const std::string& variable) { return variable != "t" && variable != "s"; }
bool is_of_turn(const std::string& variable) { return variable[0] == 'r' || variable[0] == 'w'; }

PointFunction make_point_function(const Compiled& compiled) {
    return [program = compiled.program](double time, double s, const PointMotion& motion) {
        return program->evaluate({.t = time, .s = s, .motion = motion});
    };
}

std::optional<MotionExpression> compile_by_motion(const Formula& formula, const std::string& key) {
    const Compiled compiled = compile(formula, key);
    if (!compiled.program) return std::nullopt;
    MotionExpression expression{.has_time = compiled.variables.contains("t"),
                                .turns = std::ranges::any_of(compiled.variables, is_of_turn)};
    if (std::ranges::any_of(compiled.variables, is_of_motion)) {
        expression.by_motion = make_point_function(compiled);
    } else {
        expression.by_time = *compile_time_function(formula.text, key, formula.symbols);
    }
    return expression;
}

}  // namespace

std::optional<MotionExpression> compile_motion_function(const std::string& expression,
                                                        const std::string& key,
                                                        const Symbols& symbols) {
    return compile_by_motion({expression, symbols, Variables::motion}, key);
}

std::optional<MotionExpression> compile_field_function(const std::string& expression,
                                                       const std::string& key,
                                                       const Symbols& symbols) {
    return compile_by_motion({expression, symbols, Variables::field}, key);
}

std::optional<LineMotionExpression> compile_line_motion_function(const std::string& expression,
                                                                 const std::string& key,
                                                                 const Symbols& symbols) {
    const Compiled compiled = compile({expression, symbols, Variables::motion_along}, key);
    if (!compiled.program) return std::nullopt;
    if (std::ranges::none_of(compiled.variables, is_of_motion))
        return LineMotionExpression{.by_line = *compile_line_function(expression, key, symbols)};
    return LineMotionExpression{.by_line = {LineFunction(0.0), compiled.variables.contains("t")},
                                .by_motion = make_point_function(compiled),
                                .turns = std::ranges::any_of(compiled.variables, is_of_turn)};
}

std::optional<SpringExpression> compile_spring_function(const std::string& expression,
                                                        const std::string& key,
                                                        const Symbols& symbols) {
    const Compiled compiled = compile({expression, symbols, Variables::spring}, key);
    if (!compiled.program) return std::nullopt;
    const auto evaluate = [program = compiled.program](double length, double rate) {
        return program->evaluate({.length = length, .rate = rate});
    };
    return SpringExpression{evaluate, compiled.variables.contains("rate")};
}

std::optional<AngleExpression> compile_angle_function(const std::string& expression,
                                                      const std::string& key,
                                                      const Symbols& symbols) {
    const Compiled compiled = compile({expression, symbols, Variables::angle}, key);
    if (!compiled.program) return std::nullopt;
    const auto evaluate = [program = compiled.program](double angle) {
        return program->evaluate({.angle = angle}, [=] { return fmt::format("angle = {}", angle); });
    };
    return AngleExpression{evaluate};
}

}  // namespace gxrod
