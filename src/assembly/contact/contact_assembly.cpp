#include "assembly/contact/contact_assembly.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

#include "assembly/scatter.hpp"
#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

ContactAssembly::ContactAssembly(const Model& model,
                                 const ThreadTeam& team,
                                 const ScaleGroups& groups,
                                 bool is_for_small_motions)
    : model_(&model),
      team_(&team),
      groups_(&groups),
      surfaces_(list_surfaces(model.contact.obstacles)),
      pairs_(model, team, groups, is_for_small_motions),
      has_impacts_(model.has_inertia && model.has_time && !is_for_small_motions),
      is_for_small_motions_(is_for_small_motions) {
    if (surfaces_.empty()) return;
    places_ = find_contact_places(model);
    for (ContactElement& element : places_.elements) element.part = groups.part_of_node(element.nodes[0]);
    for (const Obstacle& obstacle : model.contact.obstacles) {
        rubs_ = rubs_ || obstacle.friction > 0.0;
        moves_ = moves_ || obstacle.motion.has_value();
    }
    if (!model.contact.exceptions.empty()) find_exceptions();
    find_restitutions();
    make_memories();
}

void ContactAssembly::make_memories() {
    if (std::ranges::none_of(surfaces_, [](const ObstacleSurface& one) { return one.mesh != nullptr; }))
        return;
    place_memories_.resize(pair_count());
    element_memories_.resize(surfaces_.size() * places_.elements.size());
    for (std::size_t surface = 0; surface < surfaces_.size(); ++surface) {
        for (std::size_t p = 0; p < places_.places.size(); ++p) {
            const ContactElement& element = places_.element_of(p);
            place_memories_[pair(surface, p)].range = element.radius + element.law.skin;
        }
    }
}

void ContactAssembly::resolve() {
    resolves_ = has_impacts_;
    has_impacts_ = false;
    pairs_.resolve();
}

void ContactAssembly::find_exceptions() {
    const ContactExceptions exceptions(model_->contact, places_);
    rubs_ = false;
    for (const ObstacleSurface& surface : surfaces_) {
        for (std::size_t e = 0; e < places_.elements.size(); ++e) {
            const ContactException* own = exceptions.find_at_obstacle(e, surface.obstacle);
            off_.push_back(own != nullptr && own->is_off ? 1 : 0);
            const bool is_own = own != nullptr && own->friction;
            coefficients_.push_back(is_own ? *own->friction : surface.body->friction);
            friction_shapes_.push_back(is_own ? &own->friction_shape : &surface.body->friction_shape);
            rubs_ = rubs_ || (off_.back() == 0 && coefficients_.back() > 0.0);
        }
    }
}

void ContactAssembly::lay_out(const Layout& layout) {
    equations_ = &layout.equations;
    pattern_ = &layout.pattern;
    memory_ = {layout.first_memory, memory_count()};
    pairs_.set_memory({memory_.end() - pairs_.memory_count(), pairs_.memory_count()});
    for (ContactElement& element : places_.elements) {
        const std::span<const int> nodes(element.nodes.data(), static_cast<std::size_t>(element.count));
        element.slots.resize(36 * nodes.size() * nodes.size());
        find_slots(nodes, layout.equations, layout.pattern, element.slots);
    }
}

ContactAssembly::At ContactAssembly::find_obstacles(const State& state,
                                                    double time,
                                                    double progress,
                                                    Rates rates) const {
    At at;
    at.has_impacts = has_impacts_;
    at.elapsed = time - state.time;
    if (at.has_impacts && at.elapsed > 0.0) at.damping = model_->contact.damping / at.elapsed;
    at.now.resize(surfaces_.size());
    at.before.resize(surfaces_.size());
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        const Obstacle& body = *surfaces_[i].body;
        if (!body.motion) continue;
        at.before[i] = place_obstacle(body, state.time);
        at.now[i] = between(at.before[i], place_obstacle(body, time), progress);
    }
    if (resolves_) at.rate_damping = model_->contact.damping;
    at.damps_rates = resolves_ && damps();
    if (at.damps_rates || !numbers_.empty() || (resolves_ && rates == Rates::always))
        set_rates_of_obstacles(state, time, at);
    return at;
}

