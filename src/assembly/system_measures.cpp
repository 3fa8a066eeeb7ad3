#include "assembly/system_measures.hpp"

#include <algorithm>

#include "assembly/contact/contact_assembly.hpp"
#include "assembly/surroundings_assembly.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {

namespace {

// The forces of gravity on an element's nodes.
template <Element E>
NodalVector<E::node_count> compute_gravity_force(const E& element,
                                                 const Motions<E::node_count>& motions,
                                                 const Vec3& gravity) {
    std::array<NodeMotion, E::node_count> still;
    Motions<E::node_count> pointers;
    for (int i = 0; i < E::node_count; ++i) {
        still[i].Lambda = motions[i]->Lambda;
        pointers[i] = &still[i];
    }
    NodalVector<E::node_count> force = NodalVector<E::node_count>::Zero();
    element.add_inertial_force(pointers, gravity, force);
    return -force;
}

// Whether the element's internal forces act on the model from outside.
template <class E>
bool leans_on_ground(const E& element) {
    if constexpr (requires { element.leans_on_ground(); }) return element.leans_on_ground();
    return false;
}

// Whether the element takes the logarithm of how its nodes are turned against each other, or against the
// ground.
template <class E>
inline constexpr bool sees_relative_rotation =
    (E::has_section && E::history_count == 0) || requires { requires E::sees_relative_rotation; };

// Adds to `total` what add(e, sum) adds for each element of a block, in an order that no number of threads
// changes.
template <class Sum, class Block, class Add>
void add_up(const ThreadTeam& team, const Block& block, Sum& total, Add&& add) {
    std::vector<Sum> parts(block.phases.part_count(), Sum{});
    team.for_each(parts.size(), [&](std::size_t part) {
        Sum sum{};
        for (std::size_t e = block.phases.first(part); e < block.phases.last(part); ++e) add(e, sum);
        parts[part] = sum;
    });
    for (const Sum& part : parts) total += part;
}

}  // namespace

Balance& Balance::operator+=(const Balance& other) {
    kinetic_energy += other.kinetic_energy;
    strain_energy += other.strain_energy;
    gravity_potential += other.gravity_potential;
    momentum.linear += other.momentum.linear;
    momentum.angular += other.momentum.angular;
    return *this;
}

std::size_t SystemMeasures::count_elements() const {
    const Model& model = system_->model();
    return static_cast<std::size_t>(system_->rod_element_count_) + model.bodies.size() +
           count_element_ties(model);
}

Balance SystemMeasures::compute_balance(const State& state, double time) const {
    const bool has_potential = system_->model_->gravity.is_constant();
    const Vec3 gravity = has_potential ? system_->model_->gravity(time) : Vec3::Zero();
    const Instant now = system_->instant(state, time);
    Balance balance;
    for_each_block(system_->blocks_, [&](const auto& block) {
        add_up(*system_->team_, block, balance, [&](std::size_t e, Balance& sum) {
            const auto& element = block.elements[e];
            const auto motions = block.motions(state.trial, e);
            const Momentum momentum = element.momentum(motions);
            sum.kinetic_energy += element.kinetic_energy(motions);
            sum.strain_energy += element.strain_energy(motions, block.histories(state, e, now));
            sum.gravity_potential += element.gravity_potential(motions, gravity);
            sum.momentum.linear += momentum.linear;
            sum.momentum.angular += momentum.angular;
        });
    });
    balance.strain_energy += system_->joints_.compute_strain_energy(state, time);
    return balance;
}

double SystemMeasures::compute_kinetic_energy(const std::vector<NodeMotion>& motions) const {
    double energy = 0.0;
    for_each_block(system_->blocks_, [&](const auto& block) {
        add_up(*system_->team_, block, energy, [&](std::size_t e, double& sum) {
            sum += block.elements[e].kinetic_energy(block.motions(motions, e));
        });
    });
    return energy;
}

Momentum SystemMeasures::compute_momentum(const std::vector<NodeMotion>& motions) const {
    Balance sums;
    for_each_block(system_->blocks_, [&](const auto& block) {
        add_up(*system_->team_, block, sums, [&](std::size_t e, Balance& sum) {
            const Momentum momentum = block.elements[e].momentum(block.motions(motions, e));
            sum.momentum.linear += momentum.linear;
            sum.momentum.angular += momentum.angular;
        });
    });
    return sums.momentum;
}

std::vector<DrivenPoint> SystemMeasures::list_driven_points(const std::vector<NodeMotion>& motions,
                                                            const State& state,
                                                            double time) const {
    const Instant now = system_->instant(state, time, motions);
    std::vector<DrivenPoint> points;
    for_each_block(system_->blocks_, [&](const auto& block) {
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            const Histories histories = block.histories(state, e, now);
            if (!histories.drives.empty())
                block.elements[e].add_driven_points(block.motions(motions, e), histories, points);
        }
    });
    return points;
}

