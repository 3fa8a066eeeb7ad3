#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "model/model.hpp"
#include "state/motion.hpp"

// Forces and moments along rods.
namespace gxrod {

inline constexpr int most_element_nodes = 5;

// A distributed load on one element: what its nodes share of the integral at its quadrature points. The load
// of a frame that turns is turned by the nodes and interpolated, Σ N_J Λ_J q, like every other field.
struct LoadedElement {
    struct Point {
        double arc_length;  // from the start of the rod
        double weight;      // in arc length
        std::array<double, most_element_nodes> shape;
    };

    const DistributedLoad* load = nullptr;
    std::vector<int> nodes;    // of the model
    std::vector<Quat> triads;  // section axes at t = 0
    std::vector<Point> points;
};

// Force and moment per length, stacked, in the axes that the load is given in. Throws EvaluationError.
Vec6 compute_load_per_length(const DistributedLoad& load, double time, double arc_length);

using LoadMatrix = Eigen::Matrix<double,
                                 Eigen::Dynamic,
                                 Eigen::Dynamic,
                                 Eigen::ColMajor,
                                 6 * most_element_nodes,
                                 6 * most_element_nodes>;

using LoadVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6 * most_element_nodes, 1>;

// The forces and moments that the load puts on the element's nodes at `time`: spatial, six a node.
LoadVector compute_distributed_load(const LoadedElement& element,
                                    const std::vector<NodeMotion>& motions,
                                    double time);
// Adds them per node of the model.
void add_distributed_load(const LoadedElement& element,
                          const std::vector<NodeMotion>& motions,
                          double time,
                          std::vector<Vec6>& nodal);

// The derivative of those with respect to (δr, δφ) of the element's nodes; zero for a dead load.
LoadMatrix compute_distributed_load_tangent(const LoadedElement& element,
                                            const std::vector<NodeMotion>& motions,
                                            double time,
                                            const std::vector<NodeLinearization>& linearizations);

}  // namespace gxrod
