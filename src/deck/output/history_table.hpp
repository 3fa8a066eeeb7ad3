#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "deck/places/build_context.hpp"
#include "deck/reading/copies.hpp"
#include "deck/schema/choices.hpp"
#include "deck/table/kinds.hpp"
#include "deck/table/place_kinds.hpp"
#include "model/settings/settings.hpp"

// [[history]].
namespace gxrod {

// Axes of a history that is relative to a point of a rod.
enum class HistoryAxes { section, untwisted };
inline constexpr std::array<Choice<HistoryAxes>, 2> history_axes_choices{
    {{"section", HistoryAxes::section}, {"untwisted", HistoryAxes::untwisted}}};
inline constexpr const auto& choices_of(HistoryAxes) { return history_axes_choices; }

struct HistoryKeys : TableHead {
    PointPatterns at;
    std::optional<std::string> with;
    std::optional<PointName> relative_to;
    HistoryAxes axes = HistoryAxes::section;
    std::optional<Vec3> about, no_load;
    std::optional<std::array<double, 2>> point;
    std::optional<std::string> criterion;
    WordList quantities;
    Copies copies;
};

// Builds the histories. Call it after build_supports.
std::vector<HistoryRequest> build_histories(const BuildContext& context);

}  // namespace gxrod
