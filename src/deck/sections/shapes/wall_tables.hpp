#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "cross_section/walls/wall_outline.hpp"
#include "deck/schema/choices.hpp"
#include "deck/table/corner_kinds.hpp"
#include "deck/table/kinds.hpp"
#include "deck/table/named_tables.hpp"
#include "deck/text/fault_list.hpp"
#include "mesh/mesh_files.hpp"
#include "mesh/sections/surface_file.hpp"

// The tables of `walls` and `mesh` of a section's shape.
namespace gxrod {

inline constexpr std::array<Choice<WallSide>, 3> wall_side_choices{
    {{"left", WallSide::left}, {"middle", WallSide::middle}, {"right", WallSide::right}}};
inline constexpr const auto& choices_of(WallSide) { return wall_side_choices; }

struct WallsTable : TableHead {
    CornerRows corners;
    std::optional<bool> closed;
    WallSide line = WallSide::middle;
    TableNames layup;
};

struct MeshGroupTable : TableHead {
    TableName material;
    std::optional<double> angle;
    std::optional<std::string> along;
    std::optional<double> direction;
    std::optional<std::string> directions;
};

struct MeshShapeTable : TableHead {
    std::string file;
    double scale = 1.0;
    NamedTables<MeshGroupTable> groups;
    std::optional<TableName> material;
};

const TableSpec& walls_table();
const TableSpec& mesh_shape_table();

}  // namespace gxrod
