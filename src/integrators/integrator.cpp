#include "integrators/integrator.hpp"

#include "integrators/coupled_stages.hpp"
#include "integrators/energy_momentum.hpp"
#include "integrators/generalized_alpha.hpp"
#include "integrators/newmark_ibrahimbegovic.hpp"
#include "integrators/newmark_simplified.hpp"
#include "integrators/runge_kutta_4.hpp"
#include "integrators/sdirk_4.hpp"

namespace gxrod {

std::unique_ptr<Integrator> make_integrator(const DynamicSettings& settings) {
    const Newmark newmark{settings.beta, settings.gamma};
    switch (settings.scheme) {
        case Scheme::newmark_ibrahimbegovic:
            return std::make_unique<NewmarkIbrahimbegovic>(newmark);
        case Scheme::generalized_alpha:
            return std::make_unique<GeneralizedAlpha>(settings.spectral_radius);
        case Scheme::sdirk_4:
            return std::make_unique<Sdirk4>();
        case Scheme::radau_5:
            return std::make_unique<CoupledStages>(CoupledStages::make_radau_5());
        case Scheme::gauss_4:
            return std::make_unique<CoupledStages>(CoupledStages::make_gauss_4());
        case Scheme::energy_momentum:
            return std::make_unique<EnergyMomentum>();
        case Scheme::runge_kutta_4:
            return std::make_unique<RungeKutta4>();
        case Scheme::newmark_simplified:
            break;
    }
    return std::make_unique<NewmarkSimplified>(newmark);
}

StepError measure_step_error(const std::vector<Vec6>& placements,
                             const std::vector<Vec6>& rates,
                             const NodeLengths& lengths) {
    StepError error;
    for (std::size_t i = 0; i < placements.size(); ++i) {
        const double length = lengths(static_cast<int>(i));
        for (int first = 0; first < 6; first += 3) {
            for (const Vec6* part : {&placements[i], &rates[i]}) {
                // Lengths, so that steps do not depend on the model's orientation.
                const Vec3 value = part->segment<3>(first) / (first == 0 ? length : 1.0);
                const double size = value.norm();
                if (!(size > error.size)) continue;
                int component = 0;
                value.cwiseAbs().maxCoeff(&component);
                error = {size, static_cast<int>(i), first + component};
            }
        }
    }
    return error;
}

void Integrator::begin_stage(State& state, const Stage& stage, const ThreadTeam& team) const {
    state.trial_time = stage_time(stage);
    if (kept_stages() > 0) {
        state.stages.resize(kept_stages());
        for (std::vector<StageRates>& rates : state.stages) rates.resize(state.trial.size());
    }
    team.for_each_range(state.trial.size(), [&](std::size_t first, std::size_t last) {
        place_nodes(state, stage, {first, last});
    });
}

void Integrator::update_rates(State& state, const Stage& stage, const ThreadTeam& team) const {
    team.for_each_range(state.trial.size(), [&](std::size_t first, std::size_t last) {
        update_nodes(state, stage, {first, last});
    });
}

void Integrator::linearize(const State& state,
                           const Stage& stage,
                           std::vector<NodeLinearization>& linearizations,
                           const ThreadTeam& team) const {
    linearizations.resize(state.trial.size());
    team.for_each_range(linearizations.size(), [&](std::size_t first, std::size_t last) {
        linearize_nodes(state, stage, {first, last}, linearizations);
    });
}

void Integrator::linearize_as_paper(const State& state,
                                    const Stage& stage,
                                    std::vector<NodeLinearization>& linearizations,
                                    const ThreadTeam& team) const {
    linearizations.resize(state.trial.size());
    team.for_each_range(linearizations.size(), [&](std::size_t first, std::size_t last) {
        linearize_nodes_as_paper(state, stage, {first, last}, linearizations);
    });
}

void Integrator::end_stage(State& state, const Stage& stage, const ThreadTeam& team) const {
    team.for_each_range(state.trial.size(), [&](std::size_t first, std::size_t last) {
        finish_nodes(state, stage, {first, last});
    });
}

NodeLinearization mass_linearization() {
    NodeLinearization mass;
    mass.acceleration = 1.0;
    mass.d_alpha.setIdentity();
    return mass;
}

std::vector<NodeLinearization> mass_linearizations(std::size_t node_count) {
    return std::vector<NodeLinearization>(node_count, mass_linearization());
}

}  // namespace gxrod
