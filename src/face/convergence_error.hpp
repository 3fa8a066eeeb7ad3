#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "check/failure_advice.hpp"

namespace gxrod {

// A step that failed, or a run that failed otherwise. what() says why and what to try. The run keeps the last
// accepted state.
class ConvergenceError : public std::runtime_error {
  public:
    ConvergenceError(const std::string& reason, std::optional<Failure> of_step)
        : std::runtime_error(reason), failure(std::move(of_step)) {}

    std::optional<Failure> failure;  // of a step
};

// Describes what became of an equilibrium: "out of iterations".
const char* name_of(Outcome outcome);

}  // namespace gxrod
