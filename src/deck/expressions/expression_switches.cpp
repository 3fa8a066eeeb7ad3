#include "deck/expressions/expression_switches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "deck/expressions/expression_tokens.hpp"

namespace gxrod {
namespace {

// A part of an expression: tokens from first to last, the one after.
struct Span {
    std::size_t first = 0;
    std::size_t last = 0;
};

// Goes through a checked expression by the precedence of its operators, the innermost parts first.
class SwitchFinder {
  public:
    SwitchFinder(const std::string& text, const Symbols& symbols)
        : text_(text), tokens_(split_expression(text)), symbols_(symbols) {}

    std::vector<SwitchSource> run() {
        parse_choice();
        return std::move(found_);
    }

  private:
    bool at_end() const { return at_ >= tokens_.size(); }
    bool is_operator(std::initializer_list<const char*> words) const {
        return !at_end() && tokens_[at_].kind == TokenKind::operation &&
               std::find(words.begin(), words.end(), tokens_[at_].text) != words.end();
    }
    bool is_kind(TokenKind kind) const { return !at_end() && tokens_[at_].kind == kind; }

    std::string text_of(const Span& span) const {
        const std::size_t begin = tokens_[span.first].offset;
        const Token& last = tokens_[span.last - 1];
        return text_.substr(begin, last.offset + last.text.size() - begin);
    }

    bool uses(const Span& span, const char* variable) const {
        const auto begin = tokens_.begin() + static_cast<std::ptrdiff_t>(span.first);
        const auto end = tokens_.begin() + static_cast<std::ptrdiff_t>(span.last);
        return std::any_of(begin, end, [&](const Token& token) {
            return token.kind == TokenKind::name && token.text == variable;
        });
    }

    void add(SwitchSource source) {
        const auto same = [&](const SwitchSource& other) {
            return other.chain == source.chain && other.knots == source.knots;
        };
        if (!source.has_time && !source.has_arc_length) return;
        if (found_.size() >= most_switches || std::any_of(found_.begin(), found_.end(), same)) return;
        found_.push_back(std::move(source));
    }

    void add(const Span& argument, std::vector<double> knots) {
        add({{text_of(argument)}, std::move(knots), uses(argument, "t"), uses(argument, "s")});
    }

    void add_difference(const Span& a, const Span& b) {
        add({{fmt::format("({}) - ({})", text_of(a), text_of(b))},
             {0.0},
             uses(a, "t") || uses(b, "t"),
             uses(a, "s") || uses(b, "s")});
    }

    // condition ? a : b
    void parse_choice() {
        parse_or();
        if (!is_operator({"?"})) return;
        ++at_;
        parse_choice();
        ++at_;  // ":"
        parse_choice();
    }

    void parse_or() {
        parse_comparison();
        while (is_operator({"&&", "||"})) {
            ++at_;
            parse_comparison();
        }
    }

    void parse_comparison() {
        Span left = parse_sum();
        while (is_operator({"<", ">", "<=", ">=", "==", "!="})) {
            ++at_;
            const Span right = parse_sum();
            add_difference(left, right);
            left.last = right.last;
        }
    }

    Span parse_sum() {
        const std::size_t first = at_;
        parse_sign();
        while (is_operator({"+", "-", "*", "/"})) {
            ++at_;
            parse_sign();
        }
        return {first, at_};
    }

    void parse_sign() {
        while (is_operator({"+", "-"})) ++at_;
        parse_power();
    }

    void parse_power() {
        const Span base = parse_primary();
        if (!is_operator({"^"})) return;
        const std::size_t exponent = ++at_;
        parse_sign();
        const std::string& word = tokens_[exponent].text;
        const bool is_whole = at_ == exponent + 1 && std::all_of(word.begin(), word.end(), [](char letter) {
                                  return std::isdigit(static_cast<unsigned char>(letter)) != 0;
                              });
        if (!is_whole) add(base, {0.0});
    }

    Span parse_primary() {
        const std::size_t first = at_;
        const bool is_name = is_kind(TokenKind::name);
        if (!is_kind(TokenKind::open)) ++at_;
        if (is_kind(TokenKind::open)) {
            const std::vector<Span> arguments = parse_arguments();
            if (is_name && at_ > first + 1) add_call(tokens_[first].text, arguments);
        }
        return {first, at_};
    }

    // ( … ) with what commas part.
    std::vector<Span> parse_arguments() {
        std::vector<Span> arguments;
        do {
            ++at_;
            const std::size_t first = at_;
            parse_choice();
            arguments.push_back({first, at_});
        } while (is_kind(TokenKind::comma));
        ++at_;
        return arguments;
    }

    void add_call(const std::string& name, const std::vector<Span>& arguments) {
        if (name == "abs" || name == "sign" || name == "sqrt" || name == "atan2") {
            add(arguments.front(), {0.0});
        } else if (name == "asin" || name == "acos") {
            add(arguments.front(), {-1.0, 1.0});
        } else if (name == "min" || name == "max") {
            for (std::size_t i = 0; i < arguments.size(); ++i) {
                for (std::size_t j = i + 1; j < arguments.size(); ++j)
                    add_difference(arguments[i], arguments[j]);
            }
        } else if (const auto found = symbols_.functions.find(name);
                   found != symbols_.functions.end() && found->second) {
            add_function(*found->second, arguments.front());
        }
    }

    void add_function(const FunctionDefinition& function, const Span& argument) {
        if (function.table.empty()) {
            for (const SwitchSource& inner : find_switches(function.expression, symbols_)) {
                add_composed(inner, argument);
            }
            return;
        }
        if (function.table.size() < 2) return;
        std::vector<double> knots;
        knots.reserve(function.table.size());
        for (const auto& [time, value] : function.table) knots.push_back(time);
        add(argument, std::move(knots));
    }

    // Of a function, whose t is the argument here.
    void add_composed(const SwitchSource& inner, const Span& argument) {
        SwitchSource composed{{text_of(argument)}, inner.knots, uses(argument, "t"), uses(argument, "s")};
        const std::string& outer = composed.chain.front();
        if (inner.chain.front() != "t" && outer != "t") {
            composed.chain.insert(composed.chain.end(), inner.chain.begin(), inner.chain.end());
        } else if (outer == "t") {
            composed.chain = inner.chain;
        } else {
            composed.chain.insert(composed.chain.end(), inner.chain.begin() + 1, inner.chain.end());
        }
        add(std::move(composed));
    }

    const std::string& text_;
    const std::vector<Token> tokens_;
    const Symbols& symbols_;
    std::size_t at_ = 0;
    std::vector<SwitchSource> found_;
};

}  // namespace

std::vector<SwitchSource> find_switches(const std::string& expression, const Symbols& symbols) {
    return SwitchFinder(expression, symbols).run();
}

}  // namespace gxrod
