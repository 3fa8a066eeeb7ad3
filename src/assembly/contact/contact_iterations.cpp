#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/contact/contact_assembly.hpp"
#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

// What contact does in Newton's iterations: parameters, limits of increments, and what is remembered.
namespace gxrod {
namespace {

void lower_limits(int part, const FreeMotion& free, ContactLimits& limits) {
    double& of_part = limits.of_parts[static_cast<std::size_t>(part)];
    of_part = std::min(of_part, free.fraction);
    limits.least = std::min(limits.least, free.fraction);
    limits.least_gap = std::min(limits.least_gap, free.gap);
}

}  // namespace

// work(obstacle, place, position) for each place that is near; what others remember is forgotten.
template <class Work>
void ContactAssembly::for_each_near(
    const At& at, const State& state, double reach, State& kept, const Work& work) const {
    team_->for_each_range(places_.elements.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t e = first; e < last; ++e) {
            const ContactElement& element = places_.elements[e];
            for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
                const bool far = is_far(at, obstacle, element, state, reach);
                for (std::size_t p = element.first_place; p < element.end_place; ++p) {
                    if (far) {
                        forget_place(obstacle, p, kept);
                    } else {
                        work(obstacle, p, places_.position(places_.places[p], state.trial));
                    }
                }
            }
        }
    });
}

void ContactAssembly::forget_place(std::size_t obstacle, std::size_t place, State& state) const {
    const ContactElement& element = places_.elements[static_cast<std::size_t>(places_.places[place].element)];
    state.contact.parameters[pair(obstacle, place)] = element.law.skin;
    if (rubs_) state.contact.sliding[pair(obstacle, place)].setZero();
}

void ContactAssembly::start(State& state, double time) const {
    pairs_.start(state);
    const At at = find_obstacles(state, time, state.contact.progress);
    state.contact.parameters.resize(pair_count());
    state.contact.sliding.assign(traction_count(), Vec3::Zero());
    state.contact.has_parameters = true;
    for_each_near(at, state, 0.0, state, [&](std::size_t obstacle, std::size_t p, const Vec3& position) {
        if (is_beyond(at, obstacle, p, position, state)) {
            forget_place(obstacle, p, state);
            return;
        }
        const SurfaceTouch surface = touch(at, obstacle, p, position);
        state.contact.parameters[pair(obstacle, p)] = surface.gap;
        if (!rubs_) return;
        Touching touching = touch_by_law(at, obstacle, p, surface, state);
        // What slid at the end of the last step has a traction on the cone, but for rounding.
        constexpr double on_cone = 1.0 - 1e-6;
        touching.friction.coefficient *= on_cone;
        const PlaceMotion motion = places_.motion_of(places_.places[p], state);
        keep_slip(advance_slip(surface, motion, touching.normal, touching.friction), obstacle, p, state);
    });
}

void ContactAssembly::advance(const std::vector<Vec6>& deltas, double time, State& state) const {
    const At at = find_obstacles(state, time, 1.0);
    pairs_.advance(deltas, state);
    double reach = 0.0;
    for (const Vec6& delta : deltas) reach = std::max(reach, delta.head<3>().norm());
    reach *= largest_shape_sum;
    for (auto element = places_.elements.rbegin(); element != places_.elements.rend() && element->is_body;
         ++element)
        reach = std::max(reach, places_.reach(*element, deltas));
    for_each_near(at, state, reach, state, [&](std::size_t obstacle, std::size_t p, const Vec3& position) {
        const ContactPlace& place = places_.places[p];
        const ContactElement& element = places_.elements[static_cast<std::size_t>(place.element)];
        const Vec3 change = places_.change(place, state, deltas);
        if (is_idle(at, obstacle, p, position, state, change.norm())) {
            forget_place(obstacle, p, state);
            return;
        }
        PlaceMotion motion;
        if (rubs_) motion = places_.motion_of(place, state);
        for (int i = 0; rubs_ && i < element.count; ++i) {
            const auto node = static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(i)]);
            motion.rotation += place.shapes[static_cast<std::size_t>(i)] *
                               (tangent_map_inverse(state.trial[node].theta) * deltas[node].tail<3>());
        }
        motion.displacement += change;
        double& parameter = state.contact.parameters[pair(obstacle, p)];
        const SurfaceTouch surface = touch(at, obstacle, p, position);
        const double gap = surface.gap + surface.slope * surface.normal.dot(change);
        const NormalForce normal = tangent_force(at, obstacle, p, gap, state);
        if (surfaces_[obstacle].body->stiffness) {
            parameter = gap;
        } else {
            parameter = find_gap_on_curve(impact_law(at, obstacle, p, state), normal.force, gap);
        }
        if (rubs_)
            keep_slip(advance_slip(surface, motion, normal, tangent_friction(obstacle, p, state)),
                      obstacle,
                      p,
                      state);
    });
}

void ContactAssembly::keep_slip(const CoulombFriction& friction,
                                std::size_t obstacle,
                                std::size_t place,
                                State& state) const {
    state.contact.sliding[pair(obstacle, place)] =
        friction.slip == Slip::slides ? friction.direction : Vec3(Vec3::Zero());
}

