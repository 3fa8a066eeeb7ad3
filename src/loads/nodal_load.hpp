#pragma once

#include "model/model.hpp"
#include "state/motion.hpp"

// Forces and moments on nodes, dead or turning with them.
namespace gxrod {

// Computes force and moment at `time`, stacked, in the axes of the load. Throws EvaluationError.
Vec6 evaluate_load(const NodalLoad& load, double time);

// Computes force and moment of the load on its node at `time`: spatial, stacked. `at_time` is the result of
// evaluate_load.
Vec6 compute_load(const NodalLoad& load, const Vec6& at_time, const NodeMotion& motion, double time);
Vec6 compute_load(const NodalLoad& load, const NodeMotion& motion, double time);

// Computes the derivative by (δr, δφ), as the load turns with the node; zero for a dead load. `value` is the
// result of compute_load.
Mat6 compute_load_tangent(const NodalLoad& load, const Vec6& value, const NodeLinearization& linearization);
// Computes the derivative by (δr, δφ) of what of the load depends on the motion, for a load that has that.
// `length` is the model's length, which sets the size of differences.
Mat6 compute_motion_tangent(const NodalLoad& load,
                            const NodeMotion& motion,
                            const NodeLinearization& linearization,
                            double time,
                            double length);

}  // namespace gxrod