bool ContactAssembly::is_far(const At& at,
                             std::size_t obstacle,
                             const ContactElement& element,
                             const State& state,
                             double reach) const {
    if (is_element_off(obstacle, element)) return true;
    // What an impact gives back acts in the step that leaves the obstacle too, however far that goes.
    const bool gives_back = at.has_impacts && model_->contact.dissipation < 1.0;
    return is_far(at.now[obstacle], obstacle, element, state.trial, reach) &&
           (!gives_back || is_far(at.before[obstacle], obstacle, element, state.previous, reach));
}

bool ContactAssembly::is_far(const ObstaclePlacement& placement,
                             std::size_t obstacle,
                             const ContactElement& element,
                             const std::vector<NodeMotion>& motions,
                             double reach) const {
    const auto position = [&](int i) -> const Vec3& {
        return motions[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(i)])].r;
    };
    if (element.is_body) {
        const Vec3 start = places_.position(places_.places[element.first_place], motions);
        const Vec3 end = places_.position(places_.places[element.end_place - 1], motions);
        return surfaces_[obstacle].is_further(
            placement,
            0.5 * (start + end),
            0.5 * (end - start).norm() + element.radius + element.law.skin + reach,
            memory_of_element(obstacle, element));
    }
    const Vec3 centre = 0.5 * (position(0) + position(element.count - 1));
    double extent = 0.0;
    for (int i = 0; i < element.count; ++i) extent = std::max(extent, (position(i) - centre).norm());
    return surfaces_[obstacle].is_further(
        placement,
        centre,
        largest_shape_sum * extent + element.radius + element.law.skin + reach,
        memory_of_element(obstacle, element));
}

bool ContactAssembly::is_beyond_at(const ObstaclePlacement& placement,
                                   std::size_t obstacle,
                                   std::size_t place,
                                   const Vec3& position,
                                   double reach) const {
    const ContactElement& element = places_.element_of(place);
    return surfaces_[obstacle].is_further(
        placement, position, element.radius + element.law.skin + reach, memory_of_place(obstacle, place));
}

bool ContactAssembly::is_beyond(const At& at,
                                std::size_t obstacle,
                                std::size_t place,
                                const Vec3& position,
                                const State& state,
                                double reach) const {
    if (!surfaces_[obstacle].mesh) return false;
    if (!is_beyond_at(at.now[obstacle], obstacle, place, position, reach)) return false;
    // As in is_far.
    const bool gives_back = at.has_impacts && model_->contact.dissipation < 1.0;
    return !gives_back || is_beyond_at(at.before[obstacle],
                                       obstacle,
                                       place,
                                       places_.position(places_.places[place], state.previous),
                                       reach);
}

bool ContactAssembly::is_idle(const At& at,
                              std::size_t obstacle,
                              std::size_t place,
                              const Vec3& position,
                              const State& state,
                              double reach) const {
    if (!surfaces_[obstacle].mesh) return false;
    if (state.contact.has_parameters &&
        state.contact.parameters[pair(obstacle, place)] < places_.element_of(place).law.skin)
        return false;
    return is_beyond(at, obstacle, place, position, state, reach);
}

bool ContactAssembly::has_greater_gap(const At& at,
                                      std::size_t obstacle,
                                      std::size_t place,
                                      const Vec3& position,
                                      const State& state,
                                      double gap) const {
    return is_beyond(
        at, obstacle, place, position, state, std::max(gap - places_.element_of(place).law.skin, 0.0));
}

SurfaceTouch ContactAssembly::touch(const At& at,
                                    std::size_t obstacle,
                                    std::size_t place,
                                    const Vec3& position) const {
    const ContactElement& element = places_.elements[static_cast<std::size_t>(places_.places[place].element)];
    const ObstacleDistance found = surfaces_[obstacle].find_distance(
        at.now[obstacle], position, element.radius, element.law.skin, memory_of_place(obstacle, place));
    SurfaceTouch result{
        found.distance - element.radius, found.normal, found.curvature, Vec3::Zero(), found.slope};
    if (surfaces_[obstacle].body->motion) {
        const Vec3 surface = position - found.distance * found.normal;
        result.drift = surface - at.before[obstacle].from_start(at.now[obstacle].to_start(surface));
    }
    return result;
}

