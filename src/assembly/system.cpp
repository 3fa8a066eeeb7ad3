#include "assembly/system.hpp"

#include <algorithm>

#include "loads/nodal_load.hpp"

namespace gxrod {

namespace {

void add_rod(const Model& model, const Rod& rod, int first_element, ElementBlock<SimoElement<2>>& block) {
    for (int e = 0; e < rod.element_count(); ++e) {
        RodElementGeometry<2> geometry;
        for (int i = 0; i < 2; ++i) {
            const int entry = e * (rod.order + 1) + i;
            geometry.nodes[i] = rod.element_nodes[entry];
            geometry.positions[i] = model.nodes[geometry.nodes[i]].position;
            geometry.triads[i] = rod.triads[entry];
        }
        block.elements.emplace_back(geometry, model.sections[rod.section]);
        block.section_index.push_back(first_element + e);
    }
}

// Raises the scales to what a force on one node, or a stack of them, holds.
template <class Vector>
void raise_scales(const Vector& force, Residual& residual) {
    for (int i = 0; i < force.size(); i += 6) {
        residual.force_scale =
            std::max(residual.force_scale, force.template segment<3>(i).template lpNorm<Eigen::Infinity>());
        residual.moment_scale = std::max(residual.moment_scale,
                                         force.template segment<3>(i + 3).template lpNorm<Eigen::Infinity>());
    }
}

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

}  // namespace

System::System(const Model& model) : model_(&model), equations_(compute_fixed_components(model)) {
    build_blocks();
    build_pattern();
    measure();
}

void System::build_blocks() {
    for (const Body& body : model_->bodies)
        std::get<ElementBlock<RigidBody>>(blocks_).elements.emplace_back(body);
    for (const Rod& rod : model_->rods) {
        add_rod(*model_, rod, rod_element_count_, std::get<ElementBlock<SimoElement<2>>>(blocks_));
        rod_element_count_ += rod.element_count();
    }
    for_each_block(blocks_, [this](auto& block) {
        block.first_history = history_count_;
        history_count_ += block.elements.size() * block.force_point_count;
    });
}

void System::build_pattern() {
    std::vector<NodeGroup> groups;
    for_each_block(blocks_, [&](const auto& block) {
        for (const auto& element : block.elements)
            groups.emplace_back(element.nodes.begin(), element.nodes.end());
    });
    pattern_ = compute_pattern(equations_, groups);
    for_each_block(blocks_, [this](auto& block) {
        constexpr int node_count = std::remove_cvref_t<decltype(block)>::node_count;
        for (const auto& element : block.elements) {
            block.slots.push_back(compute_slots<node_count>(element.nodes, equations_, pattern_));
        }
    });
    for (const NodalLoad& load : model_->loads) {
        load_slots_.push_back(compute_slots<1>({load.node}, equations_, pattern_));
    }
}

void System::measure() {
    Eigen::AlignedBox3d box;
    for (const Node& node : model_->nodes) box.extend(node.position);
    double length = box.isEmpty() ? 0.0 : box.diagonal().norm();
    for (const Body& body : model_->bodies) {
        length = std::max({length, body.centre_of_mass.norm(), std::sqrt(body.inertia.trace() / body.mass)});
    }
    if (length > 0.0) length_scale_ = length;
}

std::size_t System::element_count() const {
    return static_cast<std::size_t>(rod_element_count_) + model_->bodies.size();
}

State System::initial_state() const {
    State state;
    state.trial.resize(model_->nodes.size());
    for (std::size_t i = 0; i < model_->nodes.size(); ++i) {
        state.trial[i].r = model_->nodes[i].position;
        state.trial[i].v = model_->nodes[i].velocity;
        state.trial[i].omega = model_->nodes[i].angular_velocity;
        const auto& equations = equations_.of_node(static_cast<int>(i));
        for (int k = 0; k < 3; ++k) {
            if (equations[k] < 0) state.trial[i].v[k] = 0.0;
            if (equations[k + 3] < 0) state.trial[i].omega[k] = 0.0;
        }
    }
    state.previous = state.trial;
    state.sections.resize(history_count_);
    for_each_block(blocks_, [&](const auto& block) {
        for (std::size_t e = 0; e < block.elements.size(); ++e)
            block.elements[e].start(block.histories(state, e));
    });
    return state;
}

void System::compute_residual(const State& state, double time, Residual& residual) const {
    residual.nodal.assign(state.trial.size(), Vec6::Zero());
    residual.force_scale = residual.moment_scale = 0.0;
    for_each_block(blocks_, [&](const auto& block) {
        using Force = NodalVector<std::remove_cvref_t<decltype(block)>::node_count>;
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            const auto& element = block.elements[e];
            const auto motions = block.motions(state.trial, e);
            Force internal = Force::Zero();
            Force inertial = Force::Zero();
            element.add_internal_force(motions, block.histories(state, e), internal);
            element.add_inertial_force(motions, model_->gravity(time), inertial);
            raise_scales(internal, residual);
            raise_scales(inertial, residual);
            // With nothing internal, inertia balances itself and its sum vanishes: its terms are the scale.
            if constexpr (std::remove_cvref_t<decltype(block)>::force_point_count == 0) {
                raise_scales(compute_acceleration_force(element, motions), residual);
            }
            add_to_nodes<Force::RowsAtCompileTime / 6>(internal + inertial, element.nodes, residual.nodal);
        }
    });
    for (const NodalLoad& load : model_->loads) {
        const Vec6 force = compute_load(load, state.trial[load.node], time);
        raise_scales(force, residual);
        residual.nodal[load.node] -= force;
    }
}

