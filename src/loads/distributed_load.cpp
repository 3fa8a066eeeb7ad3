#include "loads/distributed_load.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

// Force and moment as node `j` turns them.
Vec6 turn(const LoadedElement& element,
          std::size_t j,
          const std::vector<NodeMotion>& motions,
          const Vec6& q) {
    const Quat& Lambda = motions[element.nodes[j]].Lambda;
    const Quat axes = element.load->frame == Frame::body ? Lambda * element.triads[j] : Lambda;
    Vec6 turned;
    turned << axes * q.head<3>(), axes * q.tail<3>();
    return turned;
}

constexpr Eigen::Index first_of(std::size_t node) { return static_cast<Eigen::Index>(6 * node); }

}  // namespace

LoadVector compute_distributed_load(const LoadedElement& element,
                                    std::span<const Vec6> moments,
                                    const std::vector<NodeMotion>& motions) {
    const std::size_t nodes = element.nodes.size();
    LoadVector force = LoadVector::Zero(first_of(nodes));
    for (std::size_t i = 0; i < nodes; ++i) {
        if (element.load->frame == Frame::spatial) {
            force.segment<6>(first_of(i)) = moments[i];
            continue;
        }
        for (std::size_t j = 0; j < nodes; ++j) {
            force.segment<6>(first_of(i)) += turn(element, j, motions, moments[moment_index(i, j)]);
        }
    }
    return force;
}

void add_distributed_load(const LoadedElement& element,
                          std::span<const Vec6> moments,
                          const std::vector<NodeMotion>& motions,
                          std::vector<Vec6>& nodal) {
    const LoadVector force = compute_distributed_load(element, moments, motions);
    for (std::size_t i = 0; i < element.nodes.size(); ++i) {
        nodal[element.nodes[i]] += force.segment<6>(first_of(i));
    }
}

LoadMatrix compute_distributed_load_tangent(const LoadedElement& element,
                                            std::span<const Vec6> moments,
                                            const std::vector<NodeMotion>& motions,
                                            const std::vector<NodeLinearization>& linearizations) {
    const std::size_t nodes = element.nodes.size();
    LoadMatrix tangent = LoadMatrix::Zero(first_of(nodes), first_of(nodes));
    if (element.load->frame == Frame::spatial) return tangent;
    for (std::size_t j = 0; j < nodes; ++j) {
        const double placement = linearizations[element.nodes[j]].placement;
        for (std::size_t i = 0; i < nodes; ++i) {
            const Vec6 turned = turn(element, j, motions, moments[moment_index(i, j)]);
            const Eigen::Index row = first_of(i);
            const Eigen::Index column = first_of(j) + 3;
            tangent.block<3, 3>(row, column) = -placement * spin(turned.head<3>());
            tangent.block<3, 3>(row + 3, column) = -placement * spin(turned.tail<3>());
        }
    }
    return tangent;
}

}  // namespace gxrod
