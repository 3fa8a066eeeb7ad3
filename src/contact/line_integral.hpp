#pragma once

namespace gxrod {

// The integral of Φ(u) = (1 − u/w)³ (w/u)² over a straight line that passes a point: u = G + z², z along the
// line from the foot of the point. It is ∫Φ dz from z0 to z1, over the part where u < w, with its derivatives
// by G, z0 and z1.
struct LineIntegral {
    double value = 0.0;
    double by_G = 0.0, by_low = 0.0, by_high = 0.0;
    double by_GG = 0.0, by_G_low = 0.0, by_G_high = 0.0, by_low_low = 0.0, by_high_high = 0.0;
};

// Computes the integral. G > −(z0² or z1²) if both are on one side of the foot, else G > 0.
LineIntegral integrate_line(double w, double G, double z0, double z1);

}  // namespace gxrod
