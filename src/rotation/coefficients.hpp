#pragma once

// Every scalar coefficient of finite rotations, each with its own switch between series and closed form.
//
// Φ ≥ 0 is the rotation angle in radians, of any size. The operator D = (1/Φ) d/dΦ appears because the
// gradient of a function of the angle is ∇f(|φ|) = (D f) φ; a suffix 1 or 2 counts how often D was applied.
// Over [0, π] each value has a relative error below 1e-15.
namespace gxrod::coefficients {

// a = sinΦ/Φ, b = (Φ − sinΦ)/Φ³, c = (1 − cosΦ)/Φ²: Rubin (2007), (3.6a).
double a(double angle);
double b(double angle);
double c(double angle);

// First derivatives: D a = b − c, D b = (c − 3b)/Φ², D c = (a − 2c)/Φ²; (3.6b) has ȧ = a1 (φ·φ̇) and so on.
double a1(double angle);
double b1(double angle);
double c1(double angle);

// Second derivatives D² a, D² b, D² c.
double a2(double angle);
double b2(double angle);
double c2(double angle);

// d = (1 − (Φ/2) cot(Φ/2))/Φ² in the inverse tangent map (3.7a), and d1 = D d. Both are singular at Φ = 2π.
double d(double angle);
double d1(double angle);

// Angles from which coefficients use their closed forms; below, their series. `a` and `c` have no switch.
struct Switches {
    double b = 2.0;
    double a1 = 2.25, b1 = 3.5, c1 = 3.25;
    double a2 = 3.25, b2 = 5.0, c2 = 4.0;
    double d = 2.75, d1 = 4.5;
};
inline constexpr Switches switches;

}  // namespace gxrod::coefficients
