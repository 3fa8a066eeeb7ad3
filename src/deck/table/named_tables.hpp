#pragma once

#include <vector>

#include "deck/table/table.hpp"

namespace gxrod {

// Tables with names of the deck's own within a table: groups = { core = { … }, skin = { … } }.
template <IsTable Inner>
struct NamedTables {
    std::vector<Inner> tables;
};

template <IsTable Inner>
struct FieldTraits<NamedTables<Inner>> {
    using Value = Inner;
    static constexpr KeyShape shape = KeyShape::named_tables;
    static const void* find(const NamedTables<Inner>& field) {
        return field.tables.empty() ? nullptr : &field;
    }
    static void hold(const Inner& table, NamedTables<Inner>& field) { field.tables.push_back(table); }
};

}  // namespace gxrod