double SystemMeasures::compute_drive_work(const State& state, double time) const {
    if (!system_->traits().is_driven) return 0.0;
    const std::vector<DrivenPoint> before = list_driven_points(state.previous, state, state.time);
    const std::vector<DrivenPoint> after = list_driven_points(state.trial, state, time);
    double work = 0.0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const DrivenPoint &a = before[i], &b = after[i];
        double of_point = -0.5 * (a.resultants + b.resultants).dot(b.strain - a.strain);
        for (std::size_t k = 0; k < b.pulls.size(); ++k)
            of_point -=
                0.5 * (a.pulls[k].tension + b.pulls[k].tension) * (b.pulls[k].stretch - a.pulls[k].stretch);
        work += b.weight * of_point;
    }
    return work;
}

double SystemMeasures::compute_law_dissipation(const State& state, double time) const {
    double energy = 0.0;
    const Instant now = system_->instant(state, time);
    for_each_block(system_->blocks_, [&](const auto& block) {
        if (!block.has_laws) return;
        add_up(*system_->team_, block, energy, [&](std::size_t e, double& sum) {
            sum += block.elements[e].dissipated_energy(block.motions(state.trial, e),
                                                       block.histories(state, e, now));
        });
    });
    return energy;
}

double SystemMeasures::compute_damping_power(const State& state) const {
    const Instant now = system_->instant(state);
    double power = 0.0;
    for_each_block(system_->blocks_, [&](const auto& block) {
        constexpr int node_count = std::remove_cvref_t<decltype(block)>::node_count;
        if (!block.is_damped) return;
        add_up(*system_->team_, block, power, [&](std::size_t e, double& sum) {
            const auto motions = block.motions(state.trial, e);
            NodalVector<node_count> force = NodalVector<node_count>::Zero();
            block.elements[e].add_damping_force(motions, block.histories(state, e, now), force);
            for (int i = 0; i < node_count; ++i) {
                sum += force.template segment<3>(6 * i).dot(motions[i]->v) +
                       force.template segment<3>(6 * i + 3).dot(motions[i]->omega);
            }
        });
    });
    power += system_->joints_.compute_damping_power(state);
    return std::max(power, 0.0);  // but for round-off it is a sum of squares
}

double SystemMeasures::compute_damping_action(const State& state) const {
    const Instant now = system_->instant(state);
    double action = 0.0;
    for_each_block(system_->blocks_, [&](const auto& block) {
        if (!block.is_damped) return;
        add_up(*system_->team_, block, action, [&](std::size_t e, double& sum) {
            sum += block.elements[e].damping_action(block.motions(state.previous, e),
                                                    block.motions(state.trial, e),
                                                    block.histories(state, e, now));
        });
    });
    return action + system_->joints_.compute_damping_action(state);
}

std::vector<Vec6> SystemMeasures::compute_load_forces(const State& state, double time) const {
    Residual loads;
    loads.nodal.assign(state.trial.size(), Vec6::Zero());
    system_->subtract_loads(state, time, loads);
    std::vector<Vec6> forces = std::move(loads.nodal);
    for (Vec6& force : forces) force = -force;
    if (system_->model_->gravity.is_constant()) return forces;
    const Vec3 gravity = system_->model_->gravity(time);
    for_each_block(system_->blocks_, [&](const auto& block) {
        constexpr int node_count = std::remove_cvref_t<decltype(block)>::node_count;
        block.phases.run(*system_->team_, [&](std::size_t part) {
            for (std::size_t e = block.phases.first(part); e < block.phases.last(part); ++e) {
                const auto& element = block.elements[e];
                add_to_nodes<node_count>(
                    compute_gravity_force(element, block.motions(state.trial, e), gravity),
                    element.nodes,
                    forces);
            }
        });
    });
    return forces;
}

std::vector<Vec6> SystemMeasures::compute_surrounding_forces(const State& state, double time) const {
    if (!system_->surroundings_) return {};
    Residual loads;
    loads.nodal.assign(state.trial.size(), Vec6::Zero());
    system_->surroundings_->subtract_forces(state, time, {}, loads);
    for (Vec6& force : loads.nodal) force = -force;
    return std::move(loads.nodal);
}

void SystemMeasures::add_support_forces(const Residual& residual, std::vector<Vec6>& forces) const {
    for (const Support* support : system_->supports_.moving()) {
        Vec6 exerted = system_->equations_.to_own_axes(support->node, residual.nodal[support->node]);
        for (int i = 0; i < 6; ++i) {
            if (!system_->supports_.held(support->node)[i]) exerted[i] = 0.0;
        }
        forces[support->node] += system_->equations_.to_global_axes(support->node, exerted);
    }
}

