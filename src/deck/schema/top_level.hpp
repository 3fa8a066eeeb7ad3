#pragma once

#include <optional>
#include <string>
#include <variant>

#include "deck/loads/gravity_table.hpp"
#include "deck/reading/checked_deck.hpp"
#include "deck/schema/choices.hpp"
#include "deck/table/table_head.hpp"

// The keys before the first [table].
namespace gxrod {

struct TopLevelTable : TableHead {
    std::string title;
    std::string units;
    std::optional<std::variant<CheckedTimeVector, GravityTable>> gravity;
    std::optional<PlaneAcross> plane;
    std::optional<std::string> apply;
};

// The keys of a whole deck.
const TopLevelTable& top_level_of(const CheckedTable& deck);

}  // namespace gxrod
