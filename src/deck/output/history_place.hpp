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

// The thing that `at` of a history names; nullopt, without a fault, if it could not be built.
std::optional<Watched> find_watched(const std::string& text, const BuildContext& context);

}  // namespace gxrod
