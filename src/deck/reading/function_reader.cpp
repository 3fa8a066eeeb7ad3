#include "deck/reading/function_reader.hpp"

#include "deck/schema/suggestion.hpp"
#include "machine/printable.hpp"

namespace gxrod {

template <class Function>
Function FunctionReader::constant(double value) {
    if constexpr (std::is_same_v<Function, PlaceExpression>) {
        return {[value](const Vec3&, double) { return value; }};
    } else if constexpr (std::is_same_v<Function, LineExpression>) {
        return {LineFunction(value)};
    } else if constexpr (std::is_same_v<Function, MotionExpression>) {
        return {.by_time = TimeFunction(value)};
    } else if constexpr (std::is_same_v<Function, LineMotionExpression>) {
        return {.by_line = {LineFunction(value)}};
    } else if constexpr (std::is_same_v<Function, SpringExpression>) {
        return {[value](double, double) { return value; }};
    } else if constexpr (std::is_same_v<Function, AngleExpression>) {
        return {[value](double) { return value; }};
    } else {
        return TimeFunction(value);
    }
}

template <class Function, class Compile>
std::optional<Function> FunctionReader::compiled(const DeckNode& node,
                                                 const std::string& path,
                                                 const Compile& compile) const {
    if (const std::string* text = node.text()) {
        try {
            return compile(*text, path, context_.symbols);
        } catch (const ExpressionError& error) {
            add(node, path, fmt::format("\"{}\": {}", shorten(*text), error.what()));
        }
        return std::nullopt;
    }
    if (!std::holds_alternative<std::int64_t>(node.value) && !std::holds_alternative<double>(node.value)) {
        expect(node, path, "a number or an expression in " + variables_of(key_));
        return std::nullopt;
    }
    const std::optional<double> value = number(node, path);
    if (!value) return std::nullopt;
    return constant<Function>(*value);
}

std::optional<CheckedTimeFunction> FunctionReader::time_function(const DeckNode& node,
                                                                 const std::string& path) const {
    auto function = compiled<TimeFunction>(node, path, compile_time_function);
    if (!function) return std::nullopt;
    return CheckedTimeFunction{std::move(*function), node.place, path};
}

std::optional<std::vector<CheckedNamedFunction>> FunctionReader::named_functions(
    const DeckNode& node, const std::string& path) const {
    std::vector<CheckedNamedFunction> functions;
    bool complete = true;
    const auto read = [&](const std::string& name, const DeckNode& value, const std::string& at) {
        auto function = time_function(value, at);
        complete = complete && function;
        if (function) functions.push_back({name, std::move(*function)});
    };
    if (node.table() == nullptr) {
        read("", node, path);
    } else if (node.table()->empty()) {
        expect(node, path, describe_expected(key_));
        complete = false;
    } else {
        for (const DeckEntry& entry : *node.table()) read(entry.key, entry.node, path + "." + entry.key);
    }
    return complete ? std::optional(std::move(functions)) : std::nullopt;
}

std::optional<std::vector<CheckedNamedFunction>> FunctionReader::coordinate_functions(
    const DeckNode& node, const std::string& path) const {
    if (node.table() == nullptr) return named_functions(node, path);
    bool complete = true;
    for (const DeckEntry& entry : *node.table()) {
        if (entry.key == "turn" || entry.key == "slide") continue;
        const std::string hint = did_you_mean(entry.key, {"turn", "slide"});
        context_.faults.add(entry.place,
                            path + "." + entry.key,
                            "unknown key" + (hint.empty() ? "; known here: turn, slide" : hint));
        complete = false;
    }
    return complete ? named_functions(node, path) : std::nullopt;
}

std::optional<std::variant<double, CheckedArcFunction>> FunctionReader::arc_number(
    const DeckNode& node, const std::string& path) const {
    std::optional<double> value;
    if (node.text() == nullptr) {
        value = number(node, path);
    } else {
        try {
            const auto expression = compile_arc_function(*node.text(), path, context_.symbols);
            if (expression && expression->function) return CheckedArcFunction{expression->function};
            if (expression) value = in_range(node, path, expression->constant);
        } catch (const ExpressionError& error) {
            add(node, path, fmt::format("\"{}\": {}", shorten(*node.text()), error.what()));
        }
    }
    return value;
}

std::optional<CheckedLineFunction> FunctionReader::line_function(const DeckNode& node,
                                                                 const std::string& path) const {
    auto expression = compiled<LineExpression>(node, path, compile_line_function);
    if (!expression) return std::nullopt;
    return CheckedLineFunction{std::move(*expression), node.place, path};
}

std::optional<CheckedPlaceFunction> FunctionReader::place_function(const DeckNode& node,
                                                                   const std::string& path) const {
    auto expression = compiled<PlaceExpression>(node, path, compile_place_function);
    if (!expression) return std::nullopt;
    return CheckedPlaceFunction{std::move(*expression), node.place, path};
}

std::optional<CheckedMotionFunction> FunctionReader::motion_function(const DeckNode& node,
                                                                     const std::string& path) const {
    auto expression = compiled<MotionExpression>(node, path, compile_motion_function);
    if (!expression) return std::nullopt;
    return CheckedMotionFunction{std::move(*expression), node.place, path};
}

std::optional<CheckedLineMotionFunction> FunctionReader::line_motion_function(const DeckNode& node,
                                                                              const std::string& path) const {
    auto expression = compiled<LineMotionExpression>(node, path, compile_line_motion_function);
    if (!expression) return std::nullopt;
    return CheckedLineMotionFunction{std::move(*expression), node.place, path};
}

std::optional<CheckedMotionFunction> FunctionReader::field_function(const DeckNode& node,
                                                                    const std::string& path) const {
    auto expression = compiled<MotionExpression>(node, path, compile_field_function);
    if (!expression) return std::nullopt;
    return CheckedMotionFunction{std::move(*expression), node.place, path};
}

std::optional<CheckedSpringFunction> FunctionReader::spring_function(const DeckNode& node,
                                                                     const std::string& path) const {
    auto expression = compiled<SpringExpression>(node, path, compile_spring_function);
    if (!expression) return std::nullopt;
    return CheckedSpringFunction{std::move(*expression), node.place, path};
}

std::optional<CheckedAngleFunction> FunctionReader::angle_function(const DeckNode& node,
                                                                   const std::string& path) const {
    auto expression = compiled<AngleExpression>(node, path, compile_angle_function);
    if (!expression) return std::nullopt;
    return CheckedAngleFunction{std::move(*expression), node.place, path};
}

}  // namespace gxrod
