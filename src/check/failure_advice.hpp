#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solvers/equilibrium.hpp"

namespace gxrod {

// The facts that a message reports about an equilibrium that was not found.
struct Failure {
    enum class Phase { initial_accelerations, implicit_step, explicit_step, load_step, instant };

    Phase phase = Phase::implicit_step;
    Outcome outcome = Outcome::out_of_iterations;
    double time = 0.0;       // start of the step: time, or the load factor
    double time_step = 0.0;  // the shortest step that was tried
    int iterations = 0;
    double residual = 0.0;            // relative to the largest force or moment
    double step_error = 0.0;          // the estimate, for error_too_large
    bool limits_energy = false;       // whether steps must not gain energy
    std::vector<std::string> places;  // "flyer.end (ry)", the worst first
    std::vector<std::int64_t> nodes;  // nodes of those places
    std::string shrunk_spring;        // a spring with almost no length, if forces are not finite; or ""
    std::string open_joint;           // "joint shaft", the joint with the largest error; "" if all are closed
    double joint_gap = 0.0;           // error of that joint: relative to the model's length, or in rad
    std::string weakness;             // in words; "" unless the tangent is singular or nearly so
    // Sentences saying that round-off of a stiff rod's forces hides the bending of a soft rod, with advice.
    // This is a likelier reason than a weakness, with which it could be confused. Both are "" if it does not
    // apply.
    std::string contrast;
    std::string contrast_advice;
};

// Advises what to try, the likeliest remedy first, in the words of a deck.
std::vector<std::string> advise(const Failure& failure);

// Describes the whole failure, ending with the advice: "the step from t = 0.3 failed, even with Δt = 9.8e-05:
// Newton's method did not converge in 20 iterations; the residual, 3.1e-02 of the largest force or moment, is
// largest at flyer.end (ry), flyer node 14 (x). Try a smaller time_step; …".
std::string describe_failure(const Failure& failure);

}  // namespace gxrod
