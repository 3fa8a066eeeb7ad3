#include "results/histories/history_point.hpp"

#include <algorithm>
#include <cassert>

#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

HistoryPoint::Row row(const Vec3& vector) { return {vector.x(), vector.y(), vector.z(), 0.0}; }

// What a node says without its rod.
bool is_of_motion_or_reaction(Quantity quantity) {
    switch (quantity) {
        case Quantity::position:
        case Quantity::displacement:
        case Quantity::rotation_vector:
        case Quantity::quaternion:
        case Quantity::orientation:
        case Quantity::velocity:
        case Quantity::angular_velocity:
        case Quantity::angular_velocity_material:
        case Quantity::acceleration:
        case Quantity::reaction_force:
        case Quantity::reaction_moment:
            return true;
        default:
            return false;
    }
}

// The axes of the section at a node of an element, at t = 0.
Quat section_axes(const Model& model, const RodPlace& place, int node) {
    const Rod& rod = model.rods[static_cast<std::size_t>(place.rod)];
    const auto first =
        rod.element_nodes.begin() + static_cast<std::ptrdiff_t>(place.element) * (rod.order + 1);
    const auto local = std::find(first, first + rod.order + 1, node) - first;
    // A rod of one element that closes on itself has its node twice.
    const bool is_end = place.xi == 1.0;
    return rod
        .triads[static_cast<std::size_t>(first - rod.element_nodes.begin() + (is_end ? rod.order : local))];
}

// Of a joint, or of a sleeve, which come behind joints and gears.
const JointCoordinate& find_slide(const Model& model, std::size_t index) {
    if (index < model.joints.size()) return model.joints[index].slide;
    return model.sleeves[index - model.joints.size() - model.gears.size()].slide;
}

}  // namespace

std::vector<RodPlace> list_rod_places(const std::vector<HistoryRequest>& requests) {
    std::vector<RodPlace> places;
    for (const HistoryRequest& request : requests) {
        if (!request.place) continue;
        places.push_back(*request.place);
        places.back().is_asked =
            request.node < 0 || !std::ranges::all_of(request.quantities, is_of_motion_or_reaction);
    }
    return places;
}

std::vector<ContactWatch> list_contact_watches(const std::vector<HistoryRequest>& requests) {
    std::vector<ContactWatch> watches;
    for (const HistoryRequest& request : requests) {
        if (request.contact) watches.push_back(*request.contact);
    }
    return watches;
}

HistoryPoint::HistoryPoint(const Model& model, const std::vector<HistoryRequest>& requests, std::size_t index)
    : node_(requests[index].node),
      relative_node_(requests[index].relative_node),
      relative_axes_(requests[index].relative_axes),
      about_(requests[index].about),
      tendon_(requests[index].tendon),
      obstacle_(requests[index].obstacle) {
    const HistoryRequest& request = requests[index];
    for (std::size_t i = 0; i < index; ++i) point_ += requests[i].place ? 1 : 0;
    if (request.contact) {
        contact_ = 0;
        for (std::size_t i = 0; i < index; ++i) contact_ += requests[i].contact ? 1 : 0;
    }
    spring_ = request.spring;
    bushing_ = request.bushing;
    is_of_gear_ = request.gear >= 0;
    joint_ = is_of_gear_ ? static_cast<int>(model.joints.size()) + request.gear : request.joint;
    if (is_of_gear_) drives_slide_ = !model.gears[static_cast<std::size_t>(request.gear)].sides[1].is_turn;
    if (request.joint >= 0) {
        const auto joint = static_cast<std::size_t>(request.joint);
        const JointCoordinate& slide = find_slide(model, joint);
        const bool has_turn = joint < model.joints.size() && model.joints[joint].has_turn();
        drives_slide_ = slide.motion || !slide.drive.is_zero() || !has_turn;
        rubs_slide_ = slide.friction.acts() || !has_turn;
    }
    if (request.body >= 0) {
        body_index_ = static_cast<std::size_t>(request.body);
        body_ = &model.bodies[body_index_];
        start_axes_ = body_->attitude;
    } else if (request.place && node_ >= 0) {
        start_axes_ = section_axes(model, *request.place, node_);
    }
    if (node_ >= 0) start_ = model.nodes[static_cast<std::size_t>(node_)].position;
    if (relative_node_ >= 0) relative_start_ = model.nodes[static_cast<std::size_t>(relative_node_)].position;
}

