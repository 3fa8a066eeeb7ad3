#include "batch/component_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace gxrod {
namespace {

// What numbers of a width are, and their components in order.
struct ComponentList {
    const char* kind;
    std::vector<Component> components;
};

const ComponentList& components_of(int width) {
    using enum Component;
    static const std::map<int, ComponentList> lists{{2, {"a point", {y, z}}},
                                                    {3, {"a vector", {x, y, z, magnitude}}},
                                                    {4, {"a quaternion", {w, x, y, z}}},
                                                    {6, {"a stress", {xx, yy, zz, yz, xz, xy}}}};
    return lists.at(width);
}

}  // namespace

double take_component(const ComponentRow& values, std::optional<Component> component) {
    if (!component) return values.numbers[0];
    if (*component == Component::magnitude)
        return std::hypot(values.numbers[0], values.numbers[1], values.numbers[2]);
    const std::vector<Component>& known = components_of(values.width).components;
    return values.numbers[static_cast<std::size_t>(std::ranges::find(known, *component) - known.begin())];
}

std::string explain_component(std::optional<Component> component, int width) {
    if (width == 1) return component ? "is a single number, without components" : "";
    const auto& [kind, known] = components_of(width);
    if (component && std::ranges::find(known, *component) != known.end()) return "";
    std::string words;
    for (std::size_t i = 0; i < known.size(); ++i) {
        const char* before = i == 0 ? "" : i + 1 < known.size() ? ", " : " or ";
        words += fmt::format("{}\"{}\"", before, word_of(component_choices, known[i]));
    }
    return fmt::format("is {}; expected component {}", kind, words);
}

}  // namespace gxrod