// A place of a body moves on a bent line, which leaves its chord by an eighth of its second derivative at
// most: as much of it is taken as keeps that below a quarter of the gap.
FreeMotion ContactAssembly::find_bent_free_motion(std::size_t obstacle,
                                                  const ObstaclePlacement& from,
                                                  const ObstaclePlacement& to,
                                                  std::size_t index,
                                                  const Vec6& increment,
                                                  double skin,
                                                  const State& state) const {
    const ObstacleSurface& surface = surfaces_[obstacle];
    const ContactPlace& place = places_.places[index];
    MeshMemory* const memory = memory_of_place(obstacle, index);
    const double radius = places_.element_of(index).radius;
    const Vec3 position = places_.position(place, state.trial);
    const Vec3 arm = places_.arm(place, state.trial);
    const Vec3 turn = increment.tail<3>();
    const double bend = turn.norm() * turn.cross(arm).norm();
    const double gap = surface.find_free_motion(radius, from, position, from, position, 0.0, memory).gap;
    const double part = bend > 2.0 * gap ? std::sqrt(std::max(2.0 * gap, 0.0) / bend) : 1.0;
    const Vec3 change = part * increment.head<3>() + exp_quaternion(part * turn) * arm - arm;
    const FreeMotion free = surface.find_free_motion(radius + part * part * bend / 8.0,
                                                     from,
                                                     position,
                                                     part < 1.0 ? between(from, to, part) : to,
                                                     position + change,
                                                     skin,
                                                     memory);
    return {part * free.fraction, gap};
}

ContactLimits ContactAssembly::limit(const std::vector<Vec6>& increments,
                                     State& state,
                                     double time,
                                     Approach approach) const {
    const At from = find_obstacles(state, time, state.contact.progress);
    const At to = find_obstacles(state, time, 1.0);
    // Impacts that keep their energy leave the skin in one step.
    const bool is_careful = approach == Approach::prediction && model_->contact.dissipation == 1.0;
    ContactLimits limits;
    limits.of_parts.assign(groups_->part_count(), 1.0);
    std::vector<double> of_elements(places_.elements.size(), 1.0);
    std::vector<double> gaps(places_.elements.size(), std::numeric_limits<double>::infinity());
    team_->for_each_range(of_elements.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t e = first; e < last; ++e) {
            const ContactElement& element = places_.elements[e];
            const double reach = places_.reach(element, increments);
            const auto is_clear = [&](std::size_t obstacle) {
                return !surfaces_[obstacle].body->motion && is_far(from, obstacle, element, state, reach);
            };
            std::vector<std::size_t> near;
            for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
                if (!surfaces_[obstacle].body->stiffness && !is_element_off(obstacle, element) &&
                    !is_clear(obstacle))
                    near.push_back(obstacle);
            }
            if (near.empty()) continue;
            for (std::size_t p = element.first_place; p < element.end_place; ++p) {
                const ContactPlace& place = places_.places[p];
                const Vec3 position = places_.position(place, state.trial);
                const Vec3 change = places_.change(place, state, increments);
                const bool is_bent = element.is_body && !place.arm.isZero(0.0);
                const double skin = is_careful ? element.law.skin : 0.0;
                for (const std::size_t obstacle : near) {
                    const ObstaclePlacement &start = from.now[obstacle], &end = to.now[obstacle];
                    const FreeMotion free =
                        is_bent
                            ? find_bent_free_motion(obstacle,
                                                    start,
                                                    end,
                                                    p,
                                                    increments[static_cast<std::size_t>(element.nodes[0])],
                                                    skin,
                                                    state)
                            : surfaces_[obstacle].find_free_motion(element.radius,
                                                                   start,
                                                                   position,
                                                                   end,
                                                                   position + change,
                                                                   skin,
                                                                   memory_of_place(obstacle, p));
                    of_elements[e] = std::min(of_elements[e],
                                              keep_from_rounding(free.fraction, element.law.skin, free.gap));
                    gaps[e] = std::min(gaps[e], free.gap);
                }
            }
        }
    });
    for (std::size_t e = 0; e < of_elements.size(); ++e)
        lower_limits(places_.elements[e].part, {of_elements[e], gaps[e]}, limits);
    if (!pairs_.empty()) pairs_.limit(increments, state, approach, limits);
    // Obstacles that still have to move go as far as all.
    if (moves_ && state.contact.progress < 1.0) std::ranges::fill(limits.of_parts, limits.least);
    return limits;
}

void ContactAssembly::commit(State& state, double time) const {
    state.contact.has_parameters = false;
    pairs_.commit(state);
    if (!rubs_ && numbers_.empty()) return;
    const At at = find_obstacles(state, time, 1.0);
    if (rubs_) keep_tractions(at, state);
    // What rubs depends on those of the step before.
    if (!numbers_.empty()) keep_speeds(at, state);
}

void ContactAssembly::keep_tractions(const At& at, State& state) const {
    team_->for_each_range(places_.places.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t p = first; p < last; ++p) {
            const ContactPlace& place = places_.places[p];
            const Vec3 position = places_.position(place, state.trial);
            for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
                if (is_off(obstacle, p)) continue;
                Eigen::Map<Vec3> traction(memory_.piece(pair(obstacle, p), 3).of(state).data());
                if (is_beyond(at, obstacle, p, position, state)) {
                    traction.setZero();
                    continue;
                }
                const SurfaceTouch surface = touch(at, obstacle, p, position);
                const Touching touching = touch_by_law(at, obstacle, p, surface, state);
                traction = compute_place_force(
                               surface, places_.motion_of(place, state), touching.normal, touching.friction)
                               .traction;
            }
        }
    });
}

}  // namespace gxrod
