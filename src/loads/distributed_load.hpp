#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "loads/load_integral.hpp"
#include "loads/loaded_element.hpp"
#include "state/motion.hpp"

// Forces and moments along rods, as nodes turn them.
namespace gxrod {

inline constexpr int most_element_unknowns = 6 * static_cast<int>(most_element_nodes);

using LoadMatrix = Eigen::Matrix<double,
                                 Eigen::Dynamic,
                                 Eigen::Dynamic,
                                 Eigen::ColMajor,
                                 most_element_unknowns,
                                 most_element_unknowns>;
using LoadVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most_element_unknowns, 1>;

// The load of an element at a time, with its moments (load_integral.hpp).
struct LoadAtTime {
    double time;
    std::span<const Vec6> moments;
};

// Computes the forces and moments of the load on the element's nodes: spatial, six per node.
LoadVector compute_distributed_load(const LoadedElement& element,
                                    const LoadAtTime& load,
                                    const std::vector<NodeMotion>& motions);
// Adds them to the nodes of the model.
void add_distributed_load(const LoadedElement& element,
                          const LoadAtTime& load,
                          const std::vector<NodeMotion>& motions,
                          std::vector<Vec6>& nodal);

// Computes their derivative by (δr, δφ) of the element's nodes; zero for a dead load.
LoadMatrix compute_distributed_load_tangent(const LoadedElement& element,
                                            const LoadAtTime& load,
                                            const std::vector<NodeMotion>& motions,
                                            const std::vector<NodeLinearization>& linearizations);

}  // namespace gxrod