ObstacleDistance ContactAssembly::distance_before(const At& at,
                                                  std::size_t obstacle,
                                                  std::size_t place,
                                                  const State& state) const {
    const Vec3 position = places_.position(places_.places[place], state.previous);
    const ContactElement& element = places_.element_of(place);
    return surfaces_[obstacle].find_distance(
        at.before[obstacle], position, element.radius, element.law.skin, memory_of_place(obstacle, place));
}

double ContactAssembly::gap_before(const At& at,
                                   std::size_t obstacle,
                                   std::size_t place,
                                   const State& state) const {
    return distance_before(at, obstacle, place, state).distance - places_.element_of(place).radius;
}

// Planes that stay have one normal. Meshes that move take that at the end, and so does what turns by a right
// angle.
ImpulseDirection ContactAssembly::impulse_direction(const At& at,
                                                    std::size_t obstacle,
                                                    std::size_t place,
                                                    const SurfaceTouch& touch,
                                                    const State& state) const {
    const ObstacleSurface& surface = surfaces_[obstacle];
    const bool stays = surface.body->plane() != nullptr && !surface.body->motion;
    if (!at.has_impacts || stays || (surface.mesh && surface.body->motion)) return {};
    const ObstacleDistance before = distance_before(at, obstacle, place, state);
    if (surface.body->motion) return {before.normal};
    constexpr double shortest = 1e-3;  // of radii
    const ContactPlace& own = places_.places[place];
    const double radius = places_.element_of(place).radius;
    const ImpulseDirection::Way way{
        before.slope * before.normal,
        places_.position(own, state.trial) - places_.position(own, state.previous),
        touch.gap + radius - before.distance,
        shortest * radius};
    return {surface.mesh ? std::nullopt : std::optional(before.normal), way};
}

CoulombFriction ContactAssembly::friction(std::size_t obstacle, std::size_t place, const State& state) const {
    const ContactElement& element = places_.element_of(place);
    const double coefficient =
        coefficients_.empty() ? surfaces_[obstacle].body->friction
                              : coefficients_[obstacle * places_.elements.size() + places_.index_of(element)];
    if (coefficient == 0.0) return {};
    CoulombFriction result{coefficient,
                           element.law.stiffness / element.law.skin,
                           Vec3(memory_.piece(pair(obstacle, place), 3).of(state).data())};
    result.shape = find_friction_shape(obstacle, element);
    if (result.shape == nullptr) return result;
    if (result.shape->is_directed() && !element.is_body)
        result.axes[0] = places_.tangent(places_.places[place], state.trial).normalized();
    if (has_impacts_ || resolves_) result.elapsed = state.trial_time - state.time;
    return result;
}

const FrictionShape* ContactAssembly::find_friction_shape(std::size_t obstacle,
                                                          const ContactElement& element) const {
    const FrictionShape* shape =
        friction_shapes_.empty()
            ? &surfaces_[obstacle].body->friction_shape
            : friction_shapes_[obstacle * places_.elements.size() + places_.index_of(element)];
    return shape->is_plain() ? nullptr : shape;
}

// As the state's parameters take it for granted.
CoulombFriction ContactAssembly::tangent_friction(std::size_t obstacle,
                                                  std::size_t place,
                                                  const State& state) const {
    CoulombFriction taken = friction(obstacle, place, state);
    if (taken.coefficient == 0.0) return taken;
    taken.direction = state.contact.sliding[pair(obstacle, place)];
    taken.slip = taken.direction.isZero(0.0) ? Slip::sticks : Slip::slides;
    return taken;
}

ImpactLaw ContactAssembly::impact_law(const At& at,
                                      std::size_t obstacle,
                                      std::size_t place,
                                      const State& state) const {
    ImpactLaw law{places_.element_of(place).law, at.has_impacts ? model_->contact.dissipation : 1.0};
    law.damping = impulse_damping(at, obstacle, place, state);
    if (law.dissipation < 1.0 || law.damping > 0.0) law.gap_before = gap_before(at, obstacle, place, state);
    return law;
}