void System::compute_tangent(const State& state,
                             double time,
                             const std::vector<NodeLinearization>& linearizations,
                             std::vector<double>& values) const {
    values.assign(pattern_.rows.size(), 0.0);
    for_each_block(blocks_, [&](const auto& block) {
        using Tangent = NodalMatrix<std::remove_cvref_t<decltype(block)>::node_count>;
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            const auto& element = block.elements[e];
            const auto motions = block.motions(state.trial, e);
            const auto nodal = block.point_at(linearizations, element.nodes);
            Tangent tangent = Tangent::Zero();
            element.add_internal_tangent(motions, block.histories(state, e), nodal, tangent);
            element.add_inertial_tangent(motions, model_->gravity(time), nodal, tangent);
            add_to_values<Tangent::RowsAtCompileTime / 6>(tangent, block.slots[e], values);
        }
    });
    for (std::size_t i = 0; i < model_->loads.size(); ++i) {
        const NodalLoad& load = model_->loads[i];
        if (load.frame == Frame::spatial) continue;
        const Vec6 force = compute_load(load, state.trial[load.node], time);
        const Mat6 tangent = -compute_load_tangent(load, force, linearizations[load.node]);
        add_to_values<1>(tangent, load_slots_[i], values);
    }
}

void System::commit(State& state, double time) const {
    for_each_block(blocks_, [&](const auto& block) {
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            block.elements[e].commit(block.motions(state.trial, e), block.histories(state, e));
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

Balance System::compute_balance(const State& state) const {
    Balance balance;
    for_each_block(blocks_, [&](const auto& block) {
        for (std::size_t e = 0; e < block.elements.size(); ++e) {
            const auto& element = block.elements[e];
            const auto motions = block.motions(state.trial, e);
            balance.kinetic_energy += element.kinetic_energy(motions);
            balance.strain_energy += element.strain_energy(motions, block.histories(state, e));
            balance.gravity_potential += element.gravity_potential(motions, model_->gravity(state.time));
            const Momentum momentum = element.momentum(motions);
            balance.momentum.linear += momentum.linear;
            balance.momentum.angular += momentum.angular;
        }
    });
    return balance;
}

double System::compute_load_power(const std::vector<NodeMotion>& motions, double time) const {
    double power = 0.0;
    for (const NodalLoad& load : model_->loads) {
        const NodeMotion& motion = motions[load.node];
        const Vec6 force = compute_load(load, motion, time);
        power += force.head<3>().dot(motion.v) + force.tail<3>().dot(motion.omega);
    }
    return power;
}

double System::compute_load_work(const State& state, double time) const {
    double work = 0.0;
    for (const NodalLoad& load : model_->loads) {
        const NodeMotion& previous = state.previous[load.node];
        const NodeMotion& trial = state.trial[load.node];
        const Vec6 mean = 0.5 * (compute_load(load, previous, state.time) + compute_load(load, trial, time));
        work += mean.head<3>().dot(trial.r - previous.r) + mean.tail<3>().dot(trial.theta);
    }
    return work;
}

std::vector<SectionValues> System::compute_section_values(const State& state) const {
    std::vector<SectionValues> values(static_cast<std::size_t>(rod_element_count_));
    for_each_block(blocks_, [&](const auto& block) {
        for (std::size_t e = 0; e < block.section_index.size(); ++e) {
            if constexpr (std::remove_cvref_t<decltype(block)>::force_point_count > 0) {
                values[block.section_index[e]] = block.elements[e].section_values(
                    block.motions(state.trial, e), block.histories(state, e));
            }
        }
    });
    return values;
}

}  // namespace gxrod