HistoryPoint::Seen HistoryPoint::see(const Snapshot& snapshot) const {
    if (node_ >= 0) return {start_, start_axes_, snapshot.nodes[static_cast<std::size_t>(node_)]};
    const PointValues& point = snapshot.points[point_];
    return {point.start, point.triad, point.motion};
}

// With A = Λ_ref A₀ the axes of the reference point, ω and α its spatial rates, d = r − r_ref and
// c = v − v_ref − ω × d the velocity that an observer on those axes sees:
//   position Aᵀ d, velocity Aᵀ c, acceleration Aᵀ (a − a_ref − α × d − ω × (ω × d) − 2 ω × c),
//   angular velocity Aᵀ (ω_point − ω); Aᵀ Λ A₀ takes the place of Λ, so that with A₀ it is the identity at
//   t = 0, and Aᵀ Λ triad = (Aᵀ Λ A₀) (A₀ᵀ triad) are the axes of the point from those of the reference.
HistoryPoint::Seen HistoryPoint::see_from_reference(const Snapshot& snapshot) const {
    Seen point = see(snapshot);
    if (relative_node_ < 0) return point;
    const NodeMotion& node = point.motion;
    const NodeMotion& reference = snapshot.nodes[static_cast<std::size_t>(relative_node_)];
    const Quat to_axes = (reference.Lambda * relative_axes_).conjugate();
    const Vec3& omega = reference.omega;
    const Vec3 d = node.r - reference.r;
    const Vec3 c = node.v - reference.v - omega.cross(d);
    Seen seen;
    seen.start = relative_axes_.conjugate() * (point.start - relative_start_);
    seen.start_axes = relative_axes_.conjugate() * point.start_axes;
    seen.motion.r = to_axes * d;
    seen.motion.v = to_axes * c;
    seen.motion.a = to_axes * (node.a - reference.a - reference.alpha.cross(d) - omega.cross(omega.cross(d)) -
                               2.0 * omega.cross(c));
    seen.motion.Lambda = to_axes * node.Lambda * relative_axes_;
    seen.motion.omega = to_axes * (node.omega - omega);
    return seen;
}

// M + (r − about) × F of the force F and the moment M on the node at r.
Vec3 HistoryPoint::reaction_moment(const Snapshot& snapshot) const {
    const auto node = static_cast<std::size_t>(node_);
    const Vec6& reaction = snapshot.reactions[node];
    if (!about_) return reaction.tail<3>();
    return reaction.tail<3>() + (snapshot.nodes[node].r - *about_).cross(reaction.head<3>());
}

Vec3 HistoryPoint::section_value(Quantity quantity, const Snapshot& snapshot, const Quat& axes) const {
    const PointValues& point = snapshot.points[point_];
    switch (quantity) {
        case Quantity::force:
            return point.force;
        case Quantity::moment:
            return point.moment;
        case Quantity::strain:
            return point.strain;
        case Quantity::curvature:
            return point.curvature;
        case Quantity::force_spatial:
            return axes * point.force;
        default:
            return axes * point.moment;
    }
}

