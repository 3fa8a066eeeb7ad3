#pragma once

#include <variant>

#include "cross_section/outlines/outline.hpp"

// Profiles by their numbers, all lengths in one unit. y goes to the right and z up, seen against x. `fillet`
// rounds the inner corners between web and flange, `toe` the inner edges of the ends of flanges and legs.
namespace gxrod {

// Centre at (0, 0), web along z.
struct IShape {
    double height, width, web, flange;
    double fillet = 0.0;
};

// Back of the web at y = 0, flanges towards +y, middle at z = 0.
struct ChannelShape {
    double height, width, web;
    double flange;  // its thickness at `flange_at`
    double fillet = 0.0;
    double toe = 0.0;
    double slope = 0.0;  // of the inner faces: the flanges get thicker towards the web
    std::optional<double> flange_at = std::nullopt;  // from the toe; half of the width if not given
};

// Outer corner at (0, 0), legs along +y, `width` long, and +z, `height` long.
struct AngleShape {
    double height, width, wall;
    double fillet = 0.0;
    double toe = 0.0;
};

// Foot of the web at z = 0, flange above, middle at y = 0.
struct TeeShape {
    double height, width, web, flange;
    double fillet = 0.0;
};

// Centre at (0, 0). `wall` is the thickness of the walls along z, `flange` that of the walls along y.
struct BoxShape {
    double height, width, wall, flange;
    double outer_radius = 0.0;
    double inner_radius = 0.0;
};

// Centre at (0, 0), web along z; the upper flange goes to +y, the lower one to −y. `width` of a flange
// includes the web. With a `radius`, the inner one, bends have the outer radius `radius` + `wall`.
struct ZedShape {
    double height, width, wall;
    std::optional<double> radius = std::nullopt;
};

// Feet at z = 0, middle at y = 0. `width` is that of the top, `foot` that of each foot beyond the web.
struct HatShape {
    double height, width, foot, wall;
    std::optional<double> radius = std::nullopt;
};

// A hollow circle.
struct HollowCircle {
    double diameter, wall;
};

using ProfileShape =
    std::variant<IShape, ChannelShape, AngleShape, TeeShape, BoxShape, ZedShape, HatShape, HollowCircle>;

// Finds a number that does not go with the others; its part is the number's name. All must be positive,
// radii and slopes may be 0.
std::optional<OutlineFault> find_fault(const ProfileShape& shape);

// Draws a profile without a fault.
Outline draw_outline(const ProfileShape& shape);

}  // namespace gxrod
