#pragma once

#include <array>
#include <string>

#include "model/problem.hpp"
#include "sensitivity/forward_sensitivity.hpp"

namespace gxrod {

class Deck;

// Problems of a deck in which one number differs, for derivatives by it.
struct VariedNumber {
    std::string name;
    std::array<Problem, 4> problems;  // with the number plus and minus a step, plus and minus twice the step
    double step = 0.0;

    VariedModels models() const {
        return {{problems[0].model, problems[1].model, step},
                {problems[2].model, problems[3].model, 2.0 * step}};
    }
};

// Builds the problems next to the one that the deck builds. `number`: one of [parameters], or another key
// with a number. Throws UnknownNameError if the deck has none of this name, std::invalid_argument
// if it is not a number.
VariedNumber vary(const Deck& deck, const std::string& number);

}  // namespace gxrod
