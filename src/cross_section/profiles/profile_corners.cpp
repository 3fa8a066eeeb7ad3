#include "cross_section/profiles/profile_corners.hpp"

#include <algorithm>

namespace gxrod {
namespace {

// Adds the mirror image of what is there by y → −y, walked back.
CornerChain mirror(CornerChain right) {
    for (std::size_t i = right.size(); i-- > 0;) {
        const OutlineCorner corner = right[i];
        right.push_back({{-corner.at.x(), corner.at.y()}, corner.radius});
    }
    return right;
}

CornerChain make_rectangle(double width, double height, double radius) {
    const double y = 0.5 * width, z = 0.5 * height;
    return {{{-y, -z}, radius}, {{y, -z}, radius}, {{y, z}, radius}, {{-y, z}, radius}};
}

double inner_radius_of(const std::optional<double>& radius) { return radius.value_or(0.0); }

double outer_radius_of(const std::optional<double>& radius, double wall) {
    return radius ? *radius + wall : 0.0;
}

}  // namespace

Polygon list_corners(const IShape& shape) {
    const auto& [height, width, web, flange, fillet] = shape;
    const double z = 0.5 * height, y = 0.5 * width;
    return {mirror({{{y, -z}},
                    {{y, -z + flange}},
                    {{0.5 * web, -z + flange}, fillet},
                    {{0.5 * web, z - flange}, fillet},
                    {{y, z - flange}},
                    {{y, z}}})};
}

double find_flange_thickness(const ChannelShape& shape, double y) {
    const double from_toe = shape.flange_at.value_or(0.5 * shape.width);
    return shape.flange + shape.slope * (shape.width - from_toe - y);
}

Polygon list_corners(const ChannelShape& shape) {
    const double z = 0.5 * shape.height, y = shape.width;
    const double tip = find_flange_thickness(shape, y), root = find_flange_thickness(shape, shape.web);
    return {{{{0.0, -z}},
             {{y, -z}},
             {{y, -z + tip}, shape.toe},
             {{shape.web, -z + root}, shape.fillet},
             {{shape.web, z - root}, shape.fillet},
             {{y, z - tip}, shape.toe},
             {{y, z}},
             {{0.0, z}}}};
}

Polygon list_corners(const AngleShape& shape) {
    const auto& [height, width, wall, fillet, toe] = shape;
    return {{{{0.0, 0.0}},
             {{width, 0.0}},
             {{width, wall}, toe},
             {{wall, wall}, fillet},
             {{wall, height}, toe},
             {{0.0, height}}}};
}

Polygon list_corners(const TeeShape& shape) {
    const auto& [height, width, web, flange, fillet] = shape;
    return {mirror({{{0.5 * web, 0.0}},
                    {{0.5 * web, height - flange}, fillet},
                    {{0.5 * width, height - flange}},
                    {{0.5 * width, height}}})};
}

Polygon list_corners(const BoxShape& shape) {
    const auto& [height, width, wall, flange, outer_radius, inner_radius] = shape;
    return {make_rectangle(width, height, outer_radius),
            {make_rectangle(width - 2.0 * wall, height - 2.0 * flange, inner_radius)}};
}

Polygon list_corners(const ZedShape& shape) {
    const double z = 0.5 * shape.height, y = 0.5 * shape.wall, end = shape.width - y;
    const double inner = inner_radius_of(shape.radius), outer = outer_radius_of(shape.radius, shape.wall);
    return {{{{-end, -z}},
             {{y, -z}, outer},
             {{y, z - shape.wall}, inner},
             {{end, z - shape.wall}},
             {{end, z}},
             {{-y, z}, outer},
             {{-y, -z + shape.wall}, inner},
             {{-end, -z + shape.wall}}}};
}

Polygon list_corners(const HatShape& shape) {
    const double y = 0.5 * shape.width, end = y + shape.foot, t = shape.wall;
    const double inner = inner_radius_of(shape.radius), outer = outer_radius_of(shape.radius, t);
    CornerChain right{{{y - t, shape.height - t}, inner},
                      {{y - t, 0.0}, outer},
                      {{end, 0.0}},
                      {{end, t}},
                      {{y, t}, inner},
                      {{y, shape.height}, outer}};
    return {mirror(std::move(right))};
}

}  // namespace gxrod
