#pragma once

#include <complex>

#include "state/records/mode_record.hpp"

// Results on small motions about a state with damping, follower loads or rotation.
namespace gxrod {

// A small motion x e^(λt) about a state, T(λ) x = 0 (docs/theory/vibrations.md, (V12) and (V21)), whose real
// part is the motion. A conjugate pair is represented by its member with Im λ ≥ 0.
struct Eigenmode {
    double growth = 0.0;         // Re λ, per time; negative if it decays
    double omega = 0.0;          // Im λ, rad per time
    double frequency = 0.0;      // cycles per time
    double damping_ratio = 0.0;  // −Re λ / |λ|
    double residual = 0.0;       // |S⁻¹ T(λ) x|, S near K, relative to x
    // The real part of x; its words and shares of strain energy count both parts. The largest component of x
    // is real and positive, and xᴴ M x = 1 if anything that moves has inertia.
    Shape shape;
    std::vector<Vec6> imaginary;  // imaginary part at each node
    // The left vector, real and imaginary part of yᵀ in yᵀ T(λ) = 0, with yᵀ T′(λ) x = 1
    // (or its length is 1 where this vanishes); only if asked for.
    std::vector<Vec6> left, left_imaginary;

    std::complex<double> lambda() const { return {growth, omega}; }
};

struct EigenvaluesRecord {
    std::string failure;           // why there are none, "" if they were found
    double time = 0.0;             // at which loads were taken
    std::vector<Eigenmode> modes;  // by rising Im λ, then by falling Re λ

    // All λ within `radius` of λ = shift have been sought; by the determinant `missing` more lie there,
    // conjugates included. −1: not counted.
    double shift = 0.0, radius = 0.0;
    std::int64_t missing = -1;
    bool is_complete = false;   // counted and all found
    bool is_all = false;        // the model has no others
    std::int64_t unstable = 0;  // modes that grow, beyond round-off
    std::int64_t steps = 0;     // steps of Arnoldi's method
};

}  // namespace gxrod
