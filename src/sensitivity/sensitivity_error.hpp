#pragma once

#include <stdexcept>

namespace gxrod {

// The derivative of a step cannot be found, though the step itself can; its text says why.
class SensitivityError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace gxrod
