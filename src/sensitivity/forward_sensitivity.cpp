#include "sensitivity/forward_sensitivity.hpp"

#include <algorithm>
#include <stdexcept>

#include "analyses/start_velocities.hpp"

namespace gxrod {

namespace {

bool have_equal_forms(const Model& a, const Model& b) {
    const auto equal_rods = [](const Rod& one, const Rod& other) {
        return one.element_nodes == other.element_nodes && one.order == other.order && one.kind == other.kind;
    };
    const auto equal_tendons = [](const Tendon& one, const Tendon& other) {
        return one.winch.has_value() == other.winch.has_value() &&
               one.friction.has_value() == other.friction.has_value() &&
               (!one.winch || (one.winch->stiffness > 0.0) == (other.winch->stiffness > 0.0));
    };
    return a.nodes.size() == b.nodes.size() && a.bodies.size() == b.bodies.size() &&
           std::ranges::equal(a.rods, b.rods, equal_rods) && a.joints.size() == b.joints.size() &&
           a.gears.size() == b.gears.size() && a.sleeves.size() == b.sleeves.size() &&
           std::ranges::equal(a.tendons, b.tendons, equal_tendons);
}

// What an input was set to; one that was not set has its own course in each model.
void take_inputs(const Model& from, const System& to) {
    for (std::size_t i = 0; i < from.inputs.size(); ++i) {
        InputState state = from.inputs[i]->state();
        Input& input = *to.model().inputs[i];
        state.planned = input.state().planned;
        input.recall(state);
    }
    to.forget_loads();
}

}  // namespace

ForwardSensitivity::ForwardSensitivity(const System& base, const VariedModels& models)
    : sides_{VariedSystem{models.near.up, models.near.step},
             VariedSystem{models.near.down, -models.near.step},
             VariedSystem{models.far.up, models.far.step},
             VariedSystem{models.far.down, -models.far.step}} {
    for (const VariedSystem& side : sides_) {
        if (!have_equal_forms(base.model(), side.model))
            throw std::invalid_argument("it changes which nodes and elements there are");
        if (base.equations().count() != side.system.equations().count())
            throw std::invalid_argument("it changes which motions are held");
    }
}

State ForwardSensitivity::start_one(const VariedSystem& side,
                                    const Integrator& integrator,
                                    const TimeSpan& first_step,
                                    LinearSolverKind solver,
                                    bool projects_start) const {
    const System& system = side.system;
    State state = system.initial_state();
    system.supports().place(0.0, state);
    SolverWorkspace workspace(system, solver);
    const bool has_inertia = !integrator.is_static() && system.model().has_inertia;
    for (NodeMotion& motion : state.trial) {
        if (has_inertia) break;
        motion.v.setZero();
        motion.omega.setZero();
    }
    if (has_inertia) {
        fit_start_velocities(system, 0.0, first_step, projects_start, workspace, state);
        if (!solve_accelerations(system, 0.0, first_step, workspace, state).converged())
            throw std::runtime_error("the derivative of the accelerations at t = 0 cannot be found");
    }
    integrator.start(state);
    system.joints().start(state);
    system.commit(state, 0.0);
    return state;
}

void ForwardSensitivity::start(const Integrator& integrator,
                               const TimeSpan& first_step,
                               LinearSolverKind solver,
                               bool projects_start) {
    for (VariedSystem& side : sides_)
        side.state = start_one(side, integrator, first_step, solver, projects_start);
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

std::vector<double> ForwardSensitivity::differentiate(const State& state,
                                                      const Quantities& quantities) const {
    std::array<std::vector<double>, 4> values;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        State moved = state;
        move_along(direction_, sides_[i].amount, moved);
        undo_trial(moved);
        values[i] = quantities(sides_[i].system, moved, i);
    }
    std::vector<double> derivative(values[0].size());
    for (std::size_t k = 0; k < derivative.size(); ++k) {
        const double near = (values[0][k] - values[1][k]) / (2.0 * sides_[0].amount);
        const double far = (values[2][k] - values[3][k]) / (2.0 * sides_[2].amount);
        derivative[k] = (4.0 * near - far) / 3.0;
    }
    return derivative;
}

}  // namespace gxrod
