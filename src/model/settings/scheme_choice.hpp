#pragma once

#include <optional>
#include <string>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

// Which integrator a motion takes where the deck leaves it open. The rules follow from measurements
// (docs/verification/work_precision.md).
namespace gxrod {

struct SchemeChoice {
    Scheme scheme = Scheme::radau_5;
    std::string reason;  // "for rods in water, in wind or on the ground"
};

// A joint or tendon with friction, "joint brake"; "" if there is none. Where one sticks or slips, estimates
// of the errors of schemes of high order were seen to miss what that does.
std::string find_friction(const Model& model);

// By the model and the accuracy that the deck asks for, if it does: what a run that is resumed cannot
// change, as it can its steps. Of schemes that estimate the error of a step.
SchemeChoice choose_scheme(const Model& model, std::optional<double> accuracy);

}  // namespace gxrod
