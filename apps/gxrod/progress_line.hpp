#pragma once

#include <chrono>
#include <string>

#include "analyses/run.hpp"

namespace gxrod {

// Shows how a run goes, on standard error: a terminal gets one line that is rewritten ten times a second, a
// pipe a line every ten seconds.
class ProgressLine {
  public:
    ProgressLine();
    void show(const Progress& progress);
    // Leaves the terminal's line behind.
    void finish();

  private:
    using Clock = std::chrono::steady_clock;

    bool is_terminal_;
    bool has_line_ = false;
    std::chrono::duration<double> interval_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
};

// "step 120/1500  t = 1.2  Δt = 0.01  3 Newton iterations  12 s left"
std::string describe(const Progress& progress, double elapsed_seconds);

}  // namespace gxrod
