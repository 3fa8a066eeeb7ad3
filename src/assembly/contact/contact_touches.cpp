#include <algorithm>
#include <limits>
#include <map>

#include "assembly/contact/contact_assembly.hpp"

// What touches where, for results.
namespace gxrod {

namespace {

bool comes_before(const ContactTouch& a, const ContactTouch& b) {
    if (a.rods != b.rods) return a.rods < b.rods;
    return a.places < b.places;
}

// Two elements have the node between them in common.
bool is_same_place(const ContactTouch& a, const ContactTouch& b) {
    constexpr double rounding = 1e-12;
    return a.rods == b.rods && a.rods[1] < 0 && std::abs(a.places[0] - b.places[0]) < rounding;
}

void merge(const ContactTouch& more, ContactTouch& touch) {
    touch.normal_force += more.normal_force;
    touch.friction_force += more.friction_force;
    touch.gap = std::min(touch.gap, more.gap);
    touch.slides = touch.slides && more.slides;
}

// Sorted, with one for each place at an obstacle.
std::vector<ContactTouch> merge_same_places(std::vector<ContactTouch> touches) {
    std::ranges::stable_sort(touches, comes_before);
    std::vector<ContactTouch> merged;
    for (const ContactTouch& one : touches) {
        if (!merged.empty() && is_same_place(merged.back(), one)) {
            merge(one, merged.back());
        } else {
            merged.push_back(one);
        }
    }
    return merged;
}

}  // namespace

void ContactAssembly::list_element_touches(std::size_t index,
                                           const At& at,
                                           const State& state,
                                           std::vector<ContactTouch>& touches) const {
    const ContactElement& element = places_.elements[index];
    for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
        if (is_far(at, obstacle, element, state)) continue;
        for (std::size_t p = element.first_place; p < element.end_place; ++p) {
            const ContactPlace& place = places_.places[p];
            const Vec3 position = places_.position(place, state.trial);
            if (is_beyond(at, obstacle, p, position, state)) continue;
            const SurfaceTouch surface = touch(at, obstacle, p, position);
            const Touching touching = touch_by_law(at, obstacle, p, surface, state);
            if (touching.normal.force == 0.0) continue;
            PlaceForce there = compute_place_force(
                surface, places_.motion_of(place, state), touching.normal, touching.friction);
            impulse_direction(at, obstacle, p, surface, state).add_to(surface, touching.normal, there);
            // What slides has a traction on the cone, as far as rounding lets it be.
            constexpr double nearly = 1.0 - 1e-9;
            const double most =
                touching.friction.coefficient * surface.slope * std::max(touching.normal.force, 0.0);
            touches.push_back(
                {{element.rod, -1 - static_cast<int>(surfaces_[obstacle].obstacle)},
                 {std::clamp(place.fraction, 0.0, 1.0), 0.0},
                 position - (element.radius + 0.5 * surface.gap) * surface.normal,
                 place.weight * (there.force - there.traction),
                 place.weight * there.traction,
                 surface.gap,
                 touching.friction.shape != nullptr ? there.slides : there.traction.norm() >= nearly * most});
        }
    }
}

std::vector<ContactTouch> ContactAssembly::list_touches(const State& state, double time) const {
    std::vector<ContactTouch> all, of_bodies;
    if (!surfaces_.empty()) {
        const At at = find_obstacles(state, time, 1.0);
        std::vector<std::vector<ContactTouch>> of_elements(places_.elements.size());
        team_->for_each_range(of_elements.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t e = first; e < last; ++e) list_element_touches(e, at, state, of_elements[e]);
        });
        for (std::size_t e = 0; e < of_elements.size(); ++e) {
            // Places of two shapes of a body are not the same.
            if (places_.elements[e].is_body) {
                const std::vector<ContactTouch> own = merge_same_places(std::move(of_elements[e]));
                of_bodies.insert(of_bodies.end(), own.begin(), own.end());
            } else {
                all.insert(all.end(), of_elements[e].begin(), of_elements[e].end());
            }
        }
    }
    if (!pairs_.empty()) pairs_.add_touches(state, all);
    std::vector<ContactTouch> merged = merge_same_places(std::move(all));
    if (of_bodies.empty()) return merged;
    merged.insert(merged.end(), of_bodies.begin(), of_bodies.end());
    std::ranges::stable_sort(merged, comes_before);
    return merged;
}

