#include "analyses/dynamic.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "analyses/start_velocities.hpp"
#include "integrators/quasi_static.hpp"
#include "model/settings/newton_choice.hpp"
#include "model/time/jumps.hpp"

namespace gxrod {

namespace {

// Of a step: for so long what is damped creeps while the model settles.
constexpr double settling_part = 1e-4;
// Of the time, to look for jumps of functions.
constexpr long fewest_samples = 64;
constexpr long most_samples = 1000;

}  // namespace

std::unique_ptr<Integrator> make_scheme(const DynamicSettings& settings) {
    return settings.has_inertia ? make_integrator(settings) : std::make_unique<QuasiStatic>();
}

DynamicAnalysis::DynamicAnalysis(const Model& model, const DynamicSettings& settings, int threads)
    : SteppedAnalysis(model,
                      threads,
                      make_scheme(settings),
                      choose_newton(model, settings),
                      settings.linear_solver,
                      make_step_sequence(settings)),
      projects_start_(settings.projects_start),
      times_{0.0, settings.end_time},
      samples_(static_cast<int>(std::clamp(settings.steps, fewest_samples, most_samples))) {}

EquilibriumReport DynamicAnalysis::start() {
    if (!system_.model().has_inertia) {
        // What acts at once, actuation too, strains no law before rods have given way to it, if they do.
        const std::span<double> memory = system_.memory_within_rods().of(state_);
        std::vector<double> kept(memory.begin(), memory.end());
        start_at_rest();
        std::ranges::swap_ranges(kept, memory);
        find_jumps();
        const EquilibriumReport report = settle();
        if (report.converged() && settled() == nullptr)
            std::ranges::copy(kept, system_.memory_within_rods().of(state_).begin());
        return report;
    }
    refuse_overlaps(0.0);
    const TimeSpan first_step{0.0, steps_->time_step()};
    fit_start_velocities(system_, 0.0, first_step, projects_start_ || takes_over_rates(), workspace_, state_);
    const EquilibriumReport report = solve_accelerations(system_, 0.0, first_step, workspace_, state_);
    if (report.converged()) accept_start();
    find_jumps();
    return report;
}

void DynamicAnalysis::find_jumps() {
    const Model& model = system_.model();
    std::vector<double> ends;
    if (!model.has_inertia) ends = gxrod::find_jumps(model, times_, samples_);
    for (const Joint& joint : model.joints) {
        const std::optional<double>& time = joint.strength.time;
        if (time && joint.acts && *time < times_.to) ends.push_back(*time);
    }
    std::ranges::sort(ends);
    set_jumps(std::move(ends));
}

Stage DynamicAnalysis::settling_stage() const {
    const double time = steps_->time();
    return {0, time, settling_part * steps_->time_step(), time + 4.0 * sides_of_jump(0.0, times_).after};
}

// Inputs can have been set here.
bool DynamicAnalysis::settles_here() const {
    if (system_.model().has_inertia) return false;
    return !system_.model().inputs.empty() || find_jump_at(steps_->time());
}

double DynamicAnalysis::trial_time() const {
    const double end = steps_->next_time();
    if (system_.model().has_inertia) return end;
    const std::optional<double> jump = find_jump_at(end);
    return jump ? sides_of_jump(std::min(*jump, end), times_).before : end;
}

std::optional<double> DynamicAnalysis::find_jump_at(double time) const {
    const double close = 1e-9 * steps_->time_step();
    for (const double jump : jumps()) {
        if (std::abs(jump - time) <= close) return jump;
    }
    return std::nullopt;
}

}  // namespace gxrod