NormalForce ContactAssembly::law_force(
    const At& at, std::size_t obstacle, std::size_t place, double gap, const State& state) const {
    if (const std::optional<double>& stiffness = surfaces_[obstacle].body->stiffness) {
        if (gap >= 0.0) return {};
        const NormalForce normal{-*stiffness * gap, *stiffness};
        const double damping = impulse_damping(at, obstacle, place, state);
        return damping == 0.0 ? normal : damp(normal, damping, gap, gap_before(at, obstacle, place, state));
    }
    const double dissipation = at.has_impacts ? model_->contact.dissipation : 1.0;
    if (dissipation == 1.0 && gap >= places_.element_of(place).law.skin) return {};
    return compute_impact_force(impact_law(at, obstacle, place, state), gap);
}

// λ and D of the point of the curve that the state's parameter names, continued to the gap.
NormalForce ContactAssembly::tangent_force(
    const At& at, std::size_t obstacle, std::size_t place, double gap, const State& state) const {
    const double on_curve = state.contact.parameters[pair(obstacle, place)];
    NormalForce normal = law_force(at, obstacle, place, on_curve, state);
    normal.force -= normal.stiffness * (gap - on_curve);
    return normal;
}

ContactAssembly::Touching ContactAssembly::touch_by_law(const At& at,
                                                        std::size_t obstacle,
                                                        std::size_t place,
                                                        const SurfaceTouch& touch,
                                                        const State& state) const {
    const NormalForce normal = law_force(at, obstacle, place, touch.gap, state);
    return {damp_by_rate(at, obstacle, place, touch, state, normal), friction(obstacle, place, state)};
}

ContactAssembly::Touching ContactAssembly::touch_by_parameters(const At& at,
                                                               std::size_t obstacle,
                                                               std::size_t place,
                                                               const SurfaceTouch& touch,
                                                               const State& state) const {
    const NormalForce normal = tangent_force(at, obstacle, place, touch.gap, state);
    return {damp_by_rate(at, obstacle, place, touch, state, normal),
            tangent_friction(obstacle, place, state)};
}

// From force and moment at a place of a body, and their derivative by the place and its rotation, to the
// derivative of those at the node, by the node.
Mat6 ContactAssembly::take_to_node(
    const At& at, const ContactPlace& place, const State& state, const Vec3& force, Mat6 derivative) const {
    const Mat3 arm = spin(places_.arm(place, state.trial));
    derivative.rightCols<3>() -= derivative.leftCols<3>() * arm;
    derivative.bottomRows<3>() += spin(places_.lever(place, state, at.has_impacts)) * derivative.topRows<3>();
    derivative.bottomRightCorner<3, 3>() += (at.has_impacts ? 0.5 : 1.0) * spin(force) * arm;
    return derivative;
}

// find(obstacle, place, surface): what touches there.
template <class Find>
void ContactAssembly::add_element_force(
    std::size_t index, const At& at, const State& state, const Find& find, LoadVector& force) const {
    const ContactElement& element = places_.elements[index];
    for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
        if (is_far(at, obstacle, element, state)) continue;
        for (std::size_t p = element.first_place; p < element.end_place; ++p) {
            const ContactPlace& place = places_.places[p];
            const Vec3 position = places_.position(place, state.trial);
            if (is_idle(at, obstacle, p, position, state)) continue;
            const SurfaceTouch surface = touch(at, obstacle, p, position);
            const Touching touching = find(obstacle, p, surface);
            if (touching.normal.force == 0.0) continue;
            PlaceForce there = compute_place_force(
                surface, places_.motion_of(place, state), touching.normal, touching.friction);
            impulse_direction(at, obstacle, p, surface, state).add_to(surface, touching.normal, there);
            Vec3 moment = there.moment;
            if (element.is_body) moment += places_.lever(place, state, at.has_impacts).cross(there.force);
            if (force.size() == 0) force = LoadVector::Zero(6 * element.count);
            for (int i = 0; i < element.count; ++i) {
                const double share = place.weight * place.shapes[static_cast<std::size_t>(i)];
                force.segment<3>(6 * i) += share * there.force;
                force.segment<3>(6 * i + 3) += share * moment;
            }
        }
    }
}

