#pragma once

#include <stdexcept>

namespace gxrod {

// The derivative of a step cannot be found, though the step itself can; its text says why.
class SensitivityError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// The motion has no derivative from this step on; its text says what happens in it.
class KinkError : public SensitivityError {
  public:
    using SensitivityError::SensitivityError;
};

// A small change of a number closes a gap of contact, whose forces are not defined there.
class ClosedGapError : public KinkError {
  public:
    using KinkError::KinkError;
};

}  // namespace gxrod