void SystemMeasures::add_damping_forces(const State& state, std::vector<Vec6>& nodal) const {
    nodal.resize(state.trial.size(), Vec6::Zero());
    const Instant now = system_->instant(state);
    for_each_block(system_->blocks_, [&]<class E>(const ElementBlock<E>& block) {
        if (!block.is_damped) return;
        block.phases.run(*system_->team_, [&](std::size_t part) {
            if constexpr (is_batched<E>) {
                system_->batches_of(block).add_damping_forces(part, state, now, nodal);
            } else {
                for (std::size_t e = block.phases.first(part); e < block.phases.last(part); ++e) {
                    NodalVector<E::node_count> force = NodalVector<E::node_count>::Zero();
                    block.elements[e].add_damping_force(
                        block.motions(state.trial, e), block.histories(state, e, now), force);
                    add_to_nodes<E::node_count>(force, block.elements[e].nodes, nodal);
                }
            }
        });
    });
    system_->team_->for_each(system_->rotary_damping_batches_.part_count(), [&](std::size_t part) {
        std::vector<ForceScales> unused(system_->rotary_damping_batches_.groups(part).size());
        system_->rotary_damping_batches_.add_forces(part, state.trial, nodal, unused);
    });
}

Resultant SystemMeasures::compute_outer_resultant(const State& state,
                                                  double time,
                                                  std::span<const Vec6> reactions) const {
    Residual loads;
    loads.nodal.assign(state.trial.size(), Vec6::Zero());
    system_->subtract_loads(state, time, loads);
    if (system_->contact_) system_->contact_->subtract_forces(state, time, {}, loads);
    // What acts on the nodes in addition to their inertia: the opposite of what acts on them.
    std::vector<Vec6> asked = std::move(loads.nodal);
    const Vec3 gravity = system_->model_->gravity(time);
    const Instant now = system_->instant(state, time);
    for_each_block(system_->blocks_, [&](const auto& block) {
        constexpr int node_count = std::remove_cvref_t<decltype(block)>::node_count;
        block.phases.run(*system_->team_, [&](std::size_t part) {
            for (std::size_t e = block.phases.first(part); e < block.phases.last(part); ++e) {
                const auto& element = block.elements[e];
                const auto motions = block.motions(state.trial, e);
                NodalVector<node_count> force = -compute_gravity_force(element, motions, gravity);
                if (leans_on_ground(element))
                    element.add_internal_force(motions, block.histories(state, e, now), force);
                add_to_nodes<node_count>(force, element.nodes, asked);
            }
        });
    });
    if (system_->is_damped_) add_damping_forces(state, asked);
    system_->joints_.subtract_ground_forces(state, time, asked);
    Resultant sum;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const Vec6 acting = reactions[i] - asked[i];
        sum.force += acting.head<3>();
        sum.moment += acting.tail<3>() + state.trial[i].r.cross(acting.head<3>());
    }
    return sum;
}

std::vector<Vec6> SystemMeasures::compute_reactions(const Residual& residual) const {
    std::vector<Vec6> reactions(residual.nodal.size(), Vec6::Zero());
    for (const Support& support : system_->model_->supports) {
        Vec6 own = system_->equations_.to_own_axes(support.node, residual.nodal[support.node]);
        for (int i = 0; i < 6; ++i) {
            if (!system_->supports_.held(support.node)[i]) own[i] = 0.0;
        }
        reactions[support.node] = system_->equations_.to_global_axes(support.node, own);
    }
    return reactions;
}

RelativeRotation SystemMeasures::bound_relative_rotation(const std::vector<NodeMotion>& motions,
                                                         const std::vector<Vec3>& spins) const {
    RelativeRotation largest;
    for_each_block(system_->blocks_, [&](const auto& block) {
        using Block = std::remove_cvref_t<decltype(block)>;
        if constexpr (sees_relative_rotation<typename Block::ElementType>) {
            std::vector<RelativeRotation> parts(block.phases.part_count());
            system_->team_->for_each(parts.size(), [&](std::size_t part) {
                for (std::size_t e = block.phases.first(part); e < block.phases.last(part); ++e) {
                    const auto& nodes = block.elements[e].nodes;
                    double added = Block::node_count == 1 ? spins[nodes[0]].norm() : 0.0;
                    for (int i = 0; i < Block::node_count; ++i) {
                        for (int j = 0; j < i; ++j)
                            added = std::max(added, (spins[nodes[i]] - spins[nodes[j]]).norm());
                    }
                    const double angle =
                        added + block.elements[e].largest_relative_rotation(block.motions(motions, e));
                    if (angle > parts[part].angle) parts[part] = {angle, nodes[0]};
                }
            });
            for (const RelativeRotation& part : parts) {
                if (part.angle > largest.angle) largest = part;
            }
        }
    });
    return largest;
}

}  // namespace gxrod
