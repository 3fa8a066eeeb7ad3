#include <algorithm>

#include "assembly/contact/contact_assembly.hpp"
#include "rotation/rotation_map.hpp"

// The rates of gaps, where contact acts at the stages of a scheme: what damps, and the power of contact.
namespace gxrod {

void ContactAssembly::set_rates_of_obstacles(const State& state, double time, At& at) const {
    const double elapsed = time - state.time;
    if (!moves_ || !(elapsed > 0.0)) return;
    const StepDifferences differences = compute_step_differences(time, {state.time, elapsed});
    at.difference_weights = differences.first;
    if (!numbers_.empty())
        at.weights_before = compute_step_differences(state.time, {state.time, elapsed}).first;
    at.around.resize(surfaces_.size());
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        if (!surfaces_[i].body->motion) continue;
        for (std::size_t k = 0; k < differences.times.size(); ++k)
            at.around[i][k] = place_obstacle(*surfaces_[i].body, differences.times[k]);
    }
}

Vec3 ContactAssembly::surface_velocity(const At& at, std::size_t obstacle, const Vec3& point) const {
    Vec3 velocity = Vec3::Zero();
    if (at.around.empty() || !surfaces_[obstacle].body->motion) return velocity;
    const Vec3 start = at.now[obstacle].to_start(point);
    for (std::size_t k = 0; k < at.difference_weights.size(); ++k)
        velocity += at.difference_weights[k] * (at.around[obstacle][k].from_start(start) - point);
    return velocity;
}

Vec3 ContactAssembly::surface_velocity(const At& at,
                                       std::size_t obstacle,
                                       std::size_t place,
                                       const SurfaceTouch& touch,
                                       const State& state) const {
    const Vec3 position = places_.position(places_.places[place], state.trial);
    const double distance = touch.gap + places_.element_of(place).radius;
    return surface_velocity(at, obstacle, position - distance * touch.normal);
}

// With ∇g = |∇g| n and ∇∇g = H: ġ = ∇g · v of the velocity v of the place past the surface.
ContactAssembly::GapRate ContactAssembly::find_gap_rate(const At& at,
                                                        std::size_t obstacle,
                                                        std::size_t place,
                                                        const SurfaceTouch& touch,
                                                        const State& state) const {
    const Vec3 velocity = places_.velocity(places_.places[place], state.trial) -
                          surface_velocity(at, obstacle, place, touch, state);
    GapRate gap;
    gap.rate = touch.slope * touch.normal.dot(velocity);
    gap.by_position = touch.curvature * velocity;
    gap.damping = numbers_.empty() ? at.rate_damping : damping_time(at, obstacle, place, state);
    gap.factor = std::max(1.0 - gap.damping * gap.rate, 0.0);
    return gap;
}

NormalForce ContactAssembly::damp_by_rate(const At& at,
                                          std::size_t obstacle,
                                          std::size_t place,
                                          const SurfaceTouch& touch,
                                          const State& state,
                                          const NormalForce& normal) const {
    if (!at.damps_rates || (normal.force == 0.0 && normal.stiffness == 0.0)) return normal;
    const double factor = find_gap_rate(at, obstacle, place, touch, state).factor;
    return {factor * normal.force, factor * normal.stiffness};
}

// Of the force λ (1 − τ ġ): −λ τ δġ along what λ gives force and moment.
void ContactAssembly::add_rate_tangent(const At& at,
                                       std::size_t obstacle,
                                       std::size_t place,
                                       const SurfaceTouch& surface,
                                       const State& state,
                                       double weight,
                                       const std::vector<NodeLinearization>& linearizations,
                                       LoadMatrix& tangent) const {
    const GapRate gap = find_gap_rate(at, obstacle, place, surface, state);
    if (gap.factor == 0.0) return;
    const bool is_mixed = state.contact.has_parameters;
    const double undamped = (is_mixed ? tangent_force(at, obstacle, place, surface.gap, state)
                                      : law_force(at, obstacle, place, surface.gap, state))
                                .force;
    const ContactPlace& own = places_.places[place];
    const ContactElement& element = places_.element_of(place);
    const CoulombFriction rubs =
        is_mixed ? tangent_friction(obstacle, place, state) : friction(obstacle, place, state);
    const NormalForce normal{gap.factor * undamped, 0.0};
    const PlaceForce there = compute_place_force(surface, places_.motion_of(own, state), normal, rubs);
    Vec6 by_force;
    by_force << surface.slope * surface.normal, Vec3::Zero();
    if (there.slides && normal.force != 0.0) {
        by_force.head<3>() += there.traction / normal.force;
        by_force.tail<3>() += there.moment / normal.force;
        if (rubs.shape != nullptr) {
            const Vec3 rubbing =
                compute_traction_by_force(surface, places_.motion_of(own, state), normal, rubs);
            by_force.head<3>() = surface.slope * surface.normal + rubbing;
            by_force.tail<3>() = -element.radius * surface.normal.cross(rubbing);
        }
    }
    const Vec3 arm = element.is_body ? places_.arm(own, state.trial) : Vec3(Vec3::Zero());
    by_force.tail<3>() += arm.cross(by_force.head<3>());
    const Vec3 along = surface.slope * surface.normal;
    for (int j = 0; j < element.count; ++j) {
        const auto node = static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(j)]);
        const NodeLinearization& one = linearizations[node];
        const double share = own.shapes[static_cast<std::size_t>(j)];
        Vec6 rate_by;
        rate_by << share * (one.rate * along + one.placement * gap.by_position), Vec3::Zero();
        if (element.is_body) {
            // v + ω × a of the arm a, which turns by δφ × a.
            const Vec3& omega = state.trial[node].omega;
            const Mat3 turn = -spin(arm) * one.d_omega - one.placement * spin(omega) * spin(arm);
            rate_by.tail<3>() =
                turn.transpose() * along - one.placement * spin(arm).transpose() * gap.by_position;
        }
        const double part = weight * own.weight * undamped * gap.damping;
        for (int i = 0; i < element.count; ++i)
            tangent.block<6, 6>(6 * i, 6 * j) +=
                part * own.shapes[static_cast<std::size_t>(i)] * by_force * rate_by.transpose();
    }
}

ContactPower ContactAssembly::compute_power(const State& state, double time) const {
    ContactPower power;
    if (!resolves_) return power;
    const At at = find_obstacles(state, time, 1.0, Rates::always);
    for (std::size_t p = 0; p < places_.places.size(); ++p) {
        const ContactPlace& place = places_.places[p];
        const Vec3 position = places_.position(place, state.trial);
        for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
            if (is_off(obstacle, p) || is_beyond(at, obstacle, p, position, state)) continue;
            const SurfaceTouch surface = touch(at, obstacle, p, position);
            const NormalForce undamped = law_force(at, obstacle, p, surface.gap, state);
            if (undamped.force == 0.0) continue;
            power.touches = true;
            const GapRate gap = find_gap_rate(at, obstacle, p, surface, state);
            power.damping += place.weight * undamped.force * (1.0 - gap.factor) * gap.rate;
            if (at.around.empty()) continue;
            const PlaceForce there = compute_place_force(surface,
                                                         places_.motion_of(place, state),
                                                         {gap.factor * undamped.force, 0.0},
                                                         friction(obstacle, p, state));
            power.by_obstacles +=
                place.weight * there.force.dot(surface_velocity(at, obstacle, p, surface, state));
        }
    }
    power.damping += pairs_.compute_damping_power(state);
    power.touches = power.touches || pairs_.compute_energy(state) != 0.0;
    return power;
}

}  // namespace gxrod
