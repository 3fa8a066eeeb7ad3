#pragma once

#include <optional>
#include <vector>

#include "face/derivatives.hpp"
#include "model/time/input.hpp"

namespace gxrod {

// A call keeps what the driver of a run asked of a step, so that it can be repeated: where to land, on the
// axis that stages share, and the state of each input.
struct StepCall {
    std::optional<double> landing;
    std::vector<InputState> inputs;
};

// Derivatives of a sum by numbers of the deck and, for each accepted state and each input that was asked for,
// by its value at the end of the step; at t = 0 for the first.
struct SweptGradient {
    std::vector<double> by_numbers;
    std::vector<std::vector<double>> by_inputs;
};

// Finds derivatives of a weighted sum of what was recorded at the accepted states of a run, by multipliers
// that go back through its steps. Weights of a quantity are for the last state or, if there are as many, for
// each in turn. The steps are repeated twice, to the last bit, and about 2 √n of n states are kept. Throws
// std::invalid_argument if there are none, std::runtime_error if the steps cannot be repeated.
SweptGradient sweep_back(const SteppedRun& run,
                         const std::vector<StepCall>& calls,
                         const std::vector<WeightedQuantity>& sum,
                         const std::vector<VariedNumber>& variations,
                         const std::vector<std::size_t>& inputs);

}  // namespace gxrod
