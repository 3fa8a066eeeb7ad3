#include "loads/distributed_load.hpp"

#include "loads/magnet.hpp"
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

// Of a magnetic rod, whose moment at node `j` is turned by it.
Magnet find_magnet(const LoadedElement& element,
                   std::size_t j,
                   const LoadAtTime& load,
                   const std::vector<NodeMotion>& motions) {
    const double length = element.arc_lengths.back() - element.arc_lengths.front();
    return {*element.load->field,
            load.time,
            motions[element.nodes[j]].r,
            turn(element, j, motions, load.moments[j]).tail<3>(),
            length};
}

}  // namespace

LoadVector compute_distributed_load(const LoadedElement& element,
                                    const LoadAtTime& load,
                                    const std::vector<NodeMotion>& motions) {
    const std::size_t nodes = element.nodes.size();
    LoadVector force = LoadVector::Zero(first_of(nodes));
    for (std::size_t i = 0; i < nodes; ++i) {
        Vec6 own = Vec6::Zero();
        if (element.load->field) {
            own = compute_magnetic_load(find_magnet(element, i, load, motions));
        } else if (element.load->frame == Frame::spatial) {
            own = load.moments[i];
        } else {
            for (std::size_t j = 0; j < nodes; ++j)
                own += turn(element, j, motions, load.moments[moment_index(i, j)]);
        }
        force.segment<6>(first_of(i)) = own;
    }
    return force;
}

void add_distributed_load(const LoadedElement& element,
                          const LoadAtTime& load,
                          const std::vector<NodeMotion>& motions,
                          std::vector<Vec6>& nodal) {
    const LoadVector force = compute_distributed_load(element, load, motions);
    for (std::size_t i = 0; i < element.nodes.size(); ++i) {
        nodal[element.nodes[i]] += force.segment<6>(first_of(i));
    }
}

LoadMatrix compute_distributed_load_tangent(const LoadedElement& element,
                                            const LoadAtTime& load,
                                            const std::vector<NodeMotion>& motions,
                                            const std::vector<NodeLinearization>& linearizations) {
    const std::size_t nodes = element.nodes.size();
    LoadMatrix tangent = LoadMatrix::Zero(first_of(nodes), first_of(nodes));
    if (element.load->frame == Frame::spatial) return tangent;
    for (std::size_t j = 0; j < nodes; ++j) {
        const double placement = linearizations[element.nodes[j]].placement;
        if (element.load->field) {
            if (placement == 0.0) continue;
            tangent.block<6, 6>(first_of(j), first_of(j)) =
                placement * compute_magnetic_tangent(find_magnet(element, j, load, motions));
            continue;
        }
        for (std::size_t i = 0; i < nodes; ++i) {
            const Vec6 turned = turn(element, j, motions, load.moments[moment_index(i, j)]);
            const Eigen::Index row = first_of(i);
            const Eigen::Index column = first_of(j) + 3;
            tangent.block<3, 3>(row, column) = -placement * spin(turned.head<3>());
            tangent.block<3, 3>(row + 3, column) = -placement * spin(turned.tail<3>());
        }
    }
    return tangent;
}

}  // namespace gxrod
