#include "assembly/system.hpp"

#include "loads/nodal_load.hpp"

namespace gxrod {

namespace {

// What accelerations alone ask of an element's nodes.
template <Element E>
NodalVector<E::node_count> compute_acceleration_force(const E& element,
                                                      const Motions<E::node_count>& motions) {
    std::array<NodeMotion, E::node_count> still;
    Motions<E::node_count> pointers;
    for (int i = 0; i < E::node_count; ++i) {
        still[i] = *motions[i];
        still[i].omega.setZero();
        pointers[i] = &still[i];
    }
    NodalVector<E::node_count> force = NodalVector<E::node_count>::Zero();
    element.add_inertial_force(pointers, Vec3::Zero(), force);
    return force;
}

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

}  // namespace

std::size_t System::element_count() const {
    return static_cast<std::size_t>(rod_element_count_) + model_->bodies.size();
}

State System::initial_state() const {
    State state;
    state.trial.resize(model_->nodes.size());
    for (int i = 0; i < static_cast<int>(model_->nodes.size()); ++i) {
        const Node& node = model_->nodes[i];
        Vec6 rates;
        rates << node.velocity, node.angular_velocity;
        rates = equations_.to_own_axes(i, rates);
        for (int k = 0; k < 6; ++k) {
            if (equations_.of_node(i)[k] < 0) rates[k] = 0.0;
        }
        rates = equations_.to_global_axes(i, rates);
        state.trial[i].r = node.position;
        state.trial[i].v = rates.head<3>();
        state.trial[i].omega = rates.tail<3>();
    }
    state.previous = state.trial;
    state.sections.resize(history_count_);
    for_each_block(blocks_, [&](const auto& block) {
        for (std::size_t e = 0; e < block.elements.size(); ++e)
            block.elements[e].start(block.histories(state, e));
    });
    return state;
}

void System::add_loads(const State& state, double time, Residual& residual) const {
    for (const NodalLoad& load : model_->loads) {
        const Vec6 force = compute_load(load, state.trial[load.node], time);
        raise_scales(force, residual);
        residual.nodal[load.node] -= force;
    }
    if (loaded_elements_.empty()) return;
    std::vector<Vec6> distributed(state.trial.size(), Vec6::Zero());
    for (const LoadedElement& element : loaded_elements_) {
        add_distributed_load(element, state.trial, time, distributed);
    }
    for (std::size_t i = 0; i < distributed.size(); ++i) {
        raise_scales(distributed[i], residual);
        residual.nodal[i] -= distributed[i];
    }
}

void System::compute_residual(const State& state, double time, Residual& residual) const {
    residual.nodal.assign(state.trial.size(), Vec6::Zero());
    residual.force_scale = residual.moment_scale = 0.0;
    const Vec3 gravity = model_->gravity(time);
    for_each_block(rod_batches_,
                   [&](const auto& batches) { batches.add_forces(state.trial, gravity, residual); });
    rotary_batches_.add_forces(state.trial, residual);
    for_each_block(blocks_, [&](const auto& block) {
        using Force = NodalVector<std::remove_cvref_t<decltype(block)>::node_count>;
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            const bool is_alone = !is_in_batch(rod_batches_, block, e);
            if (!is_alone && !block.is_damped) continue;
            const auto& element = block.elements[e];
            const auto motions = block.motions(state.trial, e);
            Force internal = Force::Zero();
            Force inertial = Force::Zero();
            if (is_alone) element.add_internal_force(motions, block.histories(state, e), internal);
            if (block.is_damped) element.add_damping_force(motions, block.histories(state, e), internal);
            if (is_alone) element.add_inertial_force(motions, gravity, inertial);
            raise_scales(internal, residual);
            raise_scales(inertial, residual);
            // With nothing internal, inertia balances itself and its sum vanishes: its terms are the scale.
            if constexpr (!std::remove_cvref_t<decltype(block)>::has_section) {
                raise_scales(compute_acceleration_force(element, motions), residual);
            }
            add_to_nodes<Force::RowsAtCompileTime / 6>(internal + inertial, element.nodes, residual.nodal);
        }
    });
    add_loads(state, time, residual);
}

