#pragma once

#include <span>
#include <vector>

#include "loads/loaded_element.hpp"
#include "rotation/types.hpp"

// Integrals of loads along elements. N_I are the shape functions of an element, q the load per length: force
// and moment, stacked, in the axes of the load.
namespace gxrod {

// The moments: for a dead load and a magnetic moment ∫ N_I q ds, node by node. Other loads in a frame that
// turns are turned by the nodes and interpolated, Σ N_J Λ_J q, like every other field: they have ∫ N_I N_J q
// ds, J ≤ I, at moment_index(I, J).
using LoadMoments = std::vector<Vec6>;

constexpr std::size_t moment_index(std::size_t i, std::size_t j) {
    return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}
std::size_t moment_count(const DistributedLoad& load, std::size_t nodes);

// Whether the nodes turn the load and it is interpolated. The moments ∫ N_I μ ds of a magnetic rod are turned
// too, but each of them is a magnet at its node, so that the field has a potential.
inline bool is_interpolated(const DistributedLoad& load) {
    return load.frame != Frame::spatial && !load.field;
}

// Computes force and moment per length. Throws EvaluationError.
Vec6 compute_load_per_length(const DistributedLoad& load, double time, double arc_length);

// Options for the integration of a load along one element.
struct IntegralPlan {
    double time = 0.0;
    std::span<const double> breaks;  // arc lengths in the whole rod, sorted
    int pieces = 1;                  // least number of pieces of the element
};

// Computes the moments; their error is at most about 1e-8 of the integral of the load's size over the
// element, 1e-6 if the load varies in time. Throws EvaluationError if that cannot be reached.
void integrate_load(const LoadedElement& element, const IntegralPlan& plan, std::span<Vec6> moments);

// Computes the moments of a constant load q, by Gauss' rule with as many points as nodes, which also
// integrates the mass of the element.
void integrate_even_load(const LoadedElement& element, const Vec6& q, std::span<Vec6> moments);

}  // namespace gxrod
