#pragma once

#include <vector>

#include "integrators/coupled_stages.hpp"
#include "solvers/equilibrium.hpp"

namespace gxrod {

// The stages of one step of a scheme that finds them together: what all that works on them needs.
struct StagesOfStep {
    const System& system;
    const CoupledStages& scheme;
    const Stage& step;
    State& state;
    // How equations of joints are asked for: by positions, or by accelerations, here multiplied by Δt², since
    // by positions the schemes lose two orders. Linear ones are met by positions without loss.
    bool asks_for_positions;

    std::size_t count() const { return static_cast<std::size_t>(scheme.stage_count()); }
    double time_of(std::size_t j) const {
        Stage stage = step;
        stage.index = static_cast<int>(j);
        return scheme.stage_time(stage);
    }
    TimeSpan span() const { return {step.step_time, step.time_step}; }
    ConstraintRequest request() const {
        if (asks_for_positions) return {ConstraintLevel::position, span()};
        return {ConstraintLevel::acceleration, span(), step.time_step * step.time_step};
    }
    // Of tangents, whose equations are all of positions: to them the rows of residuals are converted.
    ConstraintRequest tangent_request() const { return {ConstraintLevel::position, span()}; }
    // By how much positions would have to miss the equations of joints for these rows, to first order.
    std::vector<std::vector<double>> convert_rows(const std::vector<Residual>& residuals) const;

    // Makes a stage the trial while work() is called.
    template <class Work>
    void with_stage(std::size_t j, const Work& work) const {
        struct Exchange {
            Exchange(State& state_, std::size_t j_) : state(state_), j(j_) { exchange(); }
            ~Exchange() { exchange(); }
            void exchange() const {
                state.trial.swap(state.stage_motions[j]);
                state.joints_trial.swap(state.stage_joints[j]);
            }
            State& state;
            std::size_t j;
        };
        const Exchange exchanged(state, j);
        state.trial_time = time_of(j);
        work();
    }
};

}  // namespace gxrod
