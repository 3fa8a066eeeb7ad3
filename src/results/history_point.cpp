#include "results/history_point.hpp"

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
    : reference_position_(model.nodes[static_cast<std::size_t>(request.node)].position), node_(request.node) {
    if (request.body >= 0) {
        body_ = &model.bodies[static_cast<std::size_t>(request.body)];
        triad_ = body_->attitude;
    } else if (request.rod >= 0) {
        const Rod& rod = model.rods[static_cast<std::size_t>(request.rod)];
        triad_ = rod.triad_at(request.position_in_rod);
        elements_ = adjacent_elements(rod, request.position_in_rod);
        for (int& element : elements_) element += first_element(model, request.rod);
    }
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

HistoryPoint::Row HistoryPoint::compute(Quantity quantity, const Snapshot& snapshot) {
    const NodeMotion& node = snapshot.nodes[static_cast<std::size_t>(node_)];
    const Quat rotation = body_ ? node.Lambda * triad_ : node.Lambda;
    switch (quantity) {
        case Quantity::position:
            return row(node.r);
        case Quantity::displacement:
            return row(node.r - reference_position_);
        case Quantity::rotation_vector:
            return row(log(rotation));
        case Quantity::quaternion:
            return continuous_quaternion(rotation, last_quaternion_);
        case Quantity::orientation:
            return continuous_quaternion(node.Lambda * triad_, last_orientation_);
        case Quantity::velocity:
            return row(node.v);
        case Quantity::angular_velocity:
            return row(node.omega);
        case Quantity::angular_velocity_material:
            return row((node.Lambda * triad_).conjugate() * node.omega);
        case Quantity::acceleration:
            return row(node.a);
        case Quantity::centre_of_mass:
            assert(body_);
            return row(node.r + (node.Lambda * triad_) * body_->centre_of_mass);
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
