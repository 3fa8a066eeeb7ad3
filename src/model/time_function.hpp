#pragma once

#include <array>
#include <functional>
#include <utility>

#include "rotation/types.hpp"

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

// A number that may change with time and along a rod, f(t, s), s the arc length from the rod's start.
class LineFunction {
  public:
    LineFunction(double constant = 0.0) : constant_(constant) {}
    explicit LineFunction(std::function<double(double, double)> function) : function_(std::move(function)) {}

    double operator()(double time, double s) const { return function_ ? function_(time, s) : constant_; }
    bool is_zero() const { return !function_ && constant_ == 0.0; }

  private:
    double constant_ = 0.0;
    std::function<double(double, double)> function_;
};

// Whether three functions, of time or of time and place, vanish.
template <class Function>
bool is_zero(const std::array<Function, 3>& functions) {
    return functions[0].is_zero() && functions[1].is_zero() && functions[2].is_zero();
}

// A vector of three functions of time.
class TimeVector {
  public:
    TimeVector(const Vec3& constant) : components_{constant[0], constant[1], constant[2]} {}
    explicit TimeVector(std::array<TimeFunction, 3> components) : components_(std::move(components)) {}

    Vec3 operator()(double time) const {
        return {components_[0](time), components_[1](time), components_[2](time)};
    }
    bool is_constant() const {
        return components_[0].is_constant() && components_[1].is_constant() && components_[2].is_constant();
    }
    bool is_zero() const { return gxrod::is_zero(components_); }

  private:
    std::array<TimeFunction, 3> components_;
};

}  // namespace gxrod
