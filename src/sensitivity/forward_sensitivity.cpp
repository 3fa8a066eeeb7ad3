#include "sensitivity/forward_sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "analyses/start_velocities.hpp"
#include "assembly/contact/contacts.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

bool have_equal_forms(const Model& a, const Model& b) {
    const auto equal_rods = [](const Rod& one, const Rod& other) {
        return one.element_nodes == other.element_nodes && one.order == other.order && one.kind == other.kind;
    };
    const auto equal_tendons = [](const Tendon& one, const Tendon& other) {
        return one.winch.has_value() == other.winch.has_value() &&
               one.friction.has_value() == other.friction.has_value() &&
               (!one.winch || ((one.winch->stiffness > 0.0) == (other.winch->stiffness > 0.0) &&
                               one.winch->gas.has_value() == other.winch->gas.has_value()));
    };
    return a.nodes.size() == b.nodes.size() && a.bodies.size() == b.bodies.size() &&
           std::ranges::equal(a.rods, b.rods, equal_rods) && a.joints.size() == b.joints.size() &&
           a.gears.size() == b.gears.size() && a.sleeves.size() == b.sleeves.size() &&
           std::ranges::equal(a.tendons, b.tendons, equal_tendons);
}

// What an input was set to; one that was not set has its own course in each model. Signals have their own
// always (SideInputs).
void take_inputs(const Model& from, const System& to) {
    for (std::size_t i = 0; i < from.inputs.size(); ++i) {
        if (from.inputs[i]->is_signal()) continue;
        InputState state = from.inputs[i]->state();
        Input& input = *to.model().inputs[i];
        state.planned = input.state().planned;
        input.recall(state);
    }
    to.forget_loads();
}

}  // namespace

ForwardSensitivity::ForwardSensitivity(const System& base, const VariedModels& models, bool resolves_contact)
    : sides_{VariedSystem{models.near.up, models.near.step},
             VariedSystem{models.near.down, -models.near.step},
             VariedSystem{models.far.up, models.far.step},
             VariedSystem{models.far.down, -models.far.step}} {
    for (VariedSystem& side : sides_) {
        if (resolves_contact) resolve_contact(side.system);
        if (!have_equal_forms(base.model(), side.system.model()))
            throw std::invalid_argument("it changes which nodes and elements there are");
        if (base.equations().count() != side.system.equations().count())
            throw std::invalid_argument("it changes which motions are held");
    }
}

void start_system(const System& system, const StartOfAnalysis& start, State& state, State& ended) {
    const bool has_inertia = !start.integrator.is_static() && system.model().has_inertia;
    for (NodeMotion& motion : state.trial) {
        if (has_inertia) break;
        motion.v.setZero();
        motion.omega.setZero();
        motion.a.setZero();
        motion.alpha.setZero();
    }
    Contacts(system).search(state);
    if (has_inertia) {
        SolverWorkspace workspace(system, start.linear_solver);
        fit_start_velocities(system, 0.0, start.first_step, start.projects, workspace, state);
        if (!solve_accelerations(system, 0.0, start.first_step, workspace, state).converged())
            throw std::runtime_error("the derivative of the accelerations at t = 0 cannot be found");
    }
    start.integrator.start(state);
    ended = state;
    system.commit(state, 0.0);
    if (start.settles)  // as DynamicAnalysis does
        std::ranges::copy(system.memory_within_rods().of(ended),
                          system.memory_within_rods().of(state).begin());
}

void take_over_stage(const System& system, const State& end, State& state) {
    state = system.initial_state();
    take_over(end, state);
    system.joints().begin_stage(state, 0.0);
    for (std::size_t i = 0; i < state.trial.size(); ++i)
        system.equations().hold_rates(static_cast<int>(i), state.trial[i]);
    state.previous = state.trial;
}

// With the difference of the reference shapes, of which supports take what they hold.
void ForwardSensitivity::place_in_reference(const State& state) {
    for (VariedSystem& side : sides_) {
        side.state = side.system.initial_state();
        side.system.supports().place(0.0, side.state);
        side.state.previous = side.state.trial;
    }
    direction_ = extrapolate(gxrod::differentiate(sides_[0].state, sides_[1].state, sides_[0].amount),
                             gxrod::differentiate(sides_[2].state, sides_[3].state, sides_[2].amount));
    place_sides(state);
    for (VariedSystem& side : sides_) undo_trial(side.state);
}

void ForwardSensitivity::start(const StartOfAnalysis& start) {
    for (VariedSystem& side : sides_) {
        side.state = side.system.initial_state();
        side.system.supports().place(0.0, side.state);
        side.system.joints().start(side.state);
        start_system(side.system, start, side.state, side.ended);
    }
    take_sides();
}

void ForwardSensitivity::start_after(const State& end,
                                     const StateDirection& direction,
                                     const StartOfAnalysis& start) {
    for (VariedSystem& side : sides_) {
        State moved = end;
        move_along(direction, side.amount, moved);
        take_over_stage(side.system, moved, side.state);
        start_system(side.system, start, side.state, side.ended);
    }
    take_sides();
}

void ForwardSensitivity::take_inputs(const Model& base) {
    for (const VariedSystem& side : sides_) gxrod::take_inputs(base, side.system);
}

void ForwardSensitivity::place_sides(const State& before) {
    for (VariedSystem& side : sides_) {
        side.state = before;
        move_along(direction_, side.amount, side.state);
    }
}

