#include "deck/expressions/expression_syntax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "deck/expressions/expression_built_ins.hpp"
#include "deck/expressions/expression_tokens.hpp"
#include "deck/schema/suggestion.hpp"

namespace gxrod {
namespace {

const std::vector<std::string>& names_of(Variables variables) {
    static const std::vector<std::string> none, time{"t"}, line{"t", "s"}, arc{"s"},
        place{"x", "y", "z", "s"}, field{"t", "x", "y", "z"},
        motion{"t", "x", "y", "z", "vx", "vy", "vz", "rx", "ry", "rz", "wx", "wy", "wz"},
        motion_along{"t", "s", "x", "y", "z", "vx", "vy", "vz", "rx", "ry", "rz", "wx", "wy", "wz"},
        spring{"length", "rate"}, angle{"angle"};
    switch (variables) {
        case Variables::none:
            return none;
        case Variables::time:
            return time;
        case Variables::line:
            return line;
        case Variables::arc:
            return arc;
        case Variables::place:
            return place;
        case Variables::field:
            return field;
        case Variables::motion:
            return motion;
        case Variables::motion_along:
            return motion_along;
        case Variables::spring:
            return spring;
        case Variables::angle:
            break;
    }
    return angle;
}

// What a variable stands for, if it is not t.
const char* describe_variable(const std::string& name) {
    if (name == "s") return "the arc length";
    if (name == "length") return "the spring's length";
    if (name == "rate") return "the rate of the spring's length";
    if (name == "angle") return "the angle about the centre";
    if (name.size() == 1) return "a coordinate";
    return name[0] == 'v'   ? "a component of the velocity"
           : name[0] == 'r' ? "a component of the rotation vector"
                            : "a component of the angular velocity";
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// Checks one expression, token by token.
class ExpressionCheck {
  public:
    ExpressionCheck(const std::vector<Token>& tokens, const Symbols& symbols, Variables variables)
        : tokens_(tokens), symbols_(symbols), variables_(variables) {}

    ExpressionNames run() {
        groups_.push_back({});
        for (at_ = 0; at_ < tokens_.size(); ++at_) {
            check_neighbour();
            check_token();
        }
        if (groups_.size() > 1) throw ExpressionError("a \")\" is missing");
        check_effort();
        return names_;
    }

  private:
    // An open parenthesis.
    struct Group {
        bool of_function = false;
        bool compared = false;  // the current operand holds a comparison
    };

    const Token& token() const { return tokens_[at_]; }
    bool next_is_open() const { return at_ + 1 < tokens_.size() && tokens_[at_ + 1].kind == TokenKind::open; }

    void check_effort() {
        names_.operations += static_cast<double>(tokens_.size());
        if (names_.operations > most_operations) {
            throw ExpressionError(fmt::format(
                "with the functions that it calls it takes {:.3g} operations to evaluate; {} are the most",
                names_.operations,
                most_operations));
        }
        if (names_.depth >= most_function_depth) {
            throw ExpressionError(
                fmt::format("functions that call functions go more than {} deep", most_function_depth));
        }
    }

    // Two values side by side: 2t, (a)(b).
    void check_neighbour() const {
        if (at_ == 0) return;
        const TokenKind before = tokens_[at_ - 1].kind;
        const bool value_before =
            before == TokenKind::number || before == TokenKind::name || before == TokenKind::close;
        const bool call = before == TokenKind::name && token().kind == TokenKind::open;
        const bool value = token().kind == TokenKind::number || token().kind == TokenKind::name ||
                           token().kind == TokenKind::open;
        if (value_before && value && !call) {
            throw ExpressionError(fmt::format(
                "an operator is missing between \"{}\" and \"{}\"", tokens_[at_ - 1].text, token().text));
        }
    }

    void check_token() {
        switch (token().kind) {
            case TokenKind::number:
                break;
            case TokenKind::name:
                next_is_open() ? check_function() : check_variable();
                break;
            case TokenKind::operation:
                check_operator();
                break;
            case TokenKind::open:
                groups_.push_back({at_ > 0 && tokens_[at_ - 1].kind == TokenKind::name, false});
                break;
            case TokenKind::close:
                if (groups_.size() == 1) throw ExpressionError("a \")\" has no \"(\"");
                groups_.pop_back();
                break;
            case TokenKind::comma:
                check_comma();
                break;
        }
    }

    void check_comma() {
        if (!groups_.back().of_function) {
            throw ExpressionError(
                "a \",\" is outside a function call; an expression has one value, and \".\" is its "
                "decimal point");
        }
        groups_.back().compared = false;
    }

    void check_operator() {
        const std::string& text = token().text;
        const bool compares = text[0] == '<' || text[0] == '>' || text == "==" || text == "!=";
        if (compares && groups_.back().compared) {
            throw ExpressionError(
                "comparisons in a row compare the result 0 or 1 of the first; write \"a < b && b < c\", or "
                "parentheses if you mean it");
        }
        if (compares) groups_.back().compared = true;
        if (text == "&&" || text == "||" || text == "?" || text == ":") groups_.back().compared = false;
    }

    void check_variable() {
        const std::string& name = token().text;
        if (name == "pi") return;
        if (has(names_of(variables_), name)) return use_variable(name);
        if (name == "t") throw_no_time();
        if (symbols_.parameters.contains(name)) {
            names_.parameters.insert(name);
            return;
        }
        if (symbols_.inputs.contains(name)) return use_input(name);
        if (is_function(name))
            throw ExpressionError(fmt::format("\"{0}\" is a function; write {0}(…)", name));
        std::vector<std::string> known{"pi"};
        for (const std::string& variable : names_of(variables_)) known.push_back(variable);
        for (const auto& [parameter, value] : symbols_.parameters) known.push_back(parameter);
        if (can_change()) {
            for (const auto& [input, value] : symbols_.inputs) known.push_back(input);
        }
        throw_unknown("name", did_you_mean(name, known), known);
    }

    // Whether the value is looked at again while a run goes on.
    bool can_change() const {
        return variables_ == Variables::time || variables_ == Variables::line ||
               variables_ == Variables::field || variables_ == Variables::motion ||
               variables_ == Variables::motion_along;
    }

    void use_input(const std::string& name) {
        if (!can_change()) {
            throw ExpressionError(
                fmt::format("\"{}\" is an input, which changes during a run; values that cannot have t "
                            "cannot have it either",
                            name));
        }
        names_.inputs.insert(name);
    }

    void use_variable(const std::string& name) {
        if (symbols_.parameters.contains(name)) {
            throw ExpressionError(
                fmt::format("\"{0}\" is {1} here and also a parameter; give the parameter another name",
                            name,
                            describe_variable(name)));
        }
        names_.variables.insert(name);
    }

    [[noreturn]] void throw_no_time() const {
        const char* value = variables_ == Variables::none     ? "a constant"
                            : variables_ == Variables::arc    ? "a function of s"
                            : variables_ == Variables::spring ? "a function of length and rate"
                            : variables_ == Variables::angle  ? "a function of angle"
                                                              : "that at t = 0";
        throw ExpressionError(fmt::format("\"t\" (time) is not allowed here: this value is {}", value));
    }

    void check_function() {
        const std::string& name = token().text;
        const std::vector<std::string>& built_in = built_in_functions();
        if (has(built_in, name)) return;
        if (symbols_.functions.contains(name)) return check_deck_function(name);
        const bool is_variable = name == "t" || has(names_of(variables_), name);
        if (is_variable || name == "pi" || symbols_.parameters.contains(name) ||
            symbols_.inputs.contains(name)) {
            throw ExpressionError(fmt::format("\"{0}\" is not a function; write {0}*(…)", name));
        }
        std::vector<std::string> known = built_in;
        if (variables_ != Variables::none) {
            for (const auto& [function, definition] : symbols_.functions) known.push_back(function);
        }
        const std::string hint = name == "ln"    ? "; did you mean \"log\" (natural)?"
                                 : name == "pow" ? "; write a^b for a power"
                                                 : did_you_mean(name, known);
        throw_unknown("function", hint, known);
    }

    [[noreturn]] void throw_unknown(const char* kind,
                                    const std::string& hint,
                                    const std::vector<std::string>& known) const {
        const char* separator = hint.ends_with('?') ? "" : ";";
        throw ExpressionError(fmt::format(
            "unknown {} \"{}\"{}{} available: {}", kind, token().text, hint, separator, plain_list(known)));
    }

    void check_deck_function(const std::string& name) {
        if (variables_ == Variables::none) {
            throw ExpressionError(fmt::format(
                "\"{}\" is a function of time, which is not allowed here: this value is a constant", name));
        }
        names_.functions.insert(name);
        const std::optional<FunctionDefinition>& definition = symbols_.functions.find(name)->second;
        if (!definition) return;
        names_.operations += definition->operations;
        names_.depth = std::max(names_.depth, definition->depth);
    }

    bool is_function(const std::string& name) const {
        return symbols_.functions.contains(name) || has(built_in_functions(), name);
    }

    const std::vector<Token>& tokens_;
    const Symbols& symbols_;
    Variables variables_;
    std::size_t at_ = 0;
    std::vector<Group> groups_;
    ExpressionNames names_;
};

}  // namespace

bool is_identifier(const std::string& word) {
    if (word.empty() || std::isdigit(static_cast<unsigned char>(word[0])) != 0) return false;
    return std::all_of(word.begin(), word.end(), [](char letter) {
        return letter == '_' || std::isalnum(static_cast<unsigned char>(letter)) != 0;
    });
}

std::string explain_unusable_name(const std::string& name) {
    if (!is_identifier(name)) {
        return "expressions could not use this name: write letters, digits and _, no digit first";
    }
    if (name == "t") return "t is time in expressions; choose another name";
    if (name == "pi") return "pi is 3.14159… in expressions; choose another name";
    if (has(built_in_functions(), name)) {
        return name + " is a built-in function; choose another name";
    }
    return "";
}

ExpressionNames check_expression(const std::string& expression, const Symbols& symbols, Variables variables) {
    if (expression.size() > most_expression_letters) {
        throw ExpressionError(
            fmt::format("has {} letters; {} are the most", expression.size(), most_expression_letters));
    }
    const std::vector<Token> tokens = split_expression(expression);
    return ExpressionCheck(tokens, symbols, variables).run();
}

}  // namespace gxrod
