#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "deck/places/build_context.hpp"

namespace gxrod {

// Where a history looks.
struct HistoryPlace {
    int node;  // -1: between nodes, a spring, a bushing, a joint or a tendon
    int body;  // -1: of a rod, a spring, a bushing, a joint or a tendon
    std::optional<RodPlace> place;
    int spring = -1;
    int bushing = -1;
    int joint = -1;
    int gear = -1;
    int sleeve = -1;
    int tendon = -1;
    int obstacle = -1;
    int touching_rod = -1;
};

// The index of what has the name, as the model is built; nullopt without it.
template <class Tie>
std::optional<int> find_tie(const std::vector<Tie>& ties, const std::string& name) {
    const auto found = std::ranges::find(ties, name, &Tie::name);
    if (found == ties.end()) return std::nullopt;
    return static_cast<int>(found - ties.begin());
}

// What `at` of a history names; nullopt, without a fault, if that could not be built.
std::optional<HistoryPlace> find_history_place(const std::string& text, const BuildContext& context);

}  // namespace gxrod
