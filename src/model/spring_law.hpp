#pragma once

#include <functional>
#include <utility>

namespace gxrod {

// A force along a spring as a function of its length and of the rate of that; tension positive.
// Calling one law from two threads at once is not allowed (an expression evaluates in place).
class SpringLaw {
  public:
    using Force = std::function<double(double length, double rate)>;  // can be NaN where it has no value

    // `start`: the spring's length at t = 0, from which the law's energy counts.
    SpringLaw(Force force, bool has_rate, double start)
        : force_(std::move(force)), has_rate_(has_rate), start_(start) {}

    double operator()(double length, double rate) const { return force_(length, rate); }
    // Whether the force depends on the rate.
    bool has_rate() const { return has_rate_; }
    double start() const { return start_; }

    // Derivatives, by central differences: on a kink the mean of both sides.
    double differentiate_by_length(double length, double rate) const;
    // `rates`: how fast the rate changes where the length does, 1/time; it gives the difference its size
    // where the spring stands still.
    double differentiate_by_rate(double length, double rate, double rates) const;

  private:
    Force force_;
    bool has_rate_;
    double start_;
};

}  // namespace gxrod
