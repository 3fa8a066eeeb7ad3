#include "progress_line.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "say.hpp"

namespace gxrod {

std::string describe_duration(double seconds) {
    if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
    if (seconds < 60.0) return fmt::format("{:.0f} s", seconds);
    if (seconds < 3600.0) return fmt::format("{:.0f} min", seconds / 60.0);
    return fmt::format("{:.1f} h", seconds / 3600.0);
}

ProgressLine::ProgressLine()
    : is_terminal_(isatty(STDERR_FILENO) == 1), interval_(is_terminal_ ? 0.1 : 10.0) {}

void ProgressLine::show(const Progress& progress) {
    const auto record = [&] {
        pace_.record(std::chrono::duration<double>(Clock::now() - start_).count(), progress.part);
    };
    if (!std::exchange(has_begun_, true)) record();
    show([&] {
        record();
        return describe(progress, pace_.seconds_left());
    });
}

void ProgressLine::show(const std::function<std::string()>& describe) {
    const Clock::time_point now = Clock::now();
    if (now - last_ < interval_) return;
    last_ = now;
    const std::string line = describe();
    if (is_terminal_) {
        say(stderr, "\r{}\033[K", line);
        std::fflush(stderr);
        has_line_ = true;
    } else {
        say(stderr, "{}\n", line);
    }
}

void ProgressLine::finish() {
    if (has_line_) say(stderr, "\r\033[K");
    has_line_ = false;
}

std::string describe(const Progress& progress, double seconds_left) {
    const std::string left = seconds_left >= 0.0 ? describe_duration(seconds_left) + " left" : "";
    const std::string all = progress.steps > 0 ? fmt::format("/{}", progress.steps) : "";
    const std::string stage = progress.stage.empty() ? "" : progress.stage + ": ";
    return fmt::format("{}step {}{}  t = {:.6g}  Δt = {:.4g}  {} Newton iterations  {}",
                       stage,
                       progress.step,
                       all,
                       progress.time,
                       progress.time_step,
                       progress.newton_iterations,
                       left);
}

}  // namespace gxrod
