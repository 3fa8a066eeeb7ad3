#include "state/spring_line.hpp"

namespace gxrod {

SpringLine compute_spring_line(const Spring& spring, const NodeMotion* a, const NodeMotion* b) {
    const std::array<const NodeMotion*, 2> nodes{a, b};
    SpringLine line;
    for (std::size_t i = 0; i < 2; ++i) {
        const double sign = i == 0 ? -1.0 : 1.0;
        if (nodes[i] == nullptr) {
            line.d += sign * spring.ends[i].arm;
            continue;
        }
        const Vec3 u = nodes[i]->Lambda * spring.ends[i].arm;
        line.d += sign * (nodes[i]->r + u);
        line.rate += sign * (nodes[i]->v + nodes[i]->omega.cross(u));
    }
    line.length = line.d.norm();
    line.direction = line.d / line.length;
    if (line.length > 0.0) line.length_rate = line.direction.dot(line.rate);
    return line;
}

SpringLine compute_spring_line(const Spring& spring, const std::vector<NodeMotion>& nodes) {
    const auto find = [&](const SpringEnd& end) { return end.is_ground() ? nullptr : &nodes[end.node]; };
    return compute_spring_line(spring, find(spring.ends[0]), find(spring.ends[1]));
}

double compute_axial_force(const Spring& spring, const SpringLine& line) {
    return spring.stiffness * (line.length - spring.length) + spring.damping * line.length_rate;
}

}  // namespace gxrod