// Empty where nothing touches.
template <class Find>
std::vector<LoadVector> ContactAssembly::compute_element_forces(const At& at,
                                                                const State& state,
                                                                const Find& find) const {
    std::vector<LoadVector> forces(places_.elements.size());
    team_->for_each_range(forces.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t e = first; e < last; ++e) add_element_force(e, at, state, find, forces[e]);
    });
    return forces;
}

void ContactAssembly::subtract_forces(const State& state,
                                      double time,
                                      const ConstraintRequest& request,
                                      Residual& residual) const {
    const double weight = request.contact_weight;
    if (weight == 0.0) return;
    pairs_.subtract_forces(state, weight, residual);
    const At at = find_obstacles(state, time, state.contact.progress);
    const auto find = [&](std::size_t obstacle, std::size_t place, const SurfaceTouch& surface) {
        return touch_by_law(at, obstacle, place, surface, state);
    };
    const std::vector<LoadVector> forces = compute_element_forces(at, state, find);
    for (std::size_t e = 0; e < forces.size(); ++e) {
        if (forces[e].size() == 0) continue;
        const ContactElement& element = places_.elements[e];
        for (int i = 0; i < element.count; ++i) {
            const int node = element.nodes[static_cast<std::size_t>(i)];
            const Vec6 force = weight * forces[e].segment<6>(6 * i);
            residual.raise_group(groups_->of_node(node), force);
            residual.nodal[static_cast<std::size_t>(node)] -= force;
        }
    }
}

void ContactAssembly::replace_by_tangent_forces(const State& state,
                                                double time,
                                                double weight,
                                                Residual& residual) const {
    if (weight == 0.0) return;
    pairs_.replace_by_tangent_forces(state, weight, residual);
    const At now = find_obstacles(state, time, state.contact.progress);
    const At there = find_obstacles(state, time, 1.0);
    const auto true_force = [&](std::size_t obstacle, std::size_t place, const SurfaceTouch& surface) {
        return touch_by_law(now, obstacle, place, surface, state);
    };
    const auto tangent = [&](std::size_t obstacle, std::size_t place, const SurfaceTouch& surface) {
        return touch_by_parameters(there, obstacle, place, surface, state);
    };
    const std::vector<LoadVector> taken = compute_element_forces(now, state, true_force);
    const std::vector<LoadVector> given = compute_element_forces(there, state, tangent);
    for (std::size_t e = 0; e < taken.size(); ++e) {
        const ContactElement& element = places_.elements[e];
        for (int i = 0; i < element.count; ++i) {
            Vec6& nodal =
                residual.nodal[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(i)])];
            if (taken[e].size() > 0) nodal += weight * taken[e].segment<6>(6 * i);
            if (given[e].size() > 0) nodal -= weight * given[e].segment<6>(6 * i);
        }
    }
}

