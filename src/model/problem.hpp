#pragma once

#include <string>
#include <vector>

#include "model/bodies/body_outline.hpp"
#include "model/deck_record.hpp"
#include "model/model.hpp"
#include "model/settings/settings.hpp"
#include "model/settings/signal_plan.hpp"
#include "model/settings/stage.hpp"

namespace gxrod {

// The input of a run: a model and the requests for it. Copies share functions of time and inputs, so each run
// has its own problem.
struct Problem {
    DeckRecord record;
    Model model;                    // with the actions of the first stage
    std::vector<StagePlan> stages;  // at least one
    OutputSettings output;
    std::vector<SignalPlan> signals;
    std::vector<std::string> notes;     // choices that the reader made for the user, a line each
    std::vector<BodyOutline> outlines;  // of each body, for pictures alone

    const AnalysisSettings& analysis() const {
        return stages.front().analysis;
    }  // the analysis of the first stage
};

}  // namespace gxrod
