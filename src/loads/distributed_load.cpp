#include "loads/distributed_load.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

// Force and moment per length as node `j` turns them.
Vec6 turn(const LoadedElement& element,
          std::size_t j,
          const std::vector<NodeMotion>& motions,
          const Vec6& q) {
    if (element.load->frame == Frame::spatial) return q;
    const Quat& Lambda = motions[element.nodes[j]].Lambda;
    const Quat axes = element.load->frame == Frame::body ? Lambda * element.triads[j] : Lambda;
    Vec6 turned;
    turned << axes * q.head<3>(), axes * q.tail<3>();
    return turned;
}

}  // namespace

Vec6 compute_load_per_length(const DistributedLoad& load, double time, double arc_length) {
    Vec6 value;
    for (int i = 0; i < 3; ++i) {
        value[i] = load.force[i](time, arc_length);
        value[i + 3] = load.moment[i](time, arc_length);
    }
    return value;
}

LoadVector compute_distributed_load(const LoadedElement& element,
                                    const std::vector<NodeMotion>& motions,
                                    double time) {
    LoadVector force = LoadVector::Zero(static_cast<Eigen::Index>(6 * element.nodes.size()));
    for (const LoadedElement::Point& point : element.points) {
        const Vec6 q = compute_load_per_length(*element.load, time, point.arc_length);
        Vec6 turned = Vec6::Zero();
        for (std::size_t j = 0; j < element.nodes.size(); ++j) {
            turned += point.shape[j] * turn(element, j, motions, q);
        }
        for (std::size_t i = 0; i < element.nodes.size(); ++i) {
            force.segment<6>(static_cast<Eigen::Index>(6 * i)) += (point.weight * point.shape[i]) * turned;
        }
    }
    return force;
}

void add_distributed_load(const LoadedElement& element,
                          const std::vector<NodeMotion>& motions,
                          double time,
                          std::vector<Vec6>& nodal) {
    const LoadVector force = compute_distributed_load(element, motions, time);
    for (std::size_t i = 0; i < element.nodes.size(); ++i) {
        nodal[element.nodes[i]] += force.segment<6>(static_cast<Eigen::Index>(6 * i));
    }
}

LoadMatrix compute_distributed_load_tangent(const LoadedElement& element,
                                            const std::vector<NodeMotion>& motions,
                                            double time,
                                            const std::vector<NodeLinearization>& linearizations) {
    const auto nodes = static_cast<Eigen::Index>(element.nodes.size());
    LoadMatrix tangent = LoadMatrix::Zero(6 * nodes, 6 * nodes);
    if (element.load->frame == Frame::spatial) return tangent;
    for (const LoadedElement::Point& point : element.points) {
        const Vec6 q = compute_load_per_length(*element.load, time, point.arc_length);
        for (Eigen::Index j = 0; j < nodes; ++j) {
            const Vec6 turned = turn(element, static_cast<std::size_t>(j), motions, q);
            const double placement = linearizations[element.nodes[j]].placement;
            for (Eigen::Index i = 0; i < nodes; ++i) {
                const double share = placement * point.weight * point.shape[i] * point.shape[j];
                tangent.block<3, 3>(6 * i, 6 * j + 3) -= share * spin(turned.head<3>());
                tangent.block<3, 3>(6 * i + 3, 6 * j + 3) -= share * spin(turned.tail<3>());
            }
        }
    }
    return tangent;
}

}  // namespace gxrod
