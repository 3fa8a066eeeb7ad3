#pragma once

// The normal contact law of finite range: force λ and energy V of a gap g, for a unit weight. It acts below
// the skin ĝ and is infinite at g = 0, so no state of finite energy penetrates.
//
// Legend: x = g/ĝ; λ = κ (1 − x)²/x below x = 1, else 0; V = κ ĝ (−ln x − 2 (1 − x) + (1 − x²)/2), λ =
// −dV/dg. Graph form: the curve (g, λ) by one parameter ζ = λ/κ − g/ĝ, over which both are smooth and of
// slope ≤ 1; x = 1/(2 + ζ), λ/κ = (1 + ζ)²/(2 + ζ) above ζ = −1; x = −ζ, λ = 0 below. D = −dλ/dg on the
// curve.
namespace gxrod {

struct ContactLaw {
    double skin = 1.0;       // ĝ, a length
    double stiffness = 1.0;  // κ, a force; λ is κ/2 at g = ĝ/2
};

// These functions need a gap > 0.
double compute_contact_force(const ContactLaw& law, double gap);
double compute_contact_force_slope(const ContactLaw& law, double gap);  // dλ/dg ≤ 0
double compute_contact_energy(const ContactLaw& law, double gap);

struct ContactGraphPoint {
    double gap;        // ĝ x(ζ)
    double force;      // λ(ζ)
    double stiffness;  // D = (κ/ĝ)(1 + ζ)(3 + ζ), 0 below ζ = −1
};

// Finds the point of the curve with the parameter ζ.
ContactGraphPoint find_contact_point(const ContactLaw& law, double zeta);

// A value of ζ without force.
inline constexpr double no_contact = -1.0;

// Returns force and stiffness at a gap by linear continuation from the point ζ: with the stiffness there, so
// that the force may pull.
ContactGraphPoint continue_contact(const ContactLaw& law, double zeta, double gap);
// Returns the point that such a linear solution leads to if it changes the gap by this much; no_contact
// without a force.
double advance_contact(const ContactLaw& law, double zeta, double gap, double change);

// Returns the share of a gap that motions keep. A prediction stops at half the skin; within the skin it
// closes no more than a tenth, so that contacts start with about the force they had.
double find_predicted_share(double skin, double gap);
// Returns the share of a gap that an increment keeps within the skin. It may multiply the force of a pair of
// rods, about (1 − x)³/x², by ten: larger forces would throw them aside before iterations find the right one.
double find_kept_share(double skin, double gap);

// Returns the part of a motion that keeps some of a gap; 0 if the gap is so small that rounding of positions
// would close it after further parts.
inline double keep_from_rounding(double part, double skin, double gap) {
    constexpr double least = 1e-6;
    return part < 1.0 && gap < least * skin ? 0.0 : part;
}

}  // namespace gxrod
