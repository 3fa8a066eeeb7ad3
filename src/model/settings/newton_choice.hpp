#pragma once

#include <optional>

#include "model/sections/stiffness_ratio.hpp"
#include "model/settings/settings.hpp"

// Choices for settings of Newton's method that a deck leaves open.
namespace gxrod {

// Returns the settings; for a kind that solves no equilibria, the defaults.
const NewtonSettings& newton_of(const AnalysisSettings& analysis);

// From this ratio of stiffnesses on, motions use the mixed tangent: there it is as fast as the consistent
// one, or faster, and cuts fewer steps (docs/theory/rods.md).
inline constexpr double mixed_from_ratio = 300.0;

// The chosen tangent, and the ratio that is the reason, if there is one. Without inertia and below that ratio
// it is `automatic`: the consistent one, and the mixed one if that fails, since nothing limits increments if
// a rod bends far more easily than it stretches.
struct TangentChoice {
    TangentKind tangent = TangentKind::consistent;
    std::optional<StiffnessRatio> reason = {};
};
TangentChoice choose_tangent(const Model& model, const AnalysisSettings& analysis);

// Newton's tolerance over the allowed error of a step. With equal tolerances the remaining error of Newton's
// method was the larger one for the heavy top; at a tenth it disappears in the scheme's error
// (docs/guide/solving.md).
inline constexpr double newton_part = 0.01;
inline constexpr double tolerable_newton_part = 0.3;

// The round-off of forces, relative to the largest, is hardly ever smaller.
inline constexpr double least_newton_tolerance = 1e-14;

// Derives the tolerance that keeps the remaining error of Newton's method small compared with the errors of
// the steps.
double derive_newton_tolerance(const AnalysisSettings& analysis);

// Returns the given tolerance, or the derived one.
double choose_newton_tolerance(const AnalysisSettings& analysis);

// Returns the settings with tangent and tolerance chosen.
NewtonSettings choose_newton(const Model& model, const AnalysisSettings& analysis);

}  // namespace gxrod
