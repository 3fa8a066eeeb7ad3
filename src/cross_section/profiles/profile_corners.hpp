#pragma once

#include "cross_section/profiles/profile_shape.hpp"

namespace gxrod {

// The corners of a profile, walked anticlockwise.
Polygon list_corners(const IShape& shape);
Polygon list_corners(const ChannelShape& shape);
Polygon list_corners(const AngleShape& shape);
Polygon list_corners(const TeeShape& shape);
Polygon list_corners(const BoxShape& shape);
Polygon list_corners(const ZedShape& shape);
Polygon list_corners(const HatShape& shape);

// Returns how thick a flange is at a distance from the back of the web.
double find_flange_thickness(const ChannelShape& shape, double y);

}  // namespace gxrod