void System::add_load_tangents(const State& state,
                               double time,
                               const std::vector<NodeLinearization>& linearizations,
                               std::vector<double>& values) const {
    for (std::size_t i = 0; i < model_->loads.size(); ++i) {
        const NodalLoad& load = model_->loads[i];
        if (load.frame == Frame::spatial) continue;
        const Vec6 force = compute_load(load, state.trial[load.node], time);
        Mat6 tangent = -compute_load_tangent(load, force, linearizations[load.node]);
        turn_to_own_axes(std::span(&load.node, 1), equations_, tangent);
        add_to_values<1>(tangent, load_places_[i], values);
    }
    for (std::size_t i = 0; i < loaded_elements_.size(); ++i) {
        const LoadedElement& element = loaded_elements_[i];
        if (element.load->frame == Frame::spatial) continue;
        LoadMatrix tangent = -compute_distributed_load_tangent(element, state.trial, time, linearizations);
        turn_to_own_axes(std::span<const int>(element.nodes), equations_, tangent);
        add_to_values(tangent.data(), loaded_element_slots_[i], values);
    }
}

void System::compute_tangent(const State& state,
                             double time,
                             const std::vector<NodeLinearization>& linearizations,
                             std::vector<double>& values) const {
    values.assign(static_cast<std::size_t>(pattern_.nonzeros()), 0.0);
    const Vec3 gravity = model_->gravity(time);
    const bool is_mixed = !state.resultants.empty();
    if (!is_mixed) {
        for_each_block(rod_batches_, [&](const auto& batches) {
            batches.add_tangents(state.trial, linearizations, values);
        });
        rotary_batches_.add_tangents(state.trial, linearizations, values);
    }
    for_each_block(blocks_, [&](const auto& block) {
        constexpr int node_count = std::remove_cvref_t<decltype(block)>::node_count;
        using Tangent = NodalMatrix<node_count>;
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            const bool is_alone = is_mixed || !is_in_batch(rod_batches_, block, e);
            if (!is_alone && !block.is_damped) continue;
            const auto& element = block.elements[e];
            const auto motions = block.motions(state.trial, e);
            const auto nodal = block.point_at(linearizations, element.nodes);
            const Histories histories = block.histories(state, e);
            Tangent tangent = Tangent::Zero();
            if (is_mixed) {
                element.add_mixed_tangent(motions, histories, block.resultants(state, e), nodal, tangent);
            } else if (is_alone) {
                element.add_internal_tangent(motions, histories, nodal, tangent);
            }
            if (block.is_damped) element.add_damping_tangent(motions, histories, nodal, tangent);
            if (is_alone) element.add_inertial_tangent(motions, gravity, nodal, tangent);
            turn_to_own_axes(std::span<const int>(element.nodes), equations_, tangent);
            add_to_values<node_count>(tangent, block.places[e], values);
        }
    });
    add_load_tangents(state, time, linearizations, values);
}

void System::start_resultants(State& state) const {
    state.resultants.resize(point_count_);
    advance_resultants(std::vector<Vec6>(state.trial.size(), Vec6::Zero()), state);
}

void System::advance_resultants(const std::vector<Vec6>& increments, State& state) const {
    for_each_block(blocks_, [&](const auto& block) {
        using Block = std::remove_cvref_t<decltype(block)>;
        if constexpr (Block::point_count > 0) {
            for (std::size_t e = 0; e < block.elements.size(); ++e) {
                const auto& element = block.elements[e];
                NodalVector<Block::node_count> increment;
                for (int i = 0; i < Block::node_count; ++i) {
                    increment.template segment<6>(6 * i) = increments[element.nodes[i]];
                }
                element.advance_resultants(block.motions(state.trial, e),
                                           block.histories(std::as_const(state), e),
                                           increment,
                                           block.resultants(state, e));
            }
        }
    });
}

void System::commit(State& state, double time) const {
    for_each_block(blocks_, [&](const auto& block) {
        if constexpr (std::remove_cvref_t<decltype(block)>::history_count > 0) {
            for (std::size_t e = 0; e < block.elements.size(); ++e) {
                block.elements[e].commit(block.motions(state.trial, e), block.histories(state, e));
            }
        }
    });
    for (NodeMotion& motion : state.trial) {
        motion.Lambda.normalize();
        motion.theta.setZero();
    }
    state.previous = state.trial;
    state.algorithmic_previous = state.algorithmic_trial;
    state.time = time;
}