// Of a point of a rod, or of a body.
HistoryPoint::Row HistoryPoint::surrounding_value(Quantity quantity, const Snapshot& snapshot) const {
    static const PointSurroundings none{};
    const PointSurroundings* around = &none;
    if (!body_) {
        around = &snapshot.points[point_].surroundings;
    } else if (!snapshot.bodies.empty()) {
        around = &snapshot.bodies[body_index_];
    }
    switch (quantity) {
        case Quantity::effective_tension:
            return {snapshot.points[point_].force.x()};
        case Quantity::wall_tension:
            return {snapshot.points[point_].force.x() + around->pressure_force};
        case Quantity::water_velocity:
            return row(around->water_velocity);
        case Quantity::wet_fraction:
            return {around->wet_fraction};
        case Quantity::fluid_force:
            return row(around->fluid_force);
        default:
            assert(quantity == Quantity::bed_force);
            return row(around->bed_force);
    }
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

PointKind HistoryPoint::kind() const {
    if (contact_ >= 0 && !body_) return PointKind::rod_in_contact;
    if (spring_ >= 0) return PointKind::spring;
    if (bushing_ >= 0) return PointKind::bushing;
    if (joint_ >= 0) return is_of_gear_ ? PointKind::gear : PointKind::joint;
    return body_ ? PointKind::body : PointKind::rod;
}

bool HistoryPoint::is_force_of_slide(Quantity quantity) const {
    return (quantity == Quantity::drive && drives_slide_) || (quantity == Quantity::friction && rubs_slide_);
}

HistoryPoint::Row HistoryPoint::joint_value(Quantity quantity, const JointValues& joint) {
    switch (quantity) {
        case Quantity::angle:
            return {joint.turn};
        case Quantity::angle_rate:
            return {joint.turn_rate};
        case Quantity::slide:
            return {joint.slide};
        case Quantity::slide_rate:
            return {joint.slide_rate};
        case Quantity::force:
            return row(joint.force);
        case Quantity::moment:
            return row(joint.moment);
        case Quantity::force_a:
            return row(joint.force_in_joint);
        case Quantity::moment_a:
            return row(joint.moment_in_joint);
        case Quantity::drive:
            return {joint.drive_turn + joint.drive_slide};  // one at most is not 0
        case Quantity::friction:
            return {joint.friction};
        default:
            assert(quantity == Quantity::gap);
            return {joint.gap};
    }
}

double HistoryPoint::spring_value(Quantity quantity, const Snapshot& snapshot) const {
    const SpringValues& values = snapshot.springs[static_cast<std::size_t>(spring_)];
    return quantity == Quantity::elongation ? values.elongation : values.axial_force;
}

Vec3 HistoryPoint::bushing_value(Quantity quantity, const Snapshot& snapshot) const {
    const BushingValues& values = snapshot.bushings[static_cast<std::size_t>(bushing_)];
    switch (quantity) {
        case Quantity::displacement:
            return values.displacement;
        case Quantity::rotation_vector:
            return values.turn;
        case Quantity::force:
            return values.force;
        case Quantity::moment:
            return values.moment;
        case Quantity::force_spatial:
            return values.axes * values.force;
        default:
            assert(quantity == Quantity::moment_spatial);
            return values.axes * values.moment;
    }
}

HistoryPoint::Row HistoryPoint::compute(Quantity quantity, const Snapshot& snapshot) {
    if (bushing_ >= 0) return row(bushing_value(quantity, snapshot));
    if (spring_ >= 0) return {spring_value(quantity, snapshot)};
    if (tendon_ >= 0) {
        const TendonValues& tendon = snapshot.tendons[static_cast<std::size_t>(tendon_)];
        if (quantity == Quantity::tendon_length) return {tendon.length};
        return {quantity == Quantity::tendon_tension ? tendon.tension : tendon.end_tension};
    }
    const bool is_contact = quantity == Quantity::contact_force || quantity == Quantity::contact_friction ||
                            quantity == Quantity::least_gap;
    if (is_contact && (obstacle_ >= 0 || contact_ >= 0)) {
        const ObstacleValues& values = obstacle_ >= 0
                                           ? snapshot.obstacles[static_cast<std::size_t>(obstacle_)]
                                           : snapshot.watched_contacts[static_cast<std::size_t>(contact_)];
        if (quantity == Quantity::least_gap) return {values.least_gap};
        return row(quantity == Quantity::contact_force ? values.force : values.friction);
    }
    if (joint_ >= 0) return joint_value(quantity, snapshot.joints[static_cast<std::size_t>(joint_)]);
    const Seen seen = see_from_reference(snapshot);
    const NodeMotion& node = seen.motion;
    const Quat axes = node.Lambda * seen.start_axes;
    const Quat rotation = body_ ? axes : node.Lambda;
    switch (quantity) {
        case Quantity::position:
            return row(node.r);
        case Quantity::displacement:
            return row(node.r - seen.start);
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
            return row(section_value(quantity, snapshot, axes));
        case Quantity::reaction_force:
            return row(snapshot.reactions[static_cast<std::size_t>(node_)].head<3>());
        case Quantity::reaction_moment:
            return row(reaction_moment(snapshot));
        case Quantity::effective_tension:
        case Quantity::wall_tension:
        case Quantity::water_velocity:
        case Quantity::wet_fraction:
        case Quantity::fluid_force:
        case Quantity::bed_force:
            return surrounding_value(quantity, snapshot);
        case Quantity::elongation:
        case Quantity::axial_force:
        case Quantity::angle:
        case Quantity::angle_rate:
        case Quantity::slide:
        case Quantity::slide_rate:
        case Quantity::force_a:
        case Quantity::moment_a:
        case Quantity::drive:
        case Quantity::friction:
        case Quantity::gap:
        case Quantity::tendon_length:
        case Quantity::tendon_tension:
        case Quantity::tendon_end_tension:
        case Quantity::contact_force:
        case Quantity::contact_friction:
        case Quantity::least_gap:
            break;  // of springs, joints and tendons only
    }
    assert(false);
    return {};
}

}  // namespace gxrod
