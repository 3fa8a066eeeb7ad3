#include "results/histories/quantity.hpp"

#include <cassert>

namespace gxrod {
namespace {

constexpr RowShape quaternion_row{4, true};
constexpr const char* the_global_axes = "the global axes";

// Whose axes a rotation is measured from: "the global axes".
QuantityForm rotation_form(Quantity quantity, PointKind kind, const std::string& from) {
    const bool is_body = kind == PointKind::body;
    const std::string rotation = is_body                   ? "body axes from " + from
                                 : from == the_global_axes ? "since the reference configuration"
                                                           : "since t = 0, as seen from " + from;
    switch (quantity) {
        case Quantity::rotation_vector:
            return {{"rotation_vector", "rotation vector, at most pi long: " + rotation, "spatial", "angle"},
                    vector_row};
        case Quantity::quaternion:
            return {{"quaternion", "unit quaternion w x y z: " + rotation, "spatial", "1"}, quaternion_row};
        default:
            return {{"orientation",
                     "unit quaternion w x y z: " + std::string(is_body ? "body" : "section") + " axes from " +
                         from,
                     "spatial",
                     "1"},
                    quaternion_row};
    }
}

bool is_rotation(Quantity quantity) {
    return quantity == Quantity::rotation_vector || quantity == Quantity::quaternion ||
           quantity == Quantity::orientation;
}

// Of a bushing.
QuantityForm bushing_form(Quantity quantity) {
    switch (quantity) {
        case Quantity::displacement:
            return {{"displacement", "displacement of B against A", "bushing", "length"}, vector_row};
        case Quantity::rotation_vector:
            return {{"rotation_vector", "rotation vector of B against A", "bushing", "angle"}, vector_row};
        case Quantity::force:
            return {{"force", "force of the bushing", "bushing", "force"}, vector_row};
        case Quantity::moment:
            return {{"moment", "moment of the bushing", "bushing", "force·length"}, vector_row};
        case Quantity::force_spatial:
            return {{"force_spatial", "force of the bushing", "spatial", "force"}, vector_row};
        default:
            return {{"moment_spatial", "moment of the bushing", "spatial", "force·length"}, vector_row};
    }
}

// Of a joint, whose forces are those that A exerts on B.
QuantityForm joint_form(Quantity quantity) {
    constexpr const char* a_axes = "joint axes of A";
    switch (quantity) {
        case Quantity::angle:
            return {{"angle", "turn of B against A since t = 0, any number of turns", "none", "angle"},
                    scalar_row};
        case Quantity::angle_rate:
            return {{"angle_rate", "rate of the angle", "none", "angle/time"}, scalar_row};
        case Quantity::slide:
            return {{"slide", "slide of B along the axis since t = 0", "none", "length"}, scalar_row};
        case Quantity::slide_rate:
            return {{"slide_rate", "rate of the slide", "none", "length/time"}, scalar_row};
        case Quantity::force:
            return {{"force", "force that A exerts on B", "spatial", "force"}, vector_row};
        case Quantity::moment:
            return {{"moment", "moment that A exerts on B, about the joint", "spatial", "force·length"},
                    vector_row};
        case Quantity::force_a:
            return {{"force_a", "force that A exerts on B (along the axis, across it)", a_axes, "force"},
                    vector_row};
        case Quantity::moment_a:
            return {
                {"moment_a", "moment that A exerts on B (about the axis, across it)", a_axes, "force·length"},
                vector_row};
        case Quantity::drive:
            return {{"drive", "moment that drives a turn, force that drives a slide", "none", "force·length"},
                    scalar_row};
        case Quantity::friction:
            return {{"friction",
                     "moment of the friction of a turn, force of that of a slide",
                     "none",
                     "force·length"},
                    scalar_row};
        default:
            assert(quantity == Quantity::gap);
            return {{"gap", "how far the joint's equations are from being satisfied", "none", "length"},
                    scalar_row};
    }
}

QuantityForm tendon_form(Quantity quantity) {
    if (quantity == Quantity::tendon_length)
        return {{"tendon_length", "length of the tendon's part within the rod", "none", "length"},
                scalar_row};
    if (quantity == Quantity::tendon_end_tension)
        return {{"tendon_end_tension", "tension of the tendon where it is anchored", "none", "force"},
                scalar_row};
    assert(quantity == Quantity::tendon_tension);
    return {{"tendon_tension",
             "tension of the tendon where it is pulled; without friction the same all along",
             "none",
             "force"},
            scalar_row};
}

QuantityForm obstacle_form(Quantity quantity) {
    if (quantity == Quantity::least_gap)
        return {{"least_gap",
                 "least distance of the surface of a rod or body from that of the obstacle",
                 "none",
                 "length"},
                scalar_row};
    if (quantity == Quantity::contact_force)
        return {{"contact_force", "force that rods and bodies exert on the obstacle", "spatial", "force"},
                vector_row};
    assert(quantity == Quantity::contact_friction);
    return {{"contact_friction", "the part of contact_force along the surface", "spatial", "force"},
            vector_row};
}

// Of a rod or body and what it touches.
QuantityForm contact_form(Quantity quantity, const std::string& part) {
    if (quantity == Quantity::least_gap)
        return {{"least_gap",
                 "least distance of the surface of the " + part +
                     " from what it can touch; infinite without that",
                 "none",
                 "length"},
                scalar_row};
    if (quantity == Quantity::contact_force)
        return {{"contact_force", "force on the " + part + " of what touches it", "spatial", "force"},
                vector_row};
    assert(quantity == Quantity::contact_friction);
    return {{"contact_friction", "the part of contact_force along the surfaces", "spatial", "force"},
            vector_row};
}

// Of a gear.
QuantityForm gear_form(Quantity quantity) {
    if (quantity == Quantity::gap) {
        return {{"gap", "how far the gear's equation is from being satisfied", "none", "length"}, scalar_row};
    }
    assert(quantity == Quantity::drive);
    return {
        {"drive",
         "moment, or force, of the gear on B of its second joint along that one's coordinate; on the first "
         "one ratio times it",
         "none",
         "force·length"},
        scalar_row};
}

// Of water, air and ground; what is per length on a rod is a sum on a body.
QuantityForm surroundings_form(Quantity quantity, PointKind kind) {
    const char* dimension = kind == PointKind::body ? "force" : "force/length";
    switch (quantity) {
        case Quantity::effective_tension:
            return {{"effective_tension", "effective tension, the axial section force", "none", "force"},
                    scalar_row};
        case Quantity::wall_tension:
            return {
                {"wall_tension", "tension in the wall: less pressures, p_o A_o − p_i A_i", "none", "force"},
                scalar_row};
        case Quantity::water_velocity:
            return {{"water_velocity", "velocity of the water there", "spatial", "length/time"}, vector_row};
        case Quantity::wet_fraction:
            return {{"wet_fraction", "fraction of the piece there that is under water", "none", "1"},
                    scalar_row};
        case Quantity::fluid_force:
            return {{"fluid_force", "force of water and air", "spatial", dimension}, vector_row};
        default:
            assert(quantity == Quantity::bed_force);
            return {{"bed_force", "force of the ground", "spatial", dimension}, vector_row};
    }
}

}  // namespace

QuantityForm quantity_form(Quantity quantity, PointKind kind) {
    if (kind == PointKind::bushing) return bushing_form(quantity);
    if (kind == PointKind::joint) return joint_form(quantity);
    if (kind == PointKind::gear) return gear_form(quantity);
    if (kind == PointKind::rod_in_contact) return contact_form(quantity, "rod");
    const std::string component_order = " (axial, shear y, shear z)";
    const std::string couple_order = " (about x, y, z)";
    switch (quantity) {
        case Quantity::position:
            return {{"position", "position", "spatial", "length"}, vector_row};
        case Quantity::displacement:
            return {{"displacement", "displacement since t = 0", "spatial", "length"}, vector_row};
        case Quantity::rotation_vector:
        case Quantity::quaternion:
        case Quantity::orientation:
            return rotation_form(quantity, kind, the_global_axes);
        case Quantity::velocity:
            return {{"velocity", "velocity", "spatial", "length/time"}, vector_row};
        case Quantity::angular_velocity:
            return {{"angular_velocity", "angular velocity", "spatial", "angle/time"}, vector_row};
        case Quantity::angular_velocity_material:
            return {{"angular_velocity_material",
                     "angular velocity in the section or body axes",
                     "material",
                     "angle/time"},
                    vector_row};
        case Quantity::acceleration:
            return {{"acceleration", "acceleration of the node", "spatial", "length/time²"}, vector_row};
        case Quantity::centre_of_mass:
            return {{"centre_of_mass", "position of the centre of mass", "spatial", "length"}, vector_row};
        case Quantity::force:
            return {{"force", "section force" + component_order, "material", "force"}, vector_row};
        case Quantity::moment:
            return {{"moment", "section moment" + couple_order, "material", "force·length"}, vector_row};
        case Quantity::force_spatial:
            return {{"force_spatial", "section force", "spatial", "force"}, vector_row};
        case Quantity::moment_spatial:
            return {{"moment_spatial", "section moment", "spatial", "force·length"}, vector_row};
        case Quantity::strain:
            return {{"strain", "strain" + component_order, "material", "1"}, vector_row};
        case Quantity::curvature:
            return {{"curvature", "change of curvature" + couple_order, "material", "angle/length"},
                    vector_row};
        case Quantity::reaction_force:
            return {{"reaction_force", "force that the support exerts", "spatial", "force"}, vector_row};
        case Quantity::reaction_moment:
            return {{"reaction_moment", "moment that the support exerts", "spatial", "force·length"},
                    vector_row};
        case Quantity::elongation:
            return {{"elongation", "length less that at which the spring is free", "none", "length"},
                    scalar_row};
        case Quantity::tendon_length:
        case Quantity::tendon_tension:
        case Quantity::tendon_end_tension:
            return tendon_form(quantity);
        case Quantity::contact_force:
        case Quantity::contact_friction:
        case Quantity::least_gap:
            return kind == PointKind::body ? contact_form(quantity, "body") : obstacle_form(quantity);
        case Quantity::effective_tension:
        case Quantity::wall_tension:
        case Quantity::water_velocity:
        case Quantity::wet_fraction:
        case Quantity::fluid_force:
        case Quantity::bed_force:
            return surroundings_form(quantity, kind);
        case Quantity::axial_force:
            return {{"axial_force", "tension of spring and damper", "none", "force"}, scalar_row};
        default:
            return joint_form(quantity);
    }
}

QuantityForm relative_quantity_form(Quantity quantity, PointKind kind, const std::string& relative_to) {
    const std::string axes = "axes of " + relative_to;
    const bool turns = is_rotation(quantity);
    QuantityForm form = turns ? rotation_form(quantity, kind, "the " + axes) : quantity_form(quantity, kind);
    form.label.frame = axes;
    if (!turns) form.label.description += ", as seen from " + relative_to + " and its axes";
    return form;
}

}  // namespace gxrod
