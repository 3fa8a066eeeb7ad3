#pragma once

#include <array>
#include <optional>
#include <string>

#include "deck/schema/choices.hpp"
#include "deck/table/corner_kinds.hpp"
#include "deck/table/kinds.hpp"
#include "deck/table/table_head.hpp"

// The tables of shapes that are meshed: profiles and polygons.
namespace gxrod {

struct ITable : TableHead {
    ArcNumber height, width, web, flange;
    ArcNumber fillet = 0.0;
};

struct ChannelTable : TableHead {
    ArcNumber height, width, web, flange;
    ArcNumber fillet = 0.0, toe = 0.0, slope = 0.0;
};

struct AngleTable : TableHead {
    ArcNumber height, width, wall;
    ArcNumber fillet = 0.0, toe = 0.0;
};

struct TeeTable : TableHead {
    ArcNumber height, width, web, flange;
    ArcNumber fillet = 0.0;
};

struct BoxTable : TableHead {
    ArcNumber height, width, wall;
    std::optional<ArcNumber> flange, inner_radius;
    ArcNumber outer_radius = 0.0;
};

struct ZedTable : TableHead {
    ArcNumber height, width, wall;
    std::optional<ArcNumber> radius;
};

struct HatTable : TableHead {
    ArcNumber height, width, foot, wall;
    std::optional<ArcNumber> radius;
};

struct PolygonTable : TableHead {
    CornerRows outer;
    std::optional<CornerRowLists> holes;
};

// The point of a shape that lies on the rod.
enum class ShapeOrigin { centroid, shear_centre, given };
inline constexpr std::array<Choice<ShapeOrigin>, 3> shape_origin_choices{
    {{"centroid", ShapeOrigin::centroid},
     {"shear centre", ShapeOrigin::shear_centre},
     {"given", ShapeOrigin::given}}};
inline constexpr const auto& choices_of(ShapeOrigin) { return shape_origin_choices; }

// The keys of `shape` for shapes that are meshed; at most one of them is given.
struct OutlinedShapes : TableHead {
    std::optional<std::string> profile;
    std::optional<ITable> I;
    std::optional<ChannelTable> channel;
    std::optional<AngleTable> angle;
    std::optional<TeeTable> tee;
    std::optional<BoxTable> box;
    std::optional<ZedTable> zed;
    std::optional<HatTable> hat;
    std::optional<PolygonTable> polygon;
    std::optional<ShapeOrigin> origin;
    std::optional<double> millimetre;
};

}  // namespace gxrod
