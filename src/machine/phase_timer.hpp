#pragma once

#include <chrono>

namespace gxrod {

// Wall-clock seconds of the phases of a run.
struct PhaseSeconds {
    double setup = 0.0;     // building the system and ordering its equations
    double assembly = 0.0;  // residuals and tangents
    double solve = 0.0;     // factorizing and substituting
    double update = 0.0;    // moving nodes, rates, committing
    double output = 0.0;    // ledger, histories, frames

    PhaseSeconds& operator+=(const PhaseSeconds& other) {
        setup += other.setup;
        assembly += other.assembly;
        solve += other.solve;
        update += other.update;
        output += other.output;
        return *this;
    }
};

// Adds the time from its construction to its destruction to a total.
class PhaseTimer {
  public:
    explicit PhaseTimer(double& seconds) : seconds_(seconds), start_(Clock::now()) {}
    ~PhaseTimer() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
    PhaseTimer(const PhaseTimer&) = delete;
    PhaseTimer& operator=(const PhaseTimer&) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    double& seconds_;
    Clock::time_point start_;
};

}  // namespace gxrod
