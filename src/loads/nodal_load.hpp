#pragma once

#include "model/model.hpp"
#include "state/motion.hpp"

// Forces and moments on nodes, dead or turning with them.
namespace gxrod {

// Force and moment at `time`, stacked, in the axes that the load is given in. Throws EvaluationError.
Vec6 evaluate_load(const NodalLoad& load, double time);
// The same as the node turns them: spatial.
Vec6 turn_load(const NodalLoad& load, const Vec6& value, const NodeMotion& motion);

// Force and moment that the load exerts on its node at `time`: spatial, stacked.
Vec6 compute_load(const NodalLoad& load, const NodeMotion& motion, double time);

// Its derivative with respect to (δr, δφ); zero for a dead load. `value` is what compute_load returns.
Mat6 compute_load_tangent(const NodalLoad& load, const Vec6& value, const NodeLinearization& linearization);

}  // namespace gxrod