double ContactAssembly::find_least_gap(const ContactWatch& watch, const State& state, double time) const {
    double least = std::numeric_limits<double>::infinity();
    if (!pairs_.empty() && watch.other.value_or(0) >= 0) least = pairs_.find_least_gap(watch, state);
    const At at = find_obstacles(state, time, 1.0);
    for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
        const int index = -1 - static_cast<int>(surfaces_[obstacle].obstacle);
        if (watch.other.value_or(index) != index) continue;
        for (const ContactElement& element : places_.elements) {
            if (element.rod != watch.rod || is_element_off(obstacle, element)) continue;
            for (std::size_t p = element.first_place; p < element.end_place; ++p) {
                const Vec3 position = places_.position(places_.places[p], state.trial);
                if (has_greater_gap(at, obstacle, p, position, state, least)) continue;
                least = std::min(least, touch(at, obstacle, p, position).gap);
            }
        }
    }
    return least;
}

std::vector<double> ContactAssembly::compute_gaps(const State& state, double time) const {
    const Contact& contact = model_->contact;
    double largest = 0.0;
    for (const double radius : contact.radii) largest = std::max(largest, radius);
    for (const ContactBody& body : contact.bodies) largest = std::max(largest, body.radius);
    std::vector<double> gaps(state.trial.size(), contact.skin * largest);
    std::map<int, double> of_nodes;  // of shapes of bodies, the largest
    for (const ContactBody& body : contact.bodies) {
        double& own = of_nodes[model_->bodies[static_cast<std::size_t>(body.body)].node];
        own = std::max(own, contact.skin * body.radius);
    }
    for (const auto& [node, skin] : of_nodes) gaps[static_cast<std::size_t>(node)] = skin;
    for (std::size_t rod = 0; rod < contact.radii.size(); ++rod) {
        if (contact.radii[rod] == 0.0) continue;
        for (const int node : model_->rods[rod].nodes)
            gaps[static_cast<std::size_t>(node)] = contact.skin * contact.radii[rod];
    }
    const At at = find_obstacles(state, time, 1.0);
    for (const ContactElement& element : places_.elements) {
        for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
            if (is_far(at, obstacle, element, state)) continue;
            for (std::size_t p = element.first_place; p < element.end_place; ++p) {
                const ContactPlace& place = places_.places[p];
                const Vec3 position = places_.position(place, state.trial);
                double& gap = gaps[static_cast<std::size_t>(places_.nearest_node(place, place, 0.0))];
                if (has_greater_gap(at, obstacle, p, position, state, gap)) continue;
                gap = std::min(gap, touch(at, obstacle, p, position).gap);
            }
        }
    }
    if (!pairs_.empty()) pairs_.lower_gaps(state, gaps);
    return gaps;
}

ObstacleValues ContactAssembly::compute_watched(const ContactWatch& watch,
                                                const std::vector<ContactTouch>& touches,
                                                const State& state,
                                                double time) const {
    ObstacleValues values;
    values.least_gap = watch.wants_gap ? find_least_gap(watch, state, time) : 0.0;
    for (const ContactTouch& one : touches) {
        for (std::size_t side = 0; side < 2; ++side) {
            const int other = one.rods[1 - side];
            if (one.rods[side] != watch.rod || watch.other.value_or(other) != other) continue;
            const double sign = side == 0 ? 1.0 : -1.0;
            values.force += sign * (one.normal_force + one.friction_force);
            values.friction += sign * one.friction_force;
        }
    }
    return values;
}

}  // namespace gxrod
