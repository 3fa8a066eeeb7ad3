#include "run/run.hpp"

#include "machine/phase_timer.hpp"
#include "run/run_to_end.hpp"

namespace gxrod {

RunSummary run_analysis(const RunRequest& request) {
    return run_to_end(request, [](const SteppedRun&) {});
}

RunSummary run_to_end(const RunRequest& request, const std::function<void(const SteppedRun&)>& at_end) {
    double seconds = 0.0;
    RunSummary summary;
    {
        const PhaseTimer timer(seconds);
        SteppedRun simulation(request);
        simulation.start();
        while (!simulation.has_ended()) {
            if (request.is_interrupted())
                simulation.interrupt();
            else
                simulation.step();
        }
        try {
            at_end(simulation);
        } catch (...) {
            simulation.close();  // what it has computed is whole, whatever cannot be made of it
            throw;
        }
        simulation.close();
        summary = simulation.summary();
    }
    summary.wall_seconds = seconds;
    return summary;
}

}  // namespace gxrod
