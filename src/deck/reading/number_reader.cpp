#include "deck/reading/number_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "deck/expressions/expression.hpp"
#include "deck/table/binding.hpp"
#include "machine/printable.hpp"

namespace gxrod {

std::optional<double> NumberReader::number(const DeckNode& node, const std::string& path) const {
    const std::optional<double> value = finite_number(node, path);
    return value ? in_range(node, path, *value) : std::nullopt;
}

std::optional<double> NumberReader::finite_number(const DeckNode& node, const std::string& path) const {
    std::optional<double> value;
    if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
        value = static_cast<double>(*integer);
    } else if (const auto* real = std::get_if<double>(&node.value)) {
        value = *real;
    } else if (const std::string* text = node.text()) {
        try {
            value = evaluate_constant(*text, context_.symbols);
        } catch (const ExpressionError& error) {
            add(node, path, fmt::format("\"{}\": {}", shorten(*text), error.what()));
        }
    } else {
        expect(node, path, number_expected());
    }
    if (!value) return std::nullopt;
    if (!std::isfinite(*value)) {
        add(node, path, "expected a finite number, found " + describe_found(node));
        return std::nullopt;
    }
    return value;
}

std::optional<long> NumberReader::integer(const DeckNode& node, const std::string& path) const {
    if (std::holds_alternative<double>(node.value)) {
        expect(node, path, describe_expected(key_));
        return std::nullopt;
    }
    if (node.text() == nullptr && !std::holds_alternative<std::int64_t>(node.value)) {
        expect(node, path, describe_expected(key_) + " or an expression");
        return std::nullopt;
    }
    const std::optional<double> value = number(node, path);
    if (!value) return std::nullopt;
    if (std::floor(*value) != *value) {
        add(node,
            path,
            fmt::format("expected {}, found {}", describe_expected(key_), found_value(node, *value)));
        return std::nullopt;
    }
    return static_cast<long>(*value);
}

std::optional<Vec3> NumberReader::vector(const DeckNode& node, const std::string& path) const {
    if (!is_array_of(node, 3)) {
        expect(node, path, describe_expected(key_));
        return std::nullopt;
    }
    Vec3 vector;
    bool complete = true;
    for (int i = 0; i < 3; ++i) {
        const auto component = number((*node.array())[i], fmt::format("{}[{}]", path, i));
        complete = complete && component;
        vector[i] = component.value_or(0.0);
    }
    return complete ? std::optional(vector) : std::nullopt;
}

std::optional<Mat3> NumberReader::square_matrix(const DeckNode& node, const std::string& path) const {
    if (is_array_of(node, 3)) return matrix(node, path);
    expect(node, path, describe_expected(key_));
    return std::nullopt;
}

std::optional<Mat3> NumberReader::matrix(const DeckNode& node, const std::string& path) const {
    const DeckNode::Array& rows = *node.array();
    Mat3 matrix;
    bool complete = true;
    for (int i = 0; i < 3; ++i) {
        const auto row = vector(rows[i], fmt::format("{}[{}]", path, i));
        complete = complete && row;
        matrix.row(i) = row.value_or(Vec3::Zero()).transpose();
    }
    return complete ? std::optional(matrix) : std::nullopt;
}

std::optional<bool> NumberReader::flag(const DeckNode& node, const std::string& path) const {
    if (const auto* value = std::get_if<bool>(&node.value)) return *value;
    expect(node, path, describe_expected(key_));
    return std::nullopt;
}

void NumberReader::add(const DeckNode& node, const std::string& path, const std::string& message) const {
    context_.faults.add(node.place, path, message);
}

void NumberReader::expect(const DeckNode& node, const std::string& path, const std::string& expected) const {
    add(node, path, fmt::format("expected {}, found {}", expected, describe_found(node)));
}

std::optional<double> NumberReader::in_range(const DeckNode& node,
                                             const std::string& path,
                                             double value) const {
    if (key_.range.contains(value)) return value;
    const std::string kind = nature_of(key_) == ValueNature::integer ? "an integer" : "a number";
    const std::string& above = key_.above_range;
    const std::string reason = value > key_.range.upper && !above.empty() ? "; " + above : remark();
    add(node,
        path,
        fmt::format("expected {} {}, found {}{}",
                    kind,
                    describe_range(key_.range),
                    found_value(node, value),
                    reason));
    return std::nullopt;
}

std::string NumberReader::found_value(const DeckNode& node, double value) {
    return node.text() == nullptr ? describe_found(node) : fmt::format("\"{}\" = {}", *node.text(), value);
}

std::string NumberReader::number_expected() const {
    return nature_of(key_) == ValueNature::number ? describe_expected(key_) : "a number or an expression";
}

}  // namespace gxrod
