#pragma once

#include "deck/rods/curve_table.hpp"
#include "deck/schema/choices.hpp"

// The tables of [obstacle.NAME].
namespace gxrod {

struct TubeObstacleTable : CurveTable {
    double radius = 0.0;
    ObstacleSide side = ObstacleSide::outside;
};

}  // namespace gxrod
