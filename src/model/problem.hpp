#pragma once

#include <string>
#include <vector>

#include "model/deck_record.hpp"
#include "model/model.hpp"
#include "model/settings/settings.hpp"
#include "model/settings/stage.hpp"

namespace gxrod {

// What is run: a model and what is asked of it. Functions of time and inputs are shared by copies of one, so
// each run has a problem of its own.
struct Problem {
    DeckRecord record;
    Model model;                    // with the actions of the first stage
    std::vector<StagePlan> stages;  // at least one
    OutputSettings output;
    std::vector<std::string> notes;  // choices that the reader made for the user, a line each

    const AnalysisSettings& analysis() const {
        return stages.front().analysis;
    }  // the analysis of the first stage
};

}  // namespace gxrod
