#pragma once

#include <array>
#include <string>
#include <vector>

#include "run/stepped_run.hpp"
#include "watch/members.hpp"

// Resultants at stations of the members of a frame.
namespace gxrod {

// The stations of a member: its ends, its quarter points, and where the bending moment is largest.
inline constexpr std::array station_words{"start", "1/4", "1/2", "3/4", "end", "max |M|"};
inline constexpr std::size_t fixed_stations = station_words.size() - 1;

struct StationForces {
    std::string station;
    double s = 0.0;                // arc length from the member's start
    Vec3 position = Vec3::Zero();  // at t = 0
    Vec6 forces = Vec6::Zero();    // N, Vy, Vz, T, My, Mz, in section axes
};

// Computes the resultants at the stations of a member at the last accepted state of a run. The place of the
// largest moment is that of the parabolas through My and Mz at the ends and in the middle of each element.
std::vector<StationForces> find_station_forces(const Member& member, const SteppedRun& run);

}  // namespace gxrod
