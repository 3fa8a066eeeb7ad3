#include "deck/reading/reading_context.hpp"

#include <fmt/format.h>

#include <cmath>

#include "machine/printable.hpp"

namespace gxrod {
namespace {

struct FoundDescription {
    std::string operator()(const DeckNode::Table&) const { return "a table"; }
    std::string operator()(const DeckNode::Array& array) const {
        return array.empty() ? "an empty array" : fmt::format("an array of {}", array.size());
    }
    std::string operator()(const std::string& text) const {
        return fmt::format("the text \"{}\"", shorten(text));
    }
    std::string operator()(std::int64_t number) const { return fmt::format("{}", number); }
    std::string operator()(double number) const {
        if (std::isnan(number)) return "nan";
        return std::floor(number) == number && std::abs(number) < 1e15 ? fmt::format("{:.1f}", number)
                                                                       : fmt::format("{}", number);
    }
    std::string operator()(bool) const { return "a boolean"; }
    std::string operator()(const DeckDate&) const { return "a date"; }
};

}  // namespace

std::string describe_found(const DeckNode& node) { return std::visit(FoundDescription{}, node.value); }

}  // namespace gxrod
