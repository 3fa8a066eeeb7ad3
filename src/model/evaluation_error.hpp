#pragma once

#include <stdexcept>

namespace gxrod {

// What a deck asks for and a run cannot do: a function of time that has no finite value at some time, initial
// velocities that joints do not allow. what() names it.
class EvaluationError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace gxrod
