#include "results/history_point.hpp"

#include <algorithm>
#include <cassert>

#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// Elements of a rod that hold its node at `position`.
std::vector<int> adjacent_elements(const Rod& rod, int position) {
    const int node = rod.nodes[static_cast<std::size_t>(position)];
    std::vector<int> elements;
    for (std::size_t i = 0; i < rod.element_nodes.size(); ++i) {
        if (rod.element_nodes[i] == node) elements.push_back(static_cast<int>(i) / (rod.order + 1));
    }
    return elements;
}

int first_element(const Model& model, int rod) {
    int count = 0;
    for (int i = 0; i < rod; ++i) count += model.rods[static_cast<std::size_t>(i)].element_count();
    return count;
}

HistoryPoint::Row row(const Vec3& vector) { return {vector.x(), vector.y(), vector.z(), 0.0}; }

// The axes of the rod at the end of an element that has the node.
Quat element_triad(const Rod& rod, int element, int node) {
    const auto first = rod.element_nodes.begin() + static_cast<std::ptrdiff_t>(element) * (rod.order + 1);
    const auto found = std::find(first, first + rod.order + 1, node);
    return rod.triads[static_cast<std::size_t>(found - rod.element_nodes.begin())];
}

Vec3 section_value(Quantity quantity, const SectionValues& section) {
    switch (quantity) {
        case Quantity::force:
            return section.force;
        case Quantity::moment:
            return section.moment;
        case Quantity::strain:
            return section.strain;
        case Quantity::curvature:
            return section.curvature;
        case Quantity::force_spatial:
            return section.axes * section.force;
        default:
            return section.axes * section.moment;
    }
}

}  // namespace

HistoryPoint::HistoryPoint(const Model& model, const HistoryRequest& request)
    : start_(model.nodes[static_cast<std::size_t>(request.node)].position),
      node_(request.node),
      relative_node_(request.relative_node),
      relative_axes_(request.relative_axes) {
    if (relative_node_ >= 0) {
        const Vec3& origin = model.nodes[static_cast<std::size_t>(relative_node_)].position;
        start_ = relative_axes_.conjugate() * (start_ - origin);
    }
    Quat triad = Quat::Identity();
    if (request.body >= 0) {
        body_ = &model.bodies[static_cast<std::size_t>(request.body)];
        triad = body_->attitude;
    } else if (request.rod >= 0) {
        const Rod& rod = model.rods[static_cast<std::size_t>(request.rod)];
        const bool is_end = request.end_element >= 0;
        triad = is_end ? element_triad(rod, request.end_element, request.node)
                       : rod.triad_at(request.position_in_rod);
        elements_ =
            is_end ? std::vector{request.end_element} : adjacent_elements(rod, request.position_in_rod);
        for (int& element : elements_) element += first_element(model, request.rod);
    }
    start_axes_ = relative_axes_.conjugate() * triad;
}

// With A = Λ_ref A₀ the axes of the reference point, ω and α its spatial rates, d = r − r_ref and
// c = v − v_ref − ω × d the velocity that an observer on those axes sees:
//   position Aᵀ d, velocity Aᵀ c, acceleration Aᵀ (a − a_ref − α × d − ω × (ω × d) − 2 ω × c),
//   angular velocity Aᵀ (ω_point − ω); Aᵀ Λ A₀ takes the place of Λ, so that with A₀ it is the identity at
//   t = 0, and Aᵀ Λ triad = (Aᵀ Λ A₀) (A₀ᵀ triad) are the axes of the point from those of the reference.
NodeMotion HistoryPoint::seen_from_reference(const Snapshot& snapshot) const {
    const NodeMotion& node = snapshot.nodes[static_cast<std::size_t>(node_)];
    if (relative_node_ < 0) return node;
    const NodeMotion& reference = snapshot.nodes[static_cast<std::size_t>(relative_node_)];
    const Quat to_axes = (reference.Lambda * relative_axes_).conjugate();
    const Vec3& omega = reference.omega;
    const Vec3 d = node.r - reference.r;
    const Vec3 c = node.v - reference.v - omega.cross(d);
    NodeMotion seen;
    seen.r = to_axes * d;
    seen.v = to_axes * c;
    seen.a = to_axes * (node.a - reference.a - reference.alpha.cross(d) - omega.cross(omega.cross(d)) -
                        2.0 * omega.cross(c));
    seen.Lambda = to_axes * node.Lambda * relative_axes_;
    seen.omega = to_axes * (node.omega - omega);
    return seen;
}

Vec3 HistoryPoint::section_mean(Quantity quantity, const Snapshot& snapshot) const {
    assert(!elements_.empty());
    Vec3 sum = Vec3::Zero();
    for (const int element : elements_) {
        sum += section_value(quantity, snapshot.elements[static_cast<std::size_t>(element)]);
    }
    return sum / static_cast<double>(elements_.size());
}

HistoryPoint::Row HistoryPoint::continuous_quaternion(const Quat& rotation, Quat& last) {
    const double sign = rotation.dot(last) < 0.0 ? -1.0 : 1.0;
    last.coeffs() = sign * rotation.coeffs();
    return {last.w(), last.x(), last.y(), last.z()};
}

void HistoryPoint::go_on_from(Quantity quantity, std::span<const double> row) {
    if (quantity == Quantity::quaternion) last_quaternion_ = Quat(row[0], row[1], row[2], row[3]);
    if (quantity == Quantity::orientation) last_orientation_ = Quat(row[0], row[1], row[2], row[3]);
}

HistoryPoint::Row HistoryPoint::compute(Quantity quantity, const Snapshot& snapshot) {
    const NodeMotion node = seen_from_reference(snapshot);
    const Quat axes = node.Lambda * start_axes_;
    const Quat rotation = body_ ? axes : node.Lambda;
    switch (quantity) {
        case Quantity::position:
            return row(node.r);
        case Quantity::displacement:
            return row(node.r - start_);
        case Quantity::rotation_vector:
            return row(log(rotation));
        case Quantity::quaternion:
            return continuous_quaternion(rotation, last_quaternion_);
        case Quantity::orientation:
            return continuous_quaternion(axes, last_orientation_);
        case Quantity::velocity:
            return row(node.v);
        case Quantity::angular_velocity:
            return row(node.omega);
        case Quantity::angular_velocity_material:
            return row(axes.conjugate() * node.omega);
        case Quantity::acceleration:
            return row(node.a);
        case Quantity::centre_of_mass:
            assert(body_);
            return row(node.r + axes * body_->centre_of_mass);
        case Quantity::force:
        case Quantity::moment:
        case Quantity::strain:
        case Quantity::curvature:
        case Quantity::force_spatial:
        case Quantity::moment_spatial:
            return row(section_mean(quantity, snapshot));
        case Quantity::reaction_force:
            return row(snapshot.reactions[static_cast<std::size_t>(node_)].head<3>());
        case Quantity::reaction_moment:
            return row(snapshot.reactions[static_cast<std::size_t>(node_)].tail<3>());
    }
    assert(false);
    return {};
}

}  // namespace gxrod
