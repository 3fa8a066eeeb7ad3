#include "solvers/steps/step_sequence.hpp"

#include "integrators/integrator.hpp"
#include "solvers/steps/error_control.hpp"
#include "solvers/steps/step_control.hpp"

namespace gxrod {

std::unique_ptr<StepSequence> make_step_sequence(const DynamicSettings& settings) {
    if (!settings.adaptive) return std::make_unique<StepControl>(settings.end_time, settings.steps);
    const double first_step = settings.time_step();
    const int order = make_integrator(settings)->error_order();
    return std::make_unique<ErrorControl>(settings.end_time, first_step, order, *settings.adaptive);
}

}  // namespace gxrod
