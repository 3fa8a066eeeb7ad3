#include "elements/spring_line.hpp"

#include "model/spring_law.hpp"

namespace gxrod {

PointDistance compute_distance(const std::array<Anchor, 2>& ends, const NodeMotion* a, const NodeMotion* b) {
    const std::array<const NodeMotion*, 2> nodes{a, b};
    PointDistance distance;
    for (std::size_t i = 0; i < 2; ++i) {
        const double sign = i == 0 ? -1.0 : 1.0;
        if (nodes[i] == nullptr) {
            distance.d += sign * ends[i].arm;
            continue;
        }
        const Vec3 u = nodes[i]->Lambda * ends[i].arm;
        distance.d += sign * (nodes[i]->r + u);
        distance.rate += sign * (nodes[i]->v + nodes[i]->omega.cross(u));
    }
    return distance;
}

SpringLine compute_spring_line(const Spring& spring, const NodeMotion* a, const NodeMotion* b) {
    SpringLine line{compute_distance(spring.ends, a, b)};
    line.length = line.d.norm();
    line.direction = line.d / line.length;
    if (line.length > 0.0) line.length_rate = line.direction.dot(line.rate);
    return line;
}

SpringLine compute_spring_line(const Spring& spring, const std::vector<NodeMotion>& nodes) {
    const auto find = [&](const Anchor& end) { return end.is_ground() ? nullptr : &nodes[end.node]; };
    return compute_spring_line(spring, find(spring.ends[0]), find(spring.ends[1]));
}

double compute_damper_tension(const Spring& spring, double length, double length_rate) {
    const double linear = spring.damping * length_rate;
    if (!spring.law || !spring.law->has_rate()) return linear;
    return linear + (*spring.law)(length, length_rate) - (*spring.law)(length, 0.0);
}

double compute_axial_force(const Spring& spring, const SpringLine& line) {
    return compute_elastic_tension(spring, line.length) +
           compute_damper_tension(spring, line.length, line.length_rate);
}

SpringValues measure(const Spring& spring, const NodeMotion* a, const NodeMotion* b) {
    const SpringLine line = compute_spring_line(spring, a, b);
    return {line.length - spring.length, compute_axial_force(spring, line)};
}

}  // namespace gxrod
