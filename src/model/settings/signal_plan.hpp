#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "model/time/input.hpp"

namespace gxrod {

// A controller of an error e: proportional e + integral ∫ e dt + derivative ė.
struct PidGains {
    double proportional = 0.0;
    double integral = 0.0;
    double derivative = 0.0;
};

// A signal, [signal.NAME]: a number that a run sets after each step by what it measures, for the next step.
struct SignalPlan {
    // A component of a quantity of a history.
    struct Measure {
        std::size_t history = 0;
        std::string quantity;
        std::size_t column = 0;
    };

    std::string name;
    std::shared_ptr<Input> input;
    std::optional<Measure> measure;
    TimeFunction value;           // without a measure; of time, inputs and other signals
    double filter = 0.0;          // time constant of a low pass of the first order; 0: none
    bool is_rate = false;         // the rate of change of that
    bool is_continuous = false;   // follows what it measures within each step, not one step later
    std::optional<PidGains> pid;  // the controller's output, that being the error
    std::optional<double> lower, upper;
};

}  // namespace gxrod
