#pragma once

#include <string>

#include "model/model.hpp"
#include "model/settings.hpp"

// Which integrator a motion takes where the deck leaves it open (docs/verification/work_precision.md).
namespace gxrod {

struct SchemeChoice {
    Scheme scheme = Scheme::radau_5;
    std::string reason;  // "joint brake rubs, and what jumps wants short steps"
};

// By the model alone, so that a run that is resumed with other steps takes the same one. It estimates the
// error of its steps.
SchemeChoice choose_scheme(const Model& model);

}  // namespace gxrod
