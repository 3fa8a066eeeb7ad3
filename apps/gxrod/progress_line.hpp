#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "run/pace.hpp"
#include "run/run.hpp"

namespace gxrod {

// Shows how a run goes, on standard error: a terminal gets one line that is rewritten ten times a second, a
// pipe a line every ten seconds.
class ProgressLine {
  public:
    ProgressLine();
    void show(const Progress& progress);
    // The same with another line, which is made only if it is time to show it.
    void show(const std::function<std::string()>& describe);
    // Leaves the terminal's line behind.
    void finish();

  private:
    using Clock = std::chrono::steady_clock;

    bool is_terminal_;
    bool has_line_ = false;
    bool has_begun_ = false;
    Pace pace_;
    std::chrono::duration<double> interval_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
};

// "12 s", "5 min", "1.5 h"
std::string describe_duration(double seconds);

// "step 120/1500  t = 1.2  Δt = 0.01  3 Newton iterations  12 s left"; negative seconds are not known.
std::string describe(const Progress& progress, double seconds_left);

}  // namespace gxrod
