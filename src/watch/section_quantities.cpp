#include "watch/quantity_tables.hpp"

namespace gxrod {
namespace {

// clang-format off
constexpr Quantity section_lines[]{
    Quantity("force", "section force (axial, shear y, shear z)", "force", Axes::material,
             [](const Sight& see) { return see.section().force; }).with_strain_order(),
    Quantity("moment", "section moment (about x, y, z)", "force·length", Axes::material,
             [](const Sight& see) { return see.section().moment; }).with_strain_order(),
    Quantity("force_spatial", "section force", "force", Axes::global,
             [](const Sight& see) { return Vec3(see.point().axes() * see.section().force); }).with_strain_order(),
    Quantity("moment_spatial", "section moment", "force·length", Axes::global,
             [](const Sight& see) { return Vec3(see.point().axes() * see.section().moment); }).with_strain_order(),
    Quantity("shear_force", "size of the shear force", "force", Axes::none,
             [](const Sight& see) { return see.section().force.tail<2>().norm(); }).with_strain_order(),
    Quantity("bending_moment", "size of the bending moment", "force·length", Axes::none,
             [](const Sight& see) { return see.section().moment.tail<2>().norm(); }).with_strain_order(),
    Quantity("strain", "strain (axial, shear y, shear z)", "1", Axes::material,
             [](const Sight& see) { return see.section().strain; }).sized(Size::strain).with_strain_order(),
    Quantity("curvature", "change of curvature (about x, y, z)", "angle/length", Axes::material,
             [](const Sight& see) { return see.section().curvature; }).with_strain_order()};
// clang-format on

}  // namespace

constinit const QuantityTable quantities_of_sections{section_lines, SnapshotPart::section, "points"};

}  // namespace gxrod
