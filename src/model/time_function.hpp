#pragma once

#include <functional>
#include <utility>

namespace gxrod {

// A number that may change with time: the value of a deck key that takes f(t).
// Calling one function from two threads at once is not allowed (an expression evaluates in place).
class TimeFunction {
  public:
    TimeFunction(double constant = 0.0) : constant_(constant) {}
    explicit TimeFunction(std::function<double(double)> function) : function_(std::move(function)) {}

    double operator()(double time) const { return function_ ? function_(time) : constant_; }
    bool is_constant() const { return !function_; }
    // Whether the value is the constant 0, so that a load of it need not be evaluated.
    bool is_zero() const { return !function_ && constant_ == 0.0; }

  private:
    double constant_ = 0.0;
    std::function<double(double)> function_;
};

}  // namespace gxrod
