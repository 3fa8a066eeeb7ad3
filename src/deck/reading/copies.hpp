#pragma once

#include <optional>
#include <variant>

#include "deck/table/table.hpp"
#include "deck/text/deck_tree.hpp"

// Tables that a deck writes once and has several times, turned about an axis: the blades of a rotor.
namespace gxrod {

struct CopiesTable : TableHead {
    long count = 0;
    Vec3 about = Vec3::UnitZ();
    Vec3 through = Vec3::Zero();
};

const TableSpec& copies_table();

// The copies of a table, or the name of the table whose copies it follows. A deck that is checked has none
// left: expand_copies has replaced the table by its copies.
using Copies = std::optional<std::variant<TableName, CopiesTable>>;

// Adds the key `copies`, whose field is `copies`.
template <class T>
void add_copies(Table<T>& table) {
    table
        .key("copies",
             &T::copies,
             copies_table(),
             "The table several times, turned about an axis in equal parts of a turn: NAME_1, which is as "
             "written, "
             "NAME_2 and so on. Or the name of a table with copies: then as many, each with the copy of the "
             "same "
             "number of whatever it names.")
        .names_of({"rod", "body", "joint", "gear", "spring", "bushing"})
        .otherwise("the table once")
        .also("copy repeat count pattern instances replicate");
}

bool has_copies(const DeckNode& tree);

// Replaces each table that has `copies` by its copies. Points, directions and loads turn with them; names of
// other tables that have copies get the number of the copy.
void expand_copies(DeckNode& tree, FaultList& faults);

}  // namespace gxrod
