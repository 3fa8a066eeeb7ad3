#pragma once

#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

// The pull of a tendon at a force point of a rod; vectors are material, in the section's axes.
struct TendonPull {
    double tension = 0.0;
    Vec3 at = Vec3::Zero();     // d, the place where it passes through the section: x is zero
    Vec3 slope = Vec3::Zero();  // d′, by the arc length of the reference
};

// Actions within a section at a force point, at the time of an equilibrium.
struct PointDrive {
    Vec6 strain = Vec6::Zero();  // (Γ, K) that the section would take unloaded, added to the reference strain
    std::vector<TendonPull> pulls;  // pulls of the tendons that pass there
};

// Quantities for the work of the actions within a section, at a force point and a time.
struct DrivenPoint {
    struct Pull {
        double tension, stretch;  // stretch: length of the tendon per length of the rod
    };
    double weight = 0.0;             // in arc length
    Vec6 resultants = Vec6::Zero();  // without the tendons
    Vec6 strain = Vec6::Zero();      // PointDrive::strain
    std::vector<Pull> pulls;
};

}  // namespace gxrod
