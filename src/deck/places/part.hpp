#pragma once

#include <optional>
#include <vector>

#include "deck/places/build_context.hpp"
#include "deck/schema/schema.hpp"

// Rods and bodies that the keys of a deck name.
namespace gxrod {

// A rod or a body: an index in Model::rods or Model::bodies, the other one is -1.
struct Part {
    int rod = -1;
    int body = -1;
};

// The index of the table of this name.
std::optional<int> find_index(const std::vector<CheckedTable>& tables, std::string_view name);

// The part that a field of the table names, whose key says whether that can be a rod, a body or either;
// nullopt with a fault if there is none.
std::optional<Part> find_part(const TableHead& table, const TableName& field, const BuildContext& context);

// Finds the parts that a key names which takes one name or a list of them, in which * stands for any letters,
// each once; any other word is a fault.
std::vector<Part> find_parts(const TableHead& table, const TableNames& field, const BuildContext& context);

}  // namespace gxrod
