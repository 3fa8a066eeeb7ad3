#pragma once

#include "model/surroundings.hpp"

// SpeedProfile::speeds has one, two or three numbers for each height:
//   1  the speed along the profile's direction
//   2  the speed, and by what the direction is turned about z there, in radians
//   3  the components of the velocity
namespace gxrod {

// Returns how many numbers a profile has for each height.
inline std::size_t width_of(const SpeedProfile& profile) {
    return profile.speeds.size() / profile.heights.size();
}

// Returns the velocity at a height of the list.
Vec3 velocity_at_row(const SpeedProfile& profile, std::size_t row);

// A velocity and how it changes with the height.
struct ProfileAt {
    Vec3 velocity, slope;
};

// Interpolates a profile whose direction changes: speeds and turns, or components, linearly.
ProfileAt interpolate_turning(const SpeedProfile& profile, double height);

}  // namespace gxrod
