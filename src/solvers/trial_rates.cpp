#include "solvers/trial_rates.hpp"

namespace gxrod {

void update_trial_rates(const System& system,
                        const Integrator& integrator,
                        const Stage& stage,
                        State& state) {
    integrator.update_rates(state, stage, system.team());
    if (integrator.is_static()) return;
    system.supports().set_rates(
        integrator.stage_time(stage), {stage.step_time, stage.time_step}, state.trial);
}

}  // namespace gxrod
