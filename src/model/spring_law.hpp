#pragma once

#include <functional>
#include <utility>

namespace gxrod {

// A force along a spring as a function of its length and the rate of its length; tension positive. Not for
// two threads at once (an expression evaluates in place).
class SpringLaw {
  public:
    using Force = std::function<double(double length, double rate)>;  // can be NaN if it has no value

    // `start` is the spring's length at t = 0, from which the law's energy counts.
    SpringLaw(Force force, bool has_rate, double start)
        : force_(std::move(force)), has_rate_(has_rate), start_(start) {}

    double operator()(double length, double rate) const { return force_(length, rate); }
    // Whether the force depends on the rate.
    bool has_rate() const { return has_rate_; }
    double start() const { return start_; }

    // Differentiates by central differences: at a kink the result is the mean of both sides.
    double differentiate_by_length(double length, double rate) const;
    // Differentiates likewise. `rates` is the change of the rate per change of length, 1/time; it sets the
    // size of the difference for a spring at rest.
    double differentiate_by_rate(double length, double rate, double rates) const;

  private:
    Force force_;
    bool has_rate_;
    double start_;
};

}  // namespace gxrod
