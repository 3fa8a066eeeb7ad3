#include "deck/loads/gravity_table.hpp"

#include "deck/schema/top_level.hpp"

namespace gxrod {

const TableSpec& gravity_table() {
    using T = GravityTable;
    // clang-format off
    static const TableSpec table = Table<T>("gravity", "")
        .key("acceleration", &T::acceleration, "The acceleration, global components.")
            .unit("length/time²").required().also("value vector g")
        .key("factor", &T::factor, factor_sentence("gravity"))
            .unit("1").otherwise(factor_default)
        .key("stages", &T::stages, "The stages in which it acts.")
            .otherwise("all").names_of({"stage"});
    // clang-format on
    return table;
}

const CheckedTimeVector* find_gravity(const CheckedTable& deck) {
    const auto& given = top_level_of(deck).gravity;
    if (!given) return nullptr;
    const auto* table = std::get_if<GravityTable>(&*given);
    return table != nullptr ? &table->acceleration : &std::get<CheckedTimeVector>(*given);
}

Acting find_gravity_acting(const BuildContext& context) {
    const auto& given = top_level_of(context.deck).gravity;
    const GravityTable* table = given ? std::get_if<GravityTable>(&*given) : nullptr;
    return table != nullptr ? find_acting(*table, context) : find_acting(context);
}

}  // namespace gxrod
