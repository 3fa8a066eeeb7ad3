#pragma once

#include <optional>

#include "model/sections/stiffness_ratio.hpp"
#include "model/settings/settings.hpp"

// What becomes of settings of Newton's method that are left to gxrod.
namespace gxrod {

// The defaults of a kind that solves no equilibria.
const NewtonSettings& newton_of(const AnalysisSettings& analysis);

// From this ratio of stiffnesses on, motions take the mixed tangent: there it is as fast as the consistent
// one, or faster, and cuts fewer steps (docs/theory/rods.md).
inline constexpr double mixed_from_ratio = 300.0;

// The tangent that is taken, and the ratio that it is taken for, if one is. Without inertia and below that
// ratio it is `automatic`: the consistent one, and the mixed one where that fails, since nothing keeps
// increments small where a rod bends far more easily than it stretches.
struct TangentChoice {
    TangentKind tangent = TangentKind::consistent;
    std::optional<StiffnessRatio> reason = {};
};
TangentChoice choose_tangent(const Model& model, const AnalysisSettings& analysis);

// Newton's tolerance over the allowed error of a step. Where both are alike, what Newton's method leaves
// was seen to be the larger error of the heavy top; at a tenth it is lost in the scheme's
// (docs/guide/solving.md).
inline constexpr double newton_part = 0.01;
inline constexpr double tolerable_newton_part = 0.3;

// Round-off of the forces, relative to the largest, is hardly ever smaller.
inline constexpr double least_newton_tolerance = 1e-14;

// The tolerance that keeps what Newton's method leaves small compared with the errors of the steps.
double derive_newton_tolerance(const AnalysisSettings& analysis);

// The given one, or that.
double choose_newton_tolerance(const AnalysisSettings& analysis);

// With tangent and tolerance chosen.
NewtonSettings choose_newton(const Model& model, const AnalysisSettings& analysis);

}  // namespace gxrod
