#pragma once

#include "model/model.hpp"
#include "state/motion.hpp"

// Forces and moments on nodes, dead or turning with them.
namespace gxrod {

// Force and moment at `time`, stacked, in the axes that the load is given in. Throws EvaluationError.
Vec6 evaluate_load(const NodalLoad& load, double time);

// Force and moment that the load exerts on its node at `time`: spatial, stacked. `at_time` is what
// evaluate_load returns.
Vec6 compute_load(const NodalLoad& load, const Vec6& at_time, const NodeMotion& motion, double time);
Vec6 compute_load(const NodalLoad& load, const NodeMotion& motion, double time);

// Its derivative with respect to (δr, δφ) as it turns with the node; zero for a dead load. `value` is what
// compute_load returns.
Mat6 compute_load_tangent(const NodalLoad& load, const Vec6& value, const NodeLinearization& linearization);
// The derivative of its force with respect to δr, on which place and velocity depend. The load must have a
// force that depends on the motion. `length`: of the model, which gives the differences their size.
Mat3 compute_motion_force_tangent(const NodalLoad& load,
                                  const NodeMotion& motion,
                                  const NodeLinearization& linearization,
                                  double time,
                                  double length);

}  // namespace gxrod
