#include "model/model.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/spring_law.hpp"
#include "numerics/gauss_legendre.hpp"

namespace gxrod {

const Quat& Rod::triad_at(int position) const {
    const auto found = std::find(element_nodes.begin(), element_nodes.end(), nodes[position]);
    assert(found != element_nodes.end());
    return triads[found - element_nodes.begin()];
}

std::vector<double> arc_lengths_of_nodes(const Rod& rod) {
    std::vector<double> of_nodes(rod.nodes.size());
    std::size_t position = 0;
    for (std::size_t i = 0; i < rod.element_nodes.size(); ++i) {
        if (rod.element_nodes[i] != rod.nodes[position]) ++position;
        of_nodes[position] = rod.arc_length[i];
    }
    return of_nodes;
}

std::vector<double> list_force_points(const Rod& rod) {
    const std::vector<QuadraturePoint> rule = list_gauss_rule(rod.order);
    const auto order = static_cast<std::size_t>(rod.order);
    std::vector<double> points;
    points.reserve(static_cast<std::size_t>(rod.element_count()) * order);
    for (std::size_t first = 0; first < rod.arc_length.size(); first += order + 1) {
        const double start = rod.arc_length[first];
        const double length = rod.arc_length[first + order] - start;
        for (const auto& [xi, weight] : rule) points.push_back(start + 0.5 * (1.0 + xi) * length);
    }
    return points;
}

void set_line_elements(Rod& rod,
                       const std::vector<double>& arc_length_of_nodes,
                       const std::vector<Quat>& triads_of_nodes) {
    const int elements = (static_cast<int>(rod.nodes.size()) - 1) / rod.order;
    rod.length = arc_length_of_nodes.back();
    for (int e = 0; e < elements; ++e) {
        for (int i = 0; i <= rod.order; ++i) {
            const int position = e * rod.order + i;
            rod.element_nodes.push_back(rod.nodes[position]);
            rod.arc_length.push_back(arc_length_of_nodes[position]);
            rod.triads.push_back(triads_of_nodes[position]);
        }
    }
}

double find_stiffness(const Spring& spring) {
    if (!spring.law) return spring.stiffness;
    return std::abs(spring.stiffness + spring.law->differentiate_by_length(spring.law->start(), 0.0));
}

double compute_elastic_tension(const Spring& spring, double length) {
    const double linear = spring.stiffness * (length - spring.length);
    return spring.law ? linear + (*spring.law)(length, 0.0) : linear;
}

Vec3 find_place(const Model& model, const Anchor& anchor) {
    return anchor.is_ground() ? anchor.arm : Vec3(model.nodes[anchor.node].position + anchor.arm);
}

}  // namespace gxrod
