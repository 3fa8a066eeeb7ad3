#include "deck/bodies/looks_table.hpp"

#include "deck/table/table.hpp"

namespace gxrod {
namespace {

// Adds where a part is.
template <class T>
TableSpec with_place(Table<T> table) {
    // clang-format off
    return table
        .key("at", &T::at, "Where it is, from the node, body axes: of a box its centre, of a file its origin.")
            .unit("length").also("position centre center")
        .key("rotation_vector", &T::rotation_vector, "How it is turned against the body axes.")
            .unit("angle").also("rotation orientation");
    // clang-format on
}

const TableSpec& look_box_table() {
    using T = LookBoxTable;
    // clang-format off
    static const TableSpec table = with_place(Table<T>("body.NAME.looks.box", "")
        .key("size", &T::size, "Its edges along x, y and z, greater than 0.")
            .unit("length").required().also("sizes dimensions edges"));
    // clang-format on
    return table;
}

const TableSpec& look_cylinder_table() {
    using T = LookCylinderTable;
    // clang-format off
    static const TableSpec table = Table<T>("body.NAME.looks.cylinder", "")
        .key("from", &T::from, "A centre of an end, from the node, body axes.")
            .unit("length").required()
        .key("to", &T::to, "That of the other end.")
            .unit("length").required()
        .key("radius", &T::radius, "Its own.")
            .unit("length").above(0).required();
    // clang-format on
    return table;
}

const TableSpec& look_sphere_table() {
    using T = LookSphereTable;
    // clang-format off
    static const TableSpec table = Table<T>("body.NAME.looks.sphere", "")
        .key("radius", &T::radius, "Its own.")
            .unit("length").above(0).required()
        .key("centre", &T::centre, "From the node, body axes.")
            .unit("length").also("at position center");
    // clang-format on
    return table;
}

const TableSpec& look_mesh_table() {
    using T = LookMeshTable;
    // clang-format off
    static const TableSpec table = with_place(Table<T>("body.NAME.looks.mesh", "")
        .key("file", &T::file, "STL, as text or binary, or .msh of Gmsh. Relative to the deck's folder.")
            .required()
        .key("scale", &T::scale, "Times the coordinates of the file: 1e-3 for one in mm.")
            .unit("1").above(0));
    // clang-format on
    return table;
}

}  // namespace

const TableSpec& look_table() {
    using T = LookTable;
    // clang-format off
    static const TableSpec table = Table<T>("body.NAME.looks[]", "")
        .key("box", &T::box, look_box_table(), "A cuboid.")
            .also("cuboid brick")
        .key("cylinder", &T::cylinder, look_cylinder_table(), "With flat ends.")
        .key("sphere", &T::sphere, look_sphere_table(), "A ball.")
            .also("ball")
        .key("arms", &T::arms, "Radius of bars from the centre of mass to each joint, spring and bushing of the "
             "body; 0 for lines.")
            .unit("length").at_least(0).also("joints bars links lines")
        .key("mesh", &T::mesh, look_mesh_table(), "Triangles of a file.")
            .also("file stl")
        .exactly_one_of({"box", "cylinder", "sphere", "arms", "mesh"});
    // clang-format on
    return table;
}

}  // namespace gxrod
