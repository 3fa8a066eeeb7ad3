#include <algorithm>
#include <cmath>
#include <numeric>

#include "assembly/contact/contact_pairs.hpp"

// What rods that touch each other store, and what their forces do in a step.
namespace gxrod {

template <class Item, class Value>
double ContactPairs::sum_of(const std::vector<Item>& items, const Value& value) const {
    std::vector<double> values(items.size());
    team_->for_each_range(items.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) values[i] = value(items[i]);
    });
    return std::accumulate(values.begin(), values.end(), 0.0);
}

double ContactPairs::compute_energy(const State& state) const {
    return sum_of(find_touching(state), [&](const Touching& one) {
        if (!rub()) return one.energy.energy;
        const CoulombFriction friction = friction_of(one.index, state);
        const PairFriction there =
            compute_pair_friction(one.energy, motion_of(state.contact.pieces[one.index], state), friction);
        return one.energy.energy + 0.5 * there.traction.value.squaredNorm() / friction.stiffness;
    });
}

double ContactPairs::compute_work(const State& state) const {
    return sum_of(find_touching(state), [&](const Touching& one) {
        const NearPieces& near = state.contact.pieces[one.index];
        const PairMotion motion = motion_of(near, state);
        Vec24 forces = with_moments(-one.impulse.gradient);
        if (rub()) forces += compute_pair_friction(one.energy, motion, friction_of(one.index, state)).forces;
        double work = 0.0;
        for (int end = 0; end < 4; ++end) {
            const auto at = static_cast<std::size_t>(end);
            work += forces.segment<3>(6 * end).dot(motion.positions[at] - motion.positions_before[at]) +
                    forces.segment<3>(6 * end + 3).dot(motion.rotations[at]);
        }
        return has_body(near) ? work + compute_turning_work(near, forces, state) : work;
    });
}

double ContactPairs::compute_damping_power(const State& state) const {
    if (!resolves_ || (damping_ == 0.0 && !bounces())) return 0.0;
    return sum_of(find_touching(state), [](const Touching& one) { return one.damping_power; });
}

double ContactPairs::compute_slip_work(const State& state) const {
    if (!rub()) return 0.0;
    return sum_of(find_touching(state), [&](const Touching& one) {
        const CoulombFriction friction = friction_of(one.index, state);
        const PairFriction there =
            compute_pair_friction(one.energy, motion_of(state.contact.pieces[one.index], state), friction);
        const Vec3& after = there.traction.value;
        return -0.5 * (after + there.traction_before).dot(there.slip) -
               0.5 * (after.squaredNorm() - friction.traction.squaredNorm()) / friction.stiffness;
    });
}

double ContactPairs::compute_energy_before(const State& state) const {
    const std::vector<Segment> before = find_segments(state.previous);
    const auto of_near = [&](const NearPieces& near) {
        const Segment &a = before[near.first], &b = before[near.second];
        const PairLaw pair = law_of(near);
        return are_within(a, b, pair.radii + pair.law.skin) ? find_energy(near, before).energy : 0.0;
    };
    // The step before has mostly left them.
    double energy = before == found_.placed.now
                        ? sum_of(found_.touching, [](const Touching& one) { return one.energy.energy; })
                        : sum_of(state.contact.pieces, of_near);
    for (const PairTraction& one : state.pair_tractions)
        energy += 0.5 * one.traction.squaredNorm() / friction_stiffness_of(one.pieces);
    return energy;
}

bool ContactPairs::counter_gain(State& state) const {
    if (!has_impacts_) return false;
    const std::vector<Touching>& touching = find_touching(state);
    if (touching.empty()) return false;
    const double work = compute_work(state), energy = compute_energy(state);
    const double before = state.contact.energy_before, gain = work + energy - before;
    const double ways = sum_of(touching, [&](const Touching& one) {
        const NearPieces& near = state.contact.pieces[one.index];
        const PairStart& start = *found_.starts[one.index];
        const Vec12 ends = find_ends(found_.placed.now[near.first], found_.placed.now[near.second]);
        return find_relative_way(start, ends - start.ends).squaredNorm();
    });
    // Far above round-off. More than is needed here, as ways get shorter with it.
    constexpr double least = 1e-9, more = 1.2, at_least = 1.5;
    if (gain <= least * (std::abs(work) + energy + before) || ways == 0.0) return false;
    double& drag = state.contact.drag;
    drag = std::max(drag + more * gain / ways, at_least * drag);
    return true;
}

}  // namespace gxrod
