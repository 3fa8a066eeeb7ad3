#pragma once

#include <optional>
#include <vector>

#include "deck/places/build_context.hpp"
#include "deck/table/table.hpp"
#include "geometry/centreline.hpp"

// Curves that a rod, its rest shape or a tube can have.
namespace gxrod {

struct LineTable : TableHead {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
};

// Through a point, or about a centre.
struct ArcTable : TableHead {
    Vec3 from = Vec3::Zero();
    std::optional<Vec3> through;
    Vec3 to = Vec3::Zero();
    std::optional<Vec3> centre;
    Vec3 axis = Vec3::Zero();
    double angle = 0.0;
};

struct HelixTable : TableHead {
    Vec3 centre = Vec3::Zero();
    Vec3 axis = Vec3::Zero();
    Vec3 from = Vec3::Zero();
    double turns = 0.0;
    double pitch = 0.0;
};

struct CatenaryTable : TableHead {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
    double length = 0.0;
    bool bed = false;
};

// The base of tables that have one of these curves.
struct CurveTable : TableHead {
    std::optional<LineTable> line;
    std::optional<ArcTable> arc;
    std::optional<HelixTable> helix;
    std::optional<std::vector<CheckedVector>> polyline, spline;
    std::optional<CatenaryTable> catenary;
};

// The keys of CurveTable, of which tables take over those that they have.
const Table<CurveTable>& curve_keys();

// Finds the centreline of a table's curve. If that is wrong, adds a fault and returns nullopt. A catenary
// that lies on the ground does so by the section that a rod has everywhere, if it has one.
std::optional<Centreline> find_centreline(const CurveTable& curve,
                                          const BuildContext& context,
                                          const std::optional<TableName>& section = {});

}  // namespace gxrod
