#include <algorithm>
#include <limits>

#include "assembly/contact/contact_assembly.hpp"

// Energies, work and counts of contact.
namespace gxrod {

double ContactAssembly::compute_energy(const State& state, double time) const {
    const At at = find_obstacles(state, time, 1.0);
    double energy = pairs_.compute_energy(state);
    for (std::size_t p = 0; p < places_.places.size(); ++p) {
        const ContactPlace& place = places_.places[p];
        const ContactLaw& law = places_.elements[static_cast<std::size_t>(place.element)].law;
        const Vec3 position = places_.position(place, state.trial);
        for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
            if (is_off(obstacle, p) || is_beyond(at, obstacle, p, position, state)) continue;
            const SurfaceTouch surface = touch(at, obstacle, p, position);
            const CoulombFriction rubbing = friction(obstacle, p, state);
            if (const std::optional<double>& stiffness = surfaces_[obstacle].body->stiffness) {
                const double depth = std::max(-surface.gap, 0.0);
                energy += 0.5 * place.weight * *stiffness * depth * depth;
            } else if (surface.gap < law.skin) {
                energy += place.weight * compute_contact_energy(law, surface.gap);
            }
            if (rubbing.stiffness > 0.0) {
                const PlaceForce force =
                    compute_place_force(surface,
                                        places_.motion_of(place, state),
                                        touch_by_law(at, obstacle, p, surface, state).normal,
                                        rubbing);
                energy += 0.5 * place.weight * force.traction.squaredNorm() / rubbing.stiffness;
            }
        }
    }
    return energy;
}

ContactWork ContactAssembly::compute_work(const State& state, double time, double energy_before) const {
    const At at = find_obstacles(state, time, 1.0);
    ContactWork work;
    double on_rods = at.has_impacts ? pairs_.compute_work(state) : 0.0;
    double slip_work = at.has_impacts ? 0.0 : pairs_.compute_slip_work(state);
    for (std::size_t p = 0; p < places_.places.size(); ++p) {
        const ContactPlace& place = places_.places[p];
        const Vec3 position = places_.position(place, state.trial);
        const PlaceMotion motion = places_.motion_of(place, state);
        const bool is_body = places_.elements[static_cast<std::size_t>(place.element)].is_body;
        for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
            if (is_off(obstacle, p)) continue;
            if (is_beyond(at, obstacle, p, position, state) &&
                is_beyond_at(at.before[obstacle], obstacle, p, position - motion.displacement, 0.0))
                continue;
            const SurfaceTouch surface = touch(at, obstacle, p, position);
            const Touching touching = touch_by_law(at, obstacle, p, surface, state);
            PlaceForce after = compute_place_force(surface, motion, touching.normal, touching.friction);
            if (touching.normal.force > 0.0)
                impulse_direction(at, obstacle, p, surface, state).add_to(surface, touching.normal, after);
            Vec3 force = after.force;
            if (!at.has_impacts) {
                const double gap = gap_before(at, obstacle, p, state);
                const ContactLaw& law = places_.elements[static_cast<std::size_t>(place.element)].law;
                const ObstacleDistance found =
                    surfaces_[obstacle].find_distance(at.before[obstacle],
                                                      position - motion.displacement,
                                                      motion.radius,
                                                      law.skin,
                                                      memory_of_place(obstacle, p));
                const Vec3 before =
                    law_force(at, obstacle, p, gap, state).force * found.slope * found.normal +
                    touching.friction.traction;
                const Vec3 change = force - before;
                force = 0.5 * (force + before);
                const Vec3 slip = motion.displacement -
                                  motion.radius * motion.rotation.cross(surface.normal) - surface.drift;
                slip_work -= 0.5 * place.weight * (after.traction + touching.friction.traction).dot(slip);
                const Vec3 slipped = after.traction - touching.friction.traction;
                work.uncertainty +=
                    0.5 * place.weight * (std::abs(change.dot(surface.drift)) + std::abs(slipped.dot(slip)));
                const double k = touching.friction.stiffness;
                if (k > 0.0)
                    slip_work -= 0.5 * place.weight / k *
                                 (after.traction.squaredNorm() - touching.friction.traction.squaredNorm());
            }
            on_rods += place.weight * (force.dot(motion.displacement) + after.moment.dot(motion.rotation));
            if (is_body && at.has_impacts) {
                // What impulses do to the node.
                const Vec3 lever = places_.lever(place, state, at.has_impacts);
                const Vec3 turned = places_.arm(place, state.trial) - places_.arm(place, state.previous);
                on_rods += place.weight * force.dot(motion.rotation.cross(lever) - turned);
            }
            if (!resolves_) work.by_obstacles += place.weight * force.dot(surface.drift);
        }
    }
    work.loss = at.has_impacts ? energy_before - compute_energy(state, time) - on_rods + work.by_obstacles
                               : slip_work;
    return work;
}

std::vector<ObstacleValues> ContactAssembly::compute_obstacle_values(const State& state, double time) const {
    const At at = find_obstacles(state, time, 1.0);
    std::vector<ObstacleValues> values(model_->contact.obstacles.size());
    for (ObstacleValues& own : values) own.least_gap = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < places_.places.size(); ++p) {
        const ContactPlace& place = places_.places[p];
        const Vec3 position = places_.position(place, state.trial);
        for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
            if (is_off(obstacle, p)) continue;
            ObstacleValues& own = values[surfaces_[obstacle].obstacle];
            if (has_greater_gap(at, obstacle, p, position, state, own.least_gap)) continue;
            const SurfaceTouch surface = touch(at, obstacle, p, position);
            own.least_gap = std::min(own.least_gap, surface.gap);
            // A start that is refused is written too.
            if (surface.gap <= 0.0 && !surfaces_[obstacle].body->stiffness) continue;
            const NormalForce normal = touch_by_law(at, obstacle, p, surface, state).normal;
            if (normal.force == 0.0) continue;
            PlaceForce force = compute_place_force(
                surface, places_.motion_of(place, state), normal, friction(obstacle, p, state));
            impulse_direction(at, obstacle, p, surface, state).add_to(surface, normal, force);
            own.force -= place.weight * force.force;
            own.friction -= place.weight * force.traction;
        }
    }
    return values;
}

ContactCount ContactAssembly::count(const State& state, double time) const {
    const At at = find_obstacles(state, time, state.contact.progress);
    ContactCount result{0, std::numeric_limits<double>::infinity()};
    for (std::size_t p = 0; p < places_.places.size(); ++p) {
        const ContactLaw& law = places_.elements[static_cast<std::size_t>(places_.places[p].element)].law;
        const Vec3 position = places_.position(places_.places[p], state.trial);
        for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
            if (is_off(obstacle, p) || has_greater_gap(at, obstacle, p, position, state, result.least_gap))
                continue;
            const double gap = touch(at, obstacle, p, position).gap;
            const double range = surfaces_[obstacle].body->stiffness ? 0.0 : law.skin;
            if (gap < range) ++result.touching;
            result.least_gap = std::min(result.least_gap, gap);
        }
    }
    pairs_.count(state, result);
    return result;
}

}  // namespace gxrod
