#pragma once

#include <fmt/format.h>

#include <array>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/reading/number_reader.hpp"

namespace gxrod {

// Reads expressions of times, places and the like.
class FunctionReader : public NumberReader {
  public:
    using NumberReader::NumberReader;
    std::optional<CheckedTimeFunction> time_function(const DeckNode& node, const std::string& path) const;
    // Reads f(t), or a table of them by name.
    std::optional<std::vector<CheckedNamedFunction>> named_functions(const DeckNode& node,
                                                                     const std::string& path) const;
    std::optional<std::vector<CheckedNamedFunction>> coordinate_functions(const DeckNode& node,
                                                                          const std::string& path) const;
    // Reads a number, or f(s), whose range is checked where it is evaluated.
    std::optional<std::variant<double, CheckedArcFunction>> arc_number(const DeckNode& node,
                                                                       const std::string& path) const;
    std::optional<CheckedLineFunction> line_function(const DeckNode& node, const std::string& path) const;
    std::optional<CheckedPlaceFunction> place_function(const DeckNode& node, const std::string& path) const;
    std::optional<CheckedMotionFunction> motion_function(const DeckNode& node, const std::string& path) const;
    std::optional<CheckedLineMotionFunction> line_motion_function(const DeckNode& node,
                                                                  const std::string& path) const;
    std::optional<CheckedMotionFunction> field_function(const DeckNode& node, const std::string& path) const;
    std::optional<CheckedSpringFunction> spring_function(const DeckNode& node, const std::string& path) const;
    std::optional<CheckedAngleFunction> angle_function(const DeckNode& node, const std::string& path) const;
    // Reads functions with one of the members above.
    template <std::size_t Count, class Function>
    std::optional<std::array<Function, Count>> functions(
        const DeckNode& node,
        const std::string& path,
        std::optional<Function> (FunctionReader::*read)(const DeckNode&, const std::string&) const) const {
        if (!is_array_of(node, Count)) {
            expect(node, path, describe_expected(key_));
            return std::nullopt;
        }
        std::array<Function, Count> vector;
        bool complete = true;
        for (std::size_t i = 0; i < Count; ++i) {
            auto component = (this->*read)((*node.array())[i], fmt::format("{}[{}]", path, i));
            complete = complete && component;
            if (component) vector[i] = std::move(*component);
        }
        return complete ? std::optional(std::move(vector)) : std::nullopt;
    }

  private:
    // Compiles an expression, or reads a number.
    template <class Function, class Compile>
    std::optional<Function> compiled(const DeckNode& node,
                                     const std::string& path,
                                     const Compile& compile) const;
    template <class Function>
    static Function constant(double value);
};

}  // namespace gxrod
