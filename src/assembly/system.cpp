#include "assembly/system.hpp"

#include <algorithm>
#include <limits>

#include "assembly/contact/contact_assembly.hpp"

namespace gxrod {

namespace {

// Scales that parts of the work find at the same time, each those of its groups.
class PartwiseScales {
  public:
    // count_groups(part): how many groups a part has.
    template <class CountGroups>
    void start(std::size_t parts, const CountGroups& count_groups) {
        firsts_.assign(1, 0);
        for (std::size_t part = 0; part < parts; ++part)
            firsts_.push_back(firsts_.back() + count_groups(part));
        scales_.assign(firsts_.back(), {});
    }
    std::span<ForceScales> of(std::size_t part) {
        return std::span(scales_).subspan(firsts_[part], firsts_[part + 1] - firsts_[part]);
    }
    // group_at(part, i): the part's group i.
    template <class GroupAt>
    void raise(std::vector<ForceScales>& groups, const GroupAt& group_at) {
        for (std::size_t part = 0; part + 1 < firsts_.size(); ++part) {
            const std::span<const ForceScales> own = of(part);
            for (std::size_t i = 0; i < own.size(); ++i) groups[group_at(part, i)].raise(own[i]);
        }
    }

  private:
    std::vector<std::size_t> firsts_;
    std::vector<ForceScales> scales_;
};

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

System::~System() = default;

const ContactAssembly* contact_assembly_of(const System& system) { return system.contact_.get(); }

const std::optional<std::vector<NodeGroup>>& touching_groups_of(const System& system) {
    return system.touching_;
}

void resolve_contact(System& system) {
    if (system.contact_) system.contact_->resolve();
}

void System::forget_loads() const {
    drive_values_.forget();
    for (const Contribution* one : contributions_) one->forget();
}

State System::initial_state() const {
    State state;
    state.trial.resize(model_->nodes.size());
    for (int i = 0; i < static_cast<int>(model_->nodes.size()); ++i) {
        const Node& node = model_->nodes[i];
        state.trial[i].r = node.position;
        state.trial[i].v = node.velocity;
        state.trial[i].omega = node.angular_velocity;
        equations_.hold_rates(i, state.trial[i]);
    }
    state.previous = state.trial;
    state.sections.resize(history_count_);
    state.memory.assign(memory_count_, 0.0);
    joints_.start(state);
    for_each_block(blocks_, [&](const auto& block) {
        for (std::size_t e = 0; e < block.elements.size(); ++e)
            block.elements[e].start(block.writable_histories(state, e).axes);
    });
    return state;
}

Instant System::instant(const State& state, double time, const std::vector<NodeMotion>& motions) const {
    Instant instant;
    instant.elapsed =
        model_->has_time ? std::max(time - state.time, 0.0) : std::numeric_limits<double>::infinity();
    if (!drive_values_.empty()) {
        drive_values_.move_to(time);
        if (drive_values_.have_pressures()) drive_values_.press(motions, time);
        tendon_lines_.capstans().set_tensions(motions, state, time, drive_values_);
        instant.drives = &drive_values_;
    }
    return instant;
}

Instant System::instant_of_sections(const State& state, double time) const {
    Instant now = instant(state, time);
    if (tendon_lines_.have_winches()) now.drives = &tendon_lines_.drives_at(state, joints_, time);
    return now;
}

void System::subtract_loads(const State& state, double time, Residual& residual) const {
    for (const auto& load : loads_) load->subtract_forces(state, time, {}, residual);
}

template <class E>
void System::add_forces(const ElementBlock<E>& block,
                        std::size_t part,
                        const State& state,
                        const Instant& instant,
                        const Vec3& gravity,
                        std::vector<Vec6>& nodal,
                        const PartScales& scales) const {
    if constexpr (is_batched<E>) {
        batches_of(block).add_forces(part, state, instant, gravity, nodal, scales);
    } else {
        using Force = NodalVector<E::node_count>;
        for (std::size_t e = block.phases.first(part); e < block.phases.last(part); ++e) {
            const E& element = block.elements[e];
            const auto motions = block.motions(state.trial, e);
            const Histories histories = block.histories(state, e, instant);
            Force internal = Force::Zero();
            Force inertial = Force::Zero();
            element.add_internal_force(motions, histories, internal);
            if (block.is_damped) element.add_damping_force(motions, histories, internal);
            element.add_inertial_force(motions, gravity, inertial);
            ForceScales& own = scales.of(block.groups[e]);
            own.raise(internal);
            own.raise(inertial);
            // With nothing internal, inertia balances itself and its sum vanishes: its terms are the scale.
            if constexpr (!E::has_section) own.raise(compute_acceleration_force(element, motions));
            add_to_nodes<E::node_count>(internal + inertial, element.nodes, nodal);
        }
    }
}

void System::compute_residual(const State& state,
                              double time,
                              Residual& residual,
                              const ConstraintRequest& request) const {
    residual.nodal.resize(state.trial.size());
    team_->for_each_range(residual.nodal.size(), [&](std::size_t first, std::size_t last) {
        std::fill(residual.nodal.begin() + first, residual.nodal.begin() + last, Vec6::Zero());
    });
    residual.groups.assign(scale_groups_.count(), {});
    const Vec3 gravity = model_->gravity(time);
    const Instant now = instant(state, time);
    PartwiseScales scales;
    for_each_block(blocks_, [&](const auto& block) {
        if (block.elements.empty()) return;
        const auto groups = [&](std::size_t part) { return block.group_count(part); };
        scales.start(block.phases.part_count(), groups);
        block.phases.run(*team_, [&](std::size_t part) {
            const PartScales own{scales.of(part), block.first_group(part)};
            add_forces(block, part, state, now, gravity, residual.nodal, own);
        });
        scales.raise(residual.groups, [&](std::size_t part, std::size_t i) {
            return block.first_group(part) + static_cast<int>(i);
        });
    });
    for (const RotaryBatches* batches : {&rotary_batches_, &rotary_damping_batches_}) {
        if (batches->part_count() == 0) continue;
        scales.start(batches->part_count(), [&](std::size_t part) { return batches->groups(part).size(); });
        team_->for_each(batches->part_count(), [&](std::size_t part) {
            batches->add_forces(part, state.trial, residual.nodal, scales.of(part));
        });
        scales.raise(residual.groups,
                     [&](std::size_t part, std::size_t i) { return batches->groups(part)[i]; });
    }
    for (const Contribution* one : contributions_) one->subtract_forces(state, time, request, residual);
    residual.force_scale = residual.moment_scale = 0.0;
    for (const ForceScales& group : residual.groups) residual.raise(group);
}

template <class E>
void System::add_tangents(const ElementBlock<E>& block,
                          std::size_t part,
                          const State& state,
                          const Instant& instant,
                          const Vec3& gravity,
                          const std::vector<NodeLinearization>& linearizations,
                          std::vector<double>& values) const {
    const bool is_mixed = !state.resultants.empty();
    if constexpr (is_batched<E>) {
        if (!is_mixed) {
            return batches_of(block).add_tangents(part, state, instant, gravity, linearizations, values);
        }
    }
    using Tangent = NodalMatrix<E::node_count>;
    for (std::size_t e = block.phases.first(part); e < block.phases.last(part); ++e) {
        const E& element = block.elements[e];
        const auto motions = block.motions(state.trial, e);
        const auto nodal = block.point_at(linearizations, element.nodes);
        const Histories histories = block.histories(state, e, instant);
        Tangent tangent = Tangent::Zero();
        if (is_mixed) {
            element.add_mixed_tangent(motions, histories, block.resultants(state, e), nodal, tangent);
        } else {
            element.add_internal_tangent(motions, histories, nodal, tangent);
        }
        if (block.is_damped) element.add_damping_tangent(motions, histories, nodal, tangent);
        element.add_inertial_tangent(motions, gravity, nodal, tangent);
        turn_to_own_axes(std::span<const int>(element.nodes), equations_, tangent);
        add_to_values<E::node_count>(tangent, block.places[e], values);
    }
}

void System::compute_tangent(const State& state,
                             double time,
                             const std::vector<NodeLinearization>& linearizations,
                             std::vector<double>& values,
                             const ConstraintRequest& request) const {
    values.resize(static_cast<std::size_t>(pattern_.nonzeros()));
    for (const EntryRange& range : cleared_alone_) range.clear(values);
    const Vec3 gravity = model_->gravity(time);
    const Instant now = instant(state, time);
    for_each_block(blocks_, [&](const auto& block) {
        block.phases.run(*team_, [&](std::size_t part) {
            for (const EntryRange& range : block.cleared[part]) range.clear(values);
            add_tangents(block, part, state, now, gravity, linearizations, values);
        });
    });
    if (state.resultants.empty()) {
        for (const RotaryBatches* batches : {&rotary_batches_, &rotary_damping_batches_}) {
            team_->for_each(batches->part_count(), [&](std::size_t part) {
                batches->add_tangents(part, state.trial, linearizations, values);
            });
        }
    }
    for (const Contribution* one : contributions_) {
        for (std::size_t i = 0; one == &joints_ && request.added != nullptr && i < values.size(); ++i)
            values[i] += (*request.added)[i];
        one->add_tangents(state, time, request, linearizations, values);
    }
}

void System::start_resultants(State& state) const {
    state.resultants.resize(point_count_);
    const std::vector<Vec6> none(state.previous.size(), Vec6::Zero());
    set_resultants(state.previous, state.time, none, state);
}

void System::advance_resultants(const std::vector<Vec6>& increments, State& state) const {
    set_resultants(state.trial, state.trial_time, increments, state);
}

void System::set_resultants(const std::vector<NodeMotion>& motions,
                            double time,
                            const std::vector<Vec6>& increments,
                            State& state) const {
    const Instant now = instant(state, time, motions);
    for_each_block(blocks_, [&](const auto& block) {
        using Block = std::remove_cvref_t<decltype(block)>;
        if constexpr (Block::point_count > 0) {
            team_->for_each_range(block.elements.size(), [&](std::size_t first, std::size_t last) {
                for (std::size_t e = first; e < last; ++e) {
                    const auto& element = block.elements[e];
                    NodalVector<Block::node_count> increment;
                    for (int i = 0; i < Block::node_count; ++i) {
                        increment.template segment<6>(6 * i) = increments[element.nodes[i]];
                    }
                    element.advance_resultants(block.motions(motions, e),
                                               block.histories(state, e, now),
                                               increment,
                                               block.resultants(state, e));
                }
            });
        }
    });
}

void System::commit(State& state, double time) const {
    for (const Contribution* one : contributions_) one->commit(state, time);
    const Instant now = instant(state, time);
    tendon_lines_.capstans().commit(state, time);
    for_each_block(blocks_, [&](const auto& block) {
        if (std::remove_cvref_t<decltype(block)>::history_count == 0 && block.first_memory.empty()) return;
        team_->for_each_range(block.elements.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t e = first; e < last; ++e)
                block.elements[e].commit(block.motions(state.trial, e),
                                         block.histories(state, e, now),
                                         block.writable_histories(state, e));
        });
    });
    state.previous.resize(state.trial.size());
    team_->for_each_range(state.trial.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            state.trial[i].Lambda.normalize();
            state.trial[i].theta.setZero();
            state.previous[i] = state.trial[i];
        }
    });
    state.carried_previous = state.carried_trial;
    state.time = state.trial_time = time;
}

}  // namespace gxrod
