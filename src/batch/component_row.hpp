#pragma once

#include <optional>
#include <string>

#include "batch/plan/plan_words.hpp"
#include "watch/quantity.hpp"

namespace gxrod {

// A number, or what has components: two of a place in a section, three of a vector, four of a quaternion, six
// of a stress.
struct ComponentRow {
    HistoryRow numbers{};
    int width = 1;
};

// Returns the component, which explain_component finds nothing wrong with.
double take_component(const ComponentRow& values, std::optional<Component> component);

// Says what is wrong with a component of rows of this width: "is a vector; expected …"; "" if nothing is.
std::string explain_component(std::optional<Component> component, int width);

}  // namespace gxrod
