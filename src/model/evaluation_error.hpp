#pragma once

#include <stdexcept>

namespace gxrod {

// A request of a deck that a run cannot fulfil: a function of time without a finite value at some time, or
// initial velocities that joints do not allow. what() names it.
class EvaluationError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace gxrod
