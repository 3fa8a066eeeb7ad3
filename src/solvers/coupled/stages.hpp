#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "integrators/coupled_stages.hpp"
#include "solvers/equilibrium.hpp"
#include "state/contact_trial.hpp"

namespace gxrod {

// The stages of one step of a scheme that finds them together, with the data that work on them needs.
struct StagesOfStep {
    const System& system;
    const CoupledStages& scheme;
    const Stage& step;
    State& state;
    // Whether equations of joints are met by positions, or by accelerations times Δt², since by positions the
    // schemes lose two orders. Linear equations are met by positions without loss.
    bool asks_for_positions;
    // Each stage's parameters of contact in Newton's method; empty if nothing can touch.
    std::vector<ContactTrial>& contacts;
    // Called when a stage becomes the trial, if laws or what is remembered are held for each stage.
    std::function<void(std::size_t stage)> prepare{};

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
    // Returns the request for tangents, all of whose equations are by positions; rows of residuals are
    // converted to these.
    ConstraintRequest tangent_request() const {
        ConstraintRequest request{ConstraintLevel::position, span()};
        if (!asks_for_positions) request.stops = StopChoice::as_before;
        return request;
    }
    // Computes, to first order, by how much positions would miss the equations of joints to give these rows.
    std::vector<std::vector<double>> convert_rows(const std::vector<Residual>& residuals) const;

    // Makes a stage the trial while work() is called.
    template <class Work>
    void with_stage(std::size_t j, const Work& work) const {
        struct Exchange {
            Exchange(State& state_, std::vector<ContactTrial>& contacts_, std::size_t j_)
                : state(state_), contacts(contacts_), j(j_) {
                exchange();
            }
            ~Exchange() { exchange(); }
            void exchange() const {
                state.trial.swap(state.stage_motions[j]);
                state.joints_trial.swap(state.stage_joints[j]);
                if (!contacts.empty()) std::swap(state.contact, contacts[j]);
            }
            State& state;
            std::vector<ContactTrial>& contacts;
            std::size_t j;
        };
        const Exchange exchanged(state, contacts, j);
        state.trial_time = time_of(j);
        if (prepare) prepare(j);
        work();
    }
};

}  // namespace gxrod
