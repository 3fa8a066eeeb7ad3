#include "deck/reading/checked_deck.hpp"

namespace gxrod {

const CheckedValue* CheckedTable::find(std::string_view key) const {
    for (const CheckedValue& value : values) {
        if (value.key == key) return &value;
    }
    return nullptr;
}

bool CheckedTable::gives(std::string_view key) const {
    const CheckedValue* value = find(key);
    return value != nullptr && value->given;
}

Place CheckedTable::place_of(std::string_view key) const { return gives(key) ? find(key)->place : place; }

const std::vector<CheckedTable>& CheckedTable::tables(std::string_view key) const {
    static const std::vector<CheckedTable> none;
    const CheckedValue* value = find(key);
    const auto* tables = value ? std::get_if<std::vector<CheckedTable>>(&value->value) : nullptr;
    return tables ? *tables : none;  // a key with a faulty value has none either
}

}  // namespace gxrod
