#pragma once

#include <optional>
#include <string>

#include "model/model.hpp"
#include "model/settings/settings.hpp"

// The choice of an integrator for a motion if the deck leaves it open. The rules follow from measurements
// (docs/verification/work_precision.md).
namespace gxrod {

struct SchemeChoice {
    Scheme scheme = Scheme::radau_5;
    std::string reason;  // "for rods in water, in wind or on the ground"
};

// Names a joint or tendon with friction, "joint brake"; "" if there is none. If one sticks or slips, error
// estimates of schemes of high order were seen to miss the effect.
std::string find_friction(const Model& model);

// Chooses a scheme that estimates the error of a step, by the model and the accuracy in the deck, if given: a
// resumed run can change its steps, but neither of these.
SchemeChoice choose_scheme(const Model& model, std::optional<double> accuracy);

}  // namespace gxrod
