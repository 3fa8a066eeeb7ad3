#include "batch/counted_quantity.hpp"

#include <fmt/format.h>

#include <string_view>

#include "watch/quantity_tables.hpp"
#include "watch/signless_words.hpp"

namespace gxrod {
namespace {

constexpr std::string_view effect = "has no sign: what changes its sign would count with half of its range";

}  // namespace

CountFault find_count_fault(const Collection& collection, const HistoryRequest& history) {
    if (const std::string_view instead = find_signed_instead(collection.quantity); !instead.empty())
        return {"quantity", fmt::format("{} {}; take {}", collection.quantity, effect, instead)};
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
