#include "deck/sections/shapes/wall_tables.hpp"

#include <cmath>

#include "deck/table/table.hpp"

namespace gxrod {
namespace {

const TableSpec& mesh_group_table() {
    using T = MeshGroupTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.mesh.groups.NAME", "")
        .key("material", &T::material, "What its surfaces are made of.")
            .names_of({"material"}).required().also("mat")
        .key("angle", &T::angle, "Of the fibres from x towards t, the direction of the wall.")
            .unit("angle").otherwise("0").also("fibre_angle fiber_angle theta orientation")
        .key("along", &T::along, "A physical group of curves: t is the tangent at their nearest point. Closed curves are walked "
             "anticlockwise, open ones as their first line.")
            .also("curve tangent")
        .key("direction", &T::direction, "The angle of t from y towards z.")
            .unit("angle").otherwise("0: t is y").also("beta plane_angle")
        .key("directions", &T::directions, "Data of the file on its elements, $ElementData or $ElementNodeData, with the angle of t "
             "of each element, or at each of its nodes, in radians.")
            .also("element_data plane_angles")
        .at_most_one_of({"along", "direction", "directions"});
    // clang-format on
    return table;
}

}  // namespace

const TableSpec& walls_table() {
    using T = WallsTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.walls", "")
        .key("corners", &T::corners, "Corners [y, z] of a line along the wall. A third number rounds the line there; without "
             "it walls are mitred.")
            .unit("length").required().also("points outline nodes")
        .key("closed", &T::closed, "Whether the last corner goes on to the first; then they go anticlockwise, y to the right and z "
             "up.")
            .otherwise("false").also("is_closed")
        .key("line", &T::line, "Which side of the wall the line is, for who walks along it.")
            .also("side reference offset")
        .key("layup", &T::layup, "The plies of all sides, or a list with one layup a side. Where layups change, the middle of a "
             "rounded corner parts them.")
            .names_of({"layup"}).required().also("layups plies laminate");
    // clang-format on
    return table;
}

const TableSpec& mesh_shape_table() {
    using T = MeshShapeTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.mesh", "")
        .key("file", &T::file, "A .msh file of Gmsh with triangles or quadrangles of order 1 to 3 in a plane z = constant, whose x "
             "and y become y and z, or in a plane x = constant. Relative to the deck's folder.")
            .required().also("path name")
        .key("scale", &T::scale, "Times the coordinates of the file: 1e-3 for one in mm.")
            .unit("1").above(0).also("factor unit")
        .key("groups", &T::groups, mesh_group_table(), "What the physical groups of surfaces are made of, by their names, or "
             "numbers if they have none. Every surface is in one. core = \"foam\" is short for core = { material = \"foam\" }.")
            .also("materials regions layers")
        .key("material", &T::material, "What all surfaces are made of, whatever their groups.")
            .names_of({"material"}).also("mat")
        .exactly_one_of({"groups", "material"});
    // clang-format on
    return table;
}

}  // namespace gxrod