Balance System::compute_balance(const State& state, double time) const {
    Balance balance;
    const bool has_potential = model_->gravity.is_constant();
    const Vec3 gravity = has_potential ? model_->gravity(time) : Vec3::Zero();
    for_each_block(blocks_, [&](const auto& block) {
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            const auto& element = block.elements[e];
            const auto motions = block.motions(state.trial, e);
            balance.kinetic_energy += element.kinetic_energy(motions);
            balance.strain_energy += element.strain_energy(motions, block.histories(state, e));
            balance.gravity_potential += element.gravity_potential(motions, gravity);
            const Momentum momentum = element.momentum(motions);
            balance.momentum.linear += momentum.linear;
            balance.momentum.angular += momentum.angular;
        }
    });
    return balance;
}

WorkingForces System::compute_working_forces(const State& state,
                                             double time,
                                             const Residual& residual) const {
    Residual loads;
    loads.nodal.assign(state.trial.size(), Vec6::Zero());
    add_loads(state, time, loads);
    WorkingForces forces;
    forces.driving.resize(state.trial.size());
    for (std::size_t i = 0; i < forces.driving.size(); ++i) forces.driving[i] = -loads.nodal[i];
    for (const Support* support : supports_.moving()) {
        Vec6 exerted = equations_.to_own_axes(support->node, residual.nodal[support->node]);
        for (int i = 0; i < 6; ++i) {
            if (!supports_.held(support->node)[i]) exerted[i] = 0.0;
        }
        forces.driving[support->node] += equations_.to_global_axes(support->node, exerted);
    }
    const bool gravity_works = !model_->gravity.is_constant();
    if (is_damped_) forces.damping.assign(state.trial.size(), Vec6::Zero());
    for_each_block(blocks_, [&](const auto& block) {
        constexpr int node_count = std::remove_cvref_t<decltype(block)>::node_count;
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            const auto& element = block.elements[e];
            const auto motions = block.motions(state.trial, e);
            if (gravity_works) {
                add_to_nodes<node_count>(compute_gravity_force(element, motions, model_->gravity(time)),
                                         element.nodes,
                                         forces.driving);
            }
            if (block.is_damped) {
                NodalVector<node_count> force = NodalVector<node_count>::Zero();
                element.add_damping_force(motions, block.histories(state, e), force);
                add_to_nodes<node_count>(force, element.nodes, forces.damping);
            }
        }
    });
    return forces;
}

std::vector<Vec6> System::compute_reactions(const Residual& residual) const {
    std::vector<Vec6> reactions(residual.nodal.size(), Vec6::Zero());
    for (const Support& support : model_->supports) {
        Vec6 own = equations_.to_own_axes(support.node, residual.nodal[support.node]);
        for (int i = 0; i < 6; ++i) {
            if (!supports_.held(support.node)[i]) own[i] = 0.0;
        }
        reactions[support.node] = equations_.to_global_axes(support.node, own);
    }
    return reactions;
}

std::vector<SectionValues> System::compute_section_values(const State& state) const {
    std::vector<SectionValues> values(static_cast<std::size_t>(rod_element_count_));
    for_each_block(blocks_, [&](const auto& block) {
        if constexpr (std::remove_cvref_t<decltype(block)>::has_section) {
            for (std::size_t e = 0; e < block.section_index.size(); ++e) {
                values[block.section_index[e]] = block.elements[e].section_values(
                    block.motions(state.trial, e), block.histories(state, e));
            }
        }
    });
    return values;
}

RelativeRotation System::bound_relative_rotation(const std::vector<NodeMotion>& motions,
                                                 const std::vector<Vec3>& spins) const {
    RelativeRotation largest;
    for_each_block(blocks_, [&](const auto& block) {
        using Block = std::remove_cvref_t<decltype(block)>;
        if constexpr (Block::has_section && Block::history_count == 0) {
            for (std::size_t e = 0; e < block.elements.size(); ++e) {
                const auto& nodes = block.elements[e].nodes;
                double added = 0.0;
                for (int i = 0; i < Block::node_count; ++i) {
                    for (int j = 0; j < i; ++j)
                        added = std::max(added, (spins[nodes[i]] - spins[nodes[j]]).norm());
                }
                const double angle =
                    added + block.elements[e].largest_relative_rotation(block.motions(motions, e));
                if (angle > largest.angle) largest = {angle, nodes[0]};
            }
        }
    });
    return largest;
}

}  // namespace gxrod
