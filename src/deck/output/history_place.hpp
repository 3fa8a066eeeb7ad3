#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "deck/places/build_context.hpp"

namespace gxrod {

// The index of what has the name, as the model is built; nullopt without it.
template <class Thing>
std::optional<int> find_named(const std::vector<Thing>& things, const std::string& name) {
    const auto found = std::ranges::find(things, name, &Thing::name);
    if (found == things.end()) return std::nullopt;
    return static_cast<int>(found - things.begin());
}

// A thing that `at` of a history names, and its text.
struct WatchedText {
    std::string text;
    Watched thing;
};

// Finds the things that a text names, in which * stands for any letters; none, without a fault, where they
// could not be built.
std::vector<WatchedText> find_watched(const std::string& text, const BuildContext& context);

// Returns why a text of `at` names nothing; "" if it names something.
std::string explain_no_watched(const std::string& text, const BuildContext& context);

}  // namespace gxrod
