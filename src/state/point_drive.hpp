#pragma once

#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

// A tendon at a force point of a rod: material, in the section's axes.
struct TendonPull {
    double tension = 0.0;
    Vec3 at = Vec3::Zero();     // d, where it passes through the section: x is zero
    Vec3 slope = Vec3::Zero();  // d′, by the arc length of the reference
};

// What acts within a section at a force point, at the time of an equilibrium.
struct PointDrive {
    Vec6 strain = Vec6::Zero();     // (Γ, K) that the section would take by itself, added to the reference's
    std::vector<TendonPull> pulls;  // of the tendons that pass there
};

// The work of what acts within a section, at a force point and a time.
struct DrivenPoint {
    struct Pull {
        double tension, stretch;  // of a tendon: its length per length of the rod
    };
    double weight = 0.0;             // in arc length
    Vec6 resultants = Vec6::Zero();  // without the pulls of tendons
    Vec6 strain = Vec6::Zero();      // PointDrive::strain
    std::vector<Pull> pulls;
};

}  // namespace gxrod
