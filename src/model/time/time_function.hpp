#pragma once

#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

// A number on which a function's form depends: the function may jump or have a kink where the number crosses
// a knot, and is smooth between knots. For "s < 2*t ? 1 : 0" the number is s − 2 t and the knot 0; for a
// table, the number is its argument and the knots are its rows.
struct Switch {
    std::function<double(double time, double s)> argument;  // can be NaN if the function does not need it
    std::vector<double> knots{0.0};                         // increasing
    bool has_time = true;
    bool has_arc_length = true;
    bool is_variable = false;  // the argument is the time or the arc length itself
};

// Arguments on which another depends come before it.
using Switches = std::vector<Switch>;

// A number that can change with time: the value of a deck key that takes f(t). Not for two threads at once
// (an expression evaluates in place).
class TimeFunction {
  public:
    TimeFunction(double constant = 0.0) : constant_(constant) {}
    // `has_time`: whether t occurs in its form; a number that changes for another reason, like an input, may
    // not have it.
    explicit TimeFunction(std::function<double(double)> function,
                          std::shared_ptr<const Switches> switches = nullptr,
                          bool has_time = true)
        : function_(std::move(function)), switches_(std::move(switches)), has_time_(has_time) {}

    double operator()(double time) const { return function_ ? function_(time) : constant_; }
    bool is_constant() const { return !function_; }
    bool has_time() const { return function_ && has_time_; }
    // Whether the value is the constant 0, so that such a load need not be evaluated.
    bool is_zero() const { return !function_ && constant_ == 0.0; }
    // nullptr if the function is smooth everywhere.
    const std::shared_ptr<const Switches>& switches() const { return switches_; }

  private:
    double constant_ = 0.0;
    std::function<double(double)> function_;
    std::shared_ptr<const Switches> switches_;
    bool has_time_ = false;
};

// The dependence on time of a function of time and place.
enum class InTime {
    constant,      // f(s)
    proportional,  // t f(s)
    varying
};

// Known properties of a function of time and place.
struct LineForm {
    InTime in_time = InTime::varying;
    bool is_even = false;  // constant along the rod
};

// A number that can change with time and along a rod, f(t, s), s the arc length from the rod's start.
class LineFunction {
  public:
    LineFunction(double constant = 0.0) : constant_(constant) {}
    explicit LineFunction(std::function<double(double, double)> function,
                          std::shared_ptr<const Switches> switches = nullptr,
                          LineForm form = {})
        : function_(std::move(function)), switches_(std::move(switches)), form_(form) {}

    double operator()(double time, double s) const { return function_ ? function_(time, s) : constant_; }
    bool is_constant() const { return !function_; }
    bool is_zero() const { return !function_ && constant_ == 0.0; }
    const std::shared_ptr<const Switches>& switches() const { return switches_; }
    const LineForm& form() const { return form_; }

  private:
    double constant_ = 0.0;
    std::function<double(double, double)> function_;
    std::shared_ptr<const Switches> switches_;
    LineForm form_{InTime::constant, true};
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
    const std::array<TimeFunction, 3>& components() const { return components_; }

  private:
    std::array<TimeFunction, 3> components_;
};

}  // namespace gxrod
