#include "deck/sections/shapes/profile_keys.hpp"

namespace gxrod {
namespace {

constexpr const char* inner_corners = "Radius of the inner corners between web and flanges.";
constexpr const char* bends =
    "Inner radius of the bends; the outer one is greater by the wall. Left out: sharp.";

const TableSpec& i_table() {
    using T = ITable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.I", "")
        .key("height", &T::height, "Height over all, along z.")
            .unit("length").above(0).required().also("h d depth")
        .key("width", &T::width, "Width of the flanges, along y.")
            .unit("length").above(0).required().also("b bf w flange_width")
        .key("web", &T::web, "Thickness of the web.")
            .unit("length").above(0).required().also("tw s t_w web_thickness")
        .key("flange", &T::flange, "Thickness of the flanges.")
            .unit("length").above(0).required().also("tf t t_f flange_thickness")
        .key("fillet", &T::fillet, inner_corners)
            .unit("length").at_least(0).also("r radius root_radius");
    // clang-format on
    return table;
}

const TableSpec& channel_table() {
    using T = ChannelTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.channel", "")
        .key("height", &T::height, "Height over all, along z.")
            .unit("length").above(0).required().also("h d depth")
        .key("width", &T::width, "Width over all, along y, from the back of the web.")
            .unit("length").above(0).required().also("b bf w")
        .key("web", &T::web, "Thickness of the web.")
            .unit("length").above(0).required().also("tw s t_w")
        .key("flange", &T::flange, "Thickness of the flanges; of sloping ones at half of the width.")
            .unit("length").above(0).required().also("tf t t_f")
        .key("fillet", &T::fillet, inner_corners)
            .unit("length").at_least(0).also("r r1 radius root_radius")
        .key("toe", &T::toe, "Radius of the inner edges of the flanges' ends.")
            .unit("length").at_least(0).also("r2 toe_radius")
        .key("slope", &T::slope, "Of the inner faces of the flanges, that become thicker towards the web: 0.08 of a UPN.")
            .unit("1").at_least(0);
    // clang-format on
    return table;
}

const TableSpec& angle_table() {
    using T = AngleTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.angle", "")
        .key("height", &T::height, "Length of the leg along z, from the outer corner.")
            .unit("length").above(0).required().also("h a leg")
        .key("width", &T::width, "Length of the leg along y, from the outer corner.")
            .unit("length").above(0).required().also("b w")
        .key("wall", &T::wall, "Thickness of both legs.")
            .unit("length").above(0).required().also("t thickness wall_thickness")
        .key("fillet", &T::fillet, "Radius of the inner corner.")
            .unit("length").at_least(0).also("r r1 radius root_radius")
        .key("toe", &T::toe, "Radius of the inner edges of the legs' ends.")
            .unit("length").at_least(0).also("r2 toe_radius");
    // clang-format on
    return table;
}

const TableSpec& tee_table() {
    using T = TeeTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.tee", "")
        .key("height", &T::height, "Height over all, along z, from the foot of the web.")
            .unit("length").above(0).required().also("h d depth")
        .key("width", &T::width, "Width of the flange, along y, at the top.")
            .unit("length").above(0).required().also("b bf w")
        .key("web", &T::web, "Thickness of the web.")
            .unit("length").above(0).required().also("tw s t_w stem")
        .key("flange", &T::flange, "Thickness of the flange.")
            .unit("length").above(0).required().also("tf t t_f")
        .key("fillet", &T::fillet, inner_corners)
            .unit("length").at_least(0).also("r radius root_radius");
    // clang-format on
    return table;
}

const TableSpec& box_table() {
    using T = BoxTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.box", "")
        .key("height", &T::height, "Height over all, along z.")
            .unit("length").above(0).required().also("h d depth")
        .key("width", &T::width, "Width over all, along y.")
            .unit("length").above(0).required().also("b w")
        .key("wall", &T::wall, "Thickness of the walls.")
            .unit("length").above(0).required().also("t thickness wall_thickness web tw")
        .key("flange", &T::flange, "Thickness of the lower and upper wall.")
            .unit("length").above(0).otherwise("`wall`").also("tf t_f")
        .key("outer_radius", &T::outer_radius, "Radius of the outer corners.")
            .unit("length").at_least(0).also("r ro r_outer radius")
        .key("inner_radius", &T::inner_radius, "Radius of the inner corners.")
            .unit("length").at_least(0).otherwise("outer_radius less the thicker wall, 0 at least").also("ri r_inner");
    // clang-format on
    return table;
}

const TableSpec& zed_table() {
    using T = ZedTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.zed", "")
        .key("height", &T::height, "Height over all, along z.")
            .unit("length").above(0).required().also("h d depth")
        .key("width", &T::width, "Width of each flange, along y, with the web: the upper one goes to +y.")
            .unit("length").above(0).required().also("b w")
        .key("wall", &T::wall, "Thickness.")
            .unit("length").above(0).required().also("t thickness web")
        .key("radius", &T::radius, bends)
            .unit("length").at_least(0).otherwise("sharp corners").also("r ri inner_radius");
    // clang-format on
    return table;
}

const TableSpec& hat_table() {
    using T = HatTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.hat", "")
        .key("height", &T::height, "Height over all, along z, from the feet.")
            .unit("length").above(0).required().also("h d depth")
        .key("width", &T::width, "Width of the top, along y.")
            .unit("length").above(0).required().also("b w")
        .key("foot", &T::foot, "Width of each foot beyond the web.")
            .unit("length").above(0).required().also("lip flange brim")
        .key("wall", &T::wall, "Thickness.")
            .unit("length").above(0).required().also("t thickness web")
        .key("radius", &T::radius, bends)
            .unit("length").at_least(0).otherwise("sharp corners").also("r ri inner_radius");
    // clang-format on
    return table;
}

const TableSpec& polygon_table() {
    using T = PolygonTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.polygon", "")
        .key("outer", &T::outer, "Corners [y, z] in order, either way round; a third number rounds the corner.")
            .unit("length").required().also("points corners vertices nodes outline")
        .key("holes", &T::holes, "Corners of each hole, likewise.")
            .unit("length").otherwise("none").also("hole inner interior voids");
    // clang-format on
    return table;
}

}  // namespace

void add_outlined_shapes(Table<ShapeTable>& table) {
    using T = ShapeTable;
    // clang-format off
    table.key("profile", &T::profile, "The name of a standard profile, such as \"IPE 200\": IPE, HEA, HEB, HEM, HD, HP, UPN, UPE, "
             "L, CHS, SHS and RHS (\"SHS 100x5 hot\" or \"cold\"), W and HSS.")
            .also("standard name catalogue ipe hea heb upn")
        .key("I", &T::I, i_table(), "An I or H.")
            .also("i h i_beam i_section ibeam wide_flange")
        .key("channel", &T::channel, channel_table(), "A channel, open towards +y.")
            .also("u c channel_section")
        .key("angle", &T::angle, angle_table(), "An angle, its outer corner below, on the side of −y.")
            .also("l l_section")
        .key("tee", &T::tee, tee_table(), "A T, flange above.")
            .also("t t_section")
        .key("box", &T::box, box_table(), "A rectangle with a rectangular hole.")
            .also("rhs shs hollow_rectangle rectangular_tube square_tube")
        .key("zed", &T::zed, zed_table(), "A Z of one thickness.")
            .also("z z_section")
        .key("hat", &T::hat, hat_table(), "A hat of one thickness, open below.")
            .also("omega hat_section top_hat")
        .key("polygon", &T::polygon, polygon_table(), "Any area with straight sides and rounded corners.")
            .also("outline points custom")
        .key("origin", &T::origin, "Where the rod is in a profile or polygon. \"given\": at the origin of its coordinates: "
             "the back of a channel's web, the outer corner of an angle, the foot of a tee and a hat, the middle of others.")
            .otherwise("`\"centroid\"`; of a polygon `\"given\"`").also("reference axis")
        .key("millimetre", &T::millimetre, "How long a millimetre is in the deck, for a profile: 1e-3 if lengths are in m.")
            .unit("length").above(0).only_with("profile")
            .otherwise("by the m, mm, cm, in or ft in units").also("mm millimeter");
    // clang-format on
}

}  // namespace gxrod