void ContactAssembly::add_tangents(const State& state,
                                   double time,
                                   const ConstraintRequest& request,
                                   const std::vector<NodeLinearization>& linearizations,
                                   std::vector<double>& values) const {
    const double weight = request.contact_weight;
    if (weight == 0.0) return;
    if (is_for_small_motions_) add_pair_tangents(state, weight, linearizations, values);
    // Other stages of a step move nothing here, but what damps depends on them.
    const bool is_still = !linearizations.empty() && linearizations.front().placement == 0.0;
    if (is_still && (!resolves_ || !damps())) return;
    const bool is_mixed = state.contact.has_parameters;
    const At at = find_obstacles(state, time, is_mixed ? 1.0 : state.contact.progress);
    for (const ContactElement& element : places_.elements) {
        LoadMatrix tangent;
        std::array<Mat3, most_element_nodes> turns;
        for (std::size_t obstacle = 0; obstacle < surfaces_.size(); ++obstacle) {
            if (is_far(at, obstacle, element, state)) continue;
            for (std::size_t p = element.first_place; p < element.end_place; ++p) {
                const ContactPlace& place = places_.places[p];
                const Vec3 position = places_.position(place, state.trial);
                if (is_idle(at, obstacle, p, position, state)) continue;
                const SurfaceTouch surface = touch(at, obstacle, p, position);
                const Touching touching = is_mixed ? touch_by_parameters(at, obstacle, p, surface, state)
                                                   : touch_by_law(at, obstacle, p, surface, state);
                if (touching.normal.force == 0.0 && touching.normal.stiffness == 0.0) continue;
                if (tangent.size() == 0) {
                    tangent = LoadMatrix::Zero(6 * element.count, 6 * element.count);
                    for (int j = 0; j < element.count; ++j)
                        turns[static_cast<std::size_t>(j)] = tangent_map_inverse(
                            state.trial[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(j)])]
                                .theta);
                }
                PlaceForceDerivative there = compute_place_force_derivative(
                    surface, places_.motion_of(place, state), touching.normal, touching.friction);
                const ImpulseDirection direction = impulse_direction(at, obstacle, p, surface, state);
                direction.add_to(surface, touching.normal, there);
                if (at.damps_rates)
                    add_rate_tangent(at, obstacle, p, surface, state, weight, linearizations, tangent);
                if (!touching.friction.axes[0].isZero(0.0))
                    add_axis_tangent(p, there, state, weight * linearizations.front().placement, tangent);
                for (int j = 0; j < element.count; ++j) {
                    const auto node = static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(j)]);
                    const double part = weight * linearizations[node].placement * place.weight *
                                        place.shapes[static_cast<std::size_t>(j)];
                    const Mat3& turn = turns[static_cast<std::size_t>(j)];
                    Mat6 own;
                    own << there.force_by_position, there.force_by_rotation * turn, there.moment_by_position,
                        there.moment_by_rotation * turn;
                    if (element.is_body) {
                        PlaceForce force = compute_place_force(
                            surface, places_.motion_of(place, state), touching.normal, touching.friction);
                        direction.add_to(surface, touching.normal, force);
                        own = take_to_node(at, place, state, force.force, own);
                    }
                    for (int i = 0; i < element.count; ++i)
                        tangent.block<6, 6>(6 * i, 6 * j) -=
                            (part * place.shapes[static_cast<std::size_t>(i)]) * own;
                }
            }
        }
        if (tangent.size() == 0) continue;
        const std::span<const int> nodes(element.nodes.data(), static_cast<std::size_t>(element.count));
        turn_to_own_axes(nodes, *equations_, tangent);
        add_to_values(tangent.data(), element.slots, values);
    }
}

void ContactAssembly::add_axis_tangent(std::size_t place,
                                       const PlaceForceDerivative& there,
                                       const State& state,
                                       double weight,
                                       LoadMatrix& tangent) const {
    const ContactPlace& own = places_.places[place];
    const int count = places_.element_of(place).count;
    const Vec3 along = places_.tangent(own, state.trial);
    const double length = along.norm();
    const Vec3 axis = along / length;
    Eigen::Matrix<double, 6, 3> by_place;
    by_place << there.force_by_axis, there.moment_by_axis;
    by_place *= (weight * own.weight / length) * (Mat3::Identity() - axis * axis.transpose());
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j)
            tangent.block<6, 3>(6 * i, 6 * j) -=
                own.shapes[static_cast<std::size_t>(i)] * own.slopes[static_cast<std::size_t>(j)] * by_place;
    }
}

void ContactAssembly::add_pair_tangents(const State& state,
                                        double weight,
                                        const std::vector<NodeLinearization>& linearizations,
                                        std::vector<double>& values) const {
    std::vector<std::int64_t> slots;
    for (PairBlock& block : pairs_.compute_tangents(state, weight, linearizations)) {
        const std::span<const int> nodes(block.nodes);
        turn_to_own_axes(nodes, *equations_, block.matrix);
        slots.resize(36 * nodes.size() * nodes.size());
        find_slots(nodes, *equations_, *pattern_, slots);
        add_to_values(block.matrix.data(), slots, values);
    }
}

bool ContactAssembly::has_forces(const State& state, double time) const {
    return std::ranges::any_of(compute_forces(state, time),
                               [](const Vec6& force) { return !force.isZero(0.0); });
}

std::vector<Vec6> ContactAssembly::compute_forces(const State& state, double time) const {
    Residual residual;
    residual.nodal.assign(state.trial.size(), Vec6::Zero());
    subtract_forces(state, time, {.contact_weight = -1.0}, residual);
    return residual.nodal;
}

}  // namespace gxrod
