#include <limits>

#include "model/sections/rods_in_fluid.hpp"
#include "watch/quantity_tables.hpp"

namespace gxrod {
namespace {

// Why water and air do not act on the thing itself, or "".
std::string lacks_own_fluid(const Watched& target, const Model& model) {
    if (const auto* body = std::get_if<WatchedBody>(&target))
        return model.bodies[static_cast<std::size_t>(body->index)].fluid ? "" : "this body has no `fluid`";
    const auto rod = static_cast<std::size_t>(std::get<WatchedPoint>(target).place.rod);
    const Section& section = model.sections[static_cast<std::size_t>(model.rods[rod].section)];
    return section.fluid ? "" : "the section of this rod has no `fluid`";
}

std::string lacks_water(const Watched& target, const Model& model) {
    return model.surroundings.water ? lacks_own_fluid(target, model) : "the deck has no [fluid]";
}

std::string lacks_fluid(const Watched& target, const Model& model) {
    const bool is_there = model.surroundings.water || model.surroundings.air;
    return is_there ? lacks_own_fluid(target, model) : "the deck has no [fluid] and no [air]";
}

std::string lacks_ground(const Watched& target, const Model& model) {
    return model.surroundings.seabed ? lacks_own_fluid(target, model) : "the deck has no [seabed]";
}

std::string lacks_bed(const Watched& target, const Model& model) {
    if (!model.surroundings.seabed) return "the deck has no [seabed]";
    const int rod = std::get<WatchedContacts>(target).contact.rod;
    const bool has_fluid = fluid_section_at(model, model.rods[static_cast<std::size_t>(rod)], 0) != nullptr;
    return has_fluid ? "" : "the section of this rod has no `fluid`";
}

constexpr double no_touch = std::numeric_limits<double>::quiet_NaN();

double arc_length_of(const Sight& see, TouchDown GroundedPart::*end) {
    const std::optional<GroundedPart> part = see.grounded_part();
    return part ? (*part.*end).arc_length : no_touch;
}

Vec3 position_of(const Sight& see, TouchDown GroundedPart::*end) {
    const std::optional<GroundedPart> part = see.grounded_part();
    return part ? (*part.*end).position : Vec3::Constant(no_touch);
}

// clang-format off
constexpr Quantity lines_of_lying_rods[]{
    Quantity("touch_down_start", "arc length at which the rod first touches the ground, from its start; NaN if it does not",
             "length", Axes::none, [](const Sight& see) { return arc_length_of(see, &GroundedPart::start); })
        .sized(Size::place).unless(lacks_bed),
    Quantity("touch_down_end", "arc length at which the rod last touches the ground, from its start; NaN if it does not",
             "length", Axes::none, [](const Sight& see) { return arc_length_of(see, &GroundedPart::end); })
        .sized(Size::place).unless(lacks_bed),
    Quantity("touch_down_start_position", "place where the rod first touches the ground", "length", Axes::global,
             [](const Sight& see) { return position_of(see, &GroundedPart::start); })
        .sized(Size::place).unless(lacks_bed),
    Quantity("touch_down_end_position", "place where the rod last touches the ground", "length", Axes::global,
             [](const Sight& see) { return position_of(see, &GroundedPart::end); })
        .sized(Size::place).unless(lacks_bed)};

constexpr Quantity lines_of_rods_around[]{
    Quantity("effective_tension", "effective tension, the axial section force", "force", Axes::none,
             [](const Sight& see) { return see.section().force.x(); }).with_strain_order(),
    Quantity("wall_tension", "tension in the wall: less pressures, p_o A_o − p_i A_i", "force", Axes::none,
             [](const Sight& see) { return see.section().force.x() + see.around().pressure_force; })
        .unless(lacks_water).with_strain_order(),
    Quantity("water_velocity", "velocity of the water there", "length/time", Axes::global,
             [](const Sight& see) { return see.around().water_velocity; }).unless(lacks_water),
    Quantity("wet_fraction", "fraction of the piece there that is under water", "1", Axes::none,
             [](const Sight& see) { return see.around().wet_fraction; }).unless(lacks_water),
    Quantity("fluid_force", "force of water and air", "force/length", Axes::global,
             [](const Sight& see) { return see.around().fluid_force; }).unless(lacks_fluid),
    Quantity("bed_force", "force of the ground", "force/length", Axes::global,
             [](const Sight& see) { return see.around().bed_force; }).unless(lacks_ground)};

constexpr Quantity lines_of_bodies_around[]{
    Quantity("wet_fraction", "fraction of the piece there that is under water", "1", Axes::none,
             [](const Sight& see) { return see.around().wet_fraction; }).unless(lacks_water),
    Quantity("fluid_force", "force of water and air", "force", Axes::global,
             [](const Sight& see) { return see.around().fluid_force; }).sized(Size::line_force).unless(lacks_fluid)};
// clang-format on

}  // namespace

constinit const QuantityTable quantities_of_rods_around{
    lines_of_rods_around, SnapshotPart::section, "points"};
constinit const QuantityTable quantities_of_lying_rods{
    lines_of_lying_rods, SnapshotPart::motion, "rods as a whole"};
constinit const QuantityTable quantities_of_bodies_around{
    lines_of_bodies_around, SnapshotPart::motion, "points"};

}  // namespace gxrod
