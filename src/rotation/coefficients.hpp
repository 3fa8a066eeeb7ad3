#pragma once

// Every scalar coefficient of finite rotations, each with its own switch between series and closed form.
//
// Φ ≥ 0 is the rotation angle. The operator D = (1/Φ) d/dΦ appears because the gradient of a function of the
// angle is ∇f(|φ|) = (D f) φ; a suffix 1 or 2 counts how often D was applied.
namespace gxrod::coefficients {

// a = sinΦ/Φ, b = (Φ − sinΦ)/Φ³, c = (1 − cosΦ)/Φ²: those of Rubin (2007), (3.6a).
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

// d = (1 − (Φ/2) cot(Φ/2))/Φ², of the inverse tangent map (3.7a), and d1 = D d. Both are singular at Φ = 2π.
double d(double angle);
double d1(double angle);

}  // namespace gxrod::coefficients