std::array<VariedSystem*, 4> ForwardSensitivity::sides() {
    return {&sides_[0], &sides_[1], &sides_[2], &sides_[3]};
}

void ForwardSensitivity::take_sides() {
    direction_ = extrapolate(gxrod::differentiate(sides_[0].state, sides_[1].state, sides_[0].amount),
                             gxrod::differentiate(sides_[2].state, sides_[3].state, sides_[2].amount));
}

namespace {

// The trial motions in place of the accepted ones, and nothing else.
State take_trial(const State& state) {
    State taken;
    taken.previous = state.trial;
    taken.joints_previous = state.joints_trial;
    taken.carried_previous = state.carried_trial;
    return taken;
}

}  // namespace

void ForwardSensitivity::straighten_ends(const State& centre) {
    std::array<State, 4> ends;
    for (std::size_t i = 0; i < sides_.size(); ++i) ends[i] = take_trial(sides_[i].ended);
    const State middle = take_trial(centre);
    const StateDirection direction =
        extrapolate(gxrod::differentiate(ends[0], ends[1], sides_[0].amount, &middle),
                    gxrod::differentiate(ends[2], ends[3], sides_[2].amount, &middle));
    for (VariedSystem& side : sides_) {
        State end = middle;
        move_along(direction, side.amount, end);
        for (std::size_t i = 0; i < end.previous.size(); ++i)
            end.previous[i].theta = log(end.previous[i].Lambda * side.ended.previous[i].Lambda.conjugate());
        side.ended.trial = std::move(end.previous);
        side.ended.joints_trial = std::move(end.joints_previous);
        side.ended.carried_trial = std::move(end.carried_previous);
    }
}

// Of a smooth function f(h) − 2 f(0) + f(−h) grows with h², but for what is of order h⁴; of one that has a
// kink next to 0, with h.
void ForwardSensitivity::check_smoothness(const State& centre, double time_step) {
    if (!kink_.empty()) return;
    constexpr double tolerable = 1e-4;  // of the largest derivative
    constexpr double round_off = 1e-10;
    const double length = sides_[0].system.length_scale();
    const auto bend = [&](const VariedSystem& up, const VariedSystem& down, std::size_t i) {
        const NodeMotion &a = up.state.previous[i], &b = down.state.previous[i], &c = centre.previous[i];
        const auto turn = [&](const NodeMotion& to) { return log(to.Lambda * c.Lambda.conjugate()); };
        return std::array<Vec3, 4>{a.r + b.r - 2.0 * c.r,
                                   turn(a) + turn(b),
                                   a.v + b.v - 2.0 * c.v,
                                   a.omega + b.omega - 2.0 * c.omega};
    };
    std::array<double, 4> kink{}, largest{};
    for (std::size_t i = 0; i < centre.previous.size(); ++i) {
        const StateDirection::OfNode& by = direction_.nodes[i];
        const std::array<Vec3, 4> derivatives{by.r, by.phi, by.v, by.omega};
        const auto near = bend(sides_[0], sides_[1], i), far = bend(sides_[2], sides_[3], i);
        for (std::size_t k = 0; k < 4; ++k) {
            kink[k] = std::max(kink[k], (far[k] - 4.0 * near[k]).norm());
            largest[k] = std::max(largest[k], derivatives[k].norm());
        }
    }
    // Lengths, turns and their rates in a step are comparable by these.
    const std::array<double, 4> sizes{length, 1.0, length / time_step, 1.0 / time_step};
    const double step = 2.0 * sides_[2].amount;
    for (std::size_t k = 0; k < 4; ++k) {
        double size = largest[k];
        for (std::size_t other = 0; other < 2; ++other)
            size = std::max(size, largest[other] * sizes[k] / sizes[other]);
        if (kink[k] > tolerable * step * size && kink[k] > round_off * sizes[k])
            kink_ = fmt::format(
                "it does not exist from t = {:.6g} on, where something opens, closes or reaches a limit: a "
                "kink; "
                "take another value of the number, or a difference of whole runs",
                centre.time);
    }
}

ForwardSensitivity::Record ForwardSensitivity::record() const {
    Record record{direction_, {}, kink_};
    for (std::size_t i = 0; i < sides_.size(); ++i) record.ended[i] = sides_[i].ended;
    return record;
}

void ForwardSensitivity::recall(const Record& record, const Pieces& pieces) {
    direction_ = record.direction;
    kink_ = record.kink;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        sides_[i].ended = record.ended[i];
        sides_[i].held.release();
        sides_[i].held.hold(pieces);
    }
}

std::vector<double> ForwardSensitivity::differentiate(const Quantities& quantities) const {
    if (!kink_.empty()) throw std::runtime_error(kink_);
    std::array<std::vector<double>, 4> values;
    for (std::size_t i = 0; i < sides_.size(); ++i)
        values[i] = quantities(sides_[i].system, sides_[i].ended, i);
    std::vector<double> derivative(values[0].size());
    for (std::size_t k = 0; k < derivative.size(); ++k) {
        const double near = (values[0][k] - values[1][k]) / (2.0 * sides_[0].amount);
        const double far = (values[2][k] - values[3][k]) / (2.0 * sides_[2].amount);
        derivative[k] = (4.0 * near - far) / 3.0;
    }
    return derivative;
}

}  // namespace gxrod
