#include "batch/counted_quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "watch/quantity_tables.hpp"

namespace gxrod {
namespace {

// A quantity without a sign, or sorted by size, with what has one.
struct Signless {
    std::string_view word, instead;
};

constexpr std::string_view stress_at_a_point =
    R"(quantity = "stress" and a component, such as "xx", of a history with point = [y, z])";
constexpr std::array signless_quantities{
    Signless{"von_mises", stress_at_a_point},
    Signless{"principal_stress", stress_at_a_point},
    Signless{"exposure", stress_at_a_point},
    Signless{"bending_moment", R"(quantity = "moment" and component "y" or "z")"},
    Signless{"shear_force", R"(quantity = "force" and component "y" or "z")"}};

constexpr std::string_view effect = "has no sign: what changes its sign would count with half of its range";

}  // namespace

CountFault find_count_fault(const Collection& collection, const HistoryRequest& history) {
    const auto signless = std::ranges::find(signless_quantities, collection.quantity, &Signless::word);
    if (signless != signless_quantities.end())
        return {"quantity", fmt::format("{} {}; take {}", collection.quantity, effect, signless->instead)};
    if (collection.component == Component::magnitude)
        return {"component", fmt::format(R"("magnitude" {}; take "x", "y" or "z")", effect)};
    if (is_stress_quantity(collection.quantity) && !history.section_point)
        return {"history",
                fmt::format("\"{}\" has the stress of another point of the section at each time, the worst "
                            "one, and cycles are those of one point; give the history point = [y, z]",
                            history.name)};
    return {};
}

}  // namespace gxrod
