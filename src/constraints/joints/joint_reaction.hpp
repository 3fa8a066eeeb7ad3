#pragma once

#include "constraints/joints/joint_frames.hpp"

namespace gxrod {

// The forces of the multipliers of a joint's equations, Gᵀλ, summed over the equations, (J23): a force and
// its opposite, and moments u × w and their opposites. A carries u, B carries w.
struct JointReaction {
    Vec3 force = Vec3::Zero();    // f, on B at its point
    Vec3 carried = Vec3::Zero();  // f_A, the part of f that A carries
    double pull = 0.0;            // κ: f contains κ d
    Mat3 moments = Mat3::Zero();  // Σ λ u wᵀ
    Mat3 bends = Mat3::Zero();  // Σ λ (t kᵀ + k tᵀ) of turns, t and k the parts of ∇ψ and ∇lnρ on A
    Mat3 curving = Mat3::Zero();  // C = Σ λ k t tᵀ of cams: f contains C times the displacement of B on A

    // Computes forces, and moments about the nodes, on (A, B).
    PairVector compute_force(const JointFrames& frames) const;
    // Computes their derivative by (δr, δφ), unsymmetric since spins do not commute.
    PairMatrix compute_derivative(const JointFrames& frames) const;
};

}  // namespace gxrod
