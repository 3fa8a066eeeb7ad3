#include "run/run.hpp"

#include "machine/phase_timer.hpp"
#include "run/stepped_run.hpp"

namespace gxrod {

RunSummary run_analysis(const RunRequest& request) {
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
        simulation.close();
        summary = simulation.summary();
    }
    summary.wall_seconds = seconds;
    return summary;
}

}  // namespace gxrod
