#pragma once

#include <stdexcept>

namespace gxrod {

// A function of time that has no finite value at some time of a run. what() names the key and the time.
class EvaluationError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace gxrod
