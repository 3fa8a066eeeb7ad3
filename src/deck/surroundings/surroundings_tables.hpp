#pragma once

#include "deck/loads/acting.hpp"
#include "deck/surroundings/flow_rows.hpp"

// The tables [fluid], [air], [[wave]] and [seabed].
namespace gxrod {

// A current or a wind.
struct FlowTable : ActingTable {
    std::optional<FlowRows> table;
    std::optional<Vec3> direction;
    std::optional<FieldVector> velocity;
};

struct FluidTable : ActingTable {
    double density = 0.0;
    std::optional<double> surface, depth;
    std::optional<FlowTable> current;
    Stretching stretching = Water{}.stretching;
    std::optional<bool> current_stretching;
    double ramp = 0.0;
};

struct AirTable : TableHead {
    double density = 0.0;
    std::optional<FlowTable> wind;
};

struct AiryTable : TableHead {
    double height = 0.0;
    double period = 0.0;
    double phase = 0.0;
};

struct JonswapTable : TableHead {
    double significant_height = 0.0;
    double peak_period = 0.0;
    double gamma = 3.3;
    long components = 200;
    long seed = 1;
    std::optional<double> spreading;
};

struct ElevationTable : TableHead {
    std::string file;
    Vec3 at = Vec3::Zero();
    std::optional<double> shortest_period, longest_period;
};

struct WaveTable : ActingTable {
    std::optional<AiryTable> airy;
    std::optional<JonswapTable> jonswap;
    std::optional<ElevationTable> elevation;
    Vec3 direction = Vec3::UnitX();
};

struct BedPlaneTable : TableHead {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
};

struct BedGridTable : TableHead {
    std::string file;
};

struct BedFrictionTable : ActingTable {
    double axial = 0.0;
    double lateral = 0.0;
    std::optional<double> stiffness;
};

struct SeabedTable : ActingTable {
    std::optional<double> z;
    std::optional<BedPlaneTable> plane;
    std::optional<BedGridTable> grid;
    double stiffness = 0.0;
    double damping = 0.0;
    std::optional<std::variant<double, BedFrictionTable>> friction;
};

}  // namespace gxrod
