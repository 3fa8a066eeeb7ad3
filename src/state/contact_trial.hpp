#pragma once

#include <vector>

namespace gxrod {

// What Newton's method knows of contact in addition to motions, reset for each equilibrium.
struct ContactTrial {
    // ζ of each place that can touch, on the curve of force and gap (contact/contact_law.hpp): with these the
    // tangent is that of forces as unknowns of their own. Empty: it follows from gaps.
    std::vector<double> parameters;
    // How far moved obstacles are on their way from the last accepted step, 0 … 1.
    double progress = 1.0;
};

}  // namespace gxrod
