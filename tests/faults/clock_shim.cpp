// Stands before the C library's clocks (LD_PRELOAD):
//
//   CLOCK_TICK   microseconds that the clock for durations advances each time it is asked, whatever time it
//   is:
//                what a program does after so many seconds, it then does at the same place in every run
//   CLOCK_JUMPS  1: the wall clock leaps by up to years each time it is asked, forth and back
#include <sys/time.h>

#include <atomic>
#include <ctime>

#include "shim_symbols.hpp"

namespace {

using namespace gxrod::faults;

constexpr long microseconds = 1000000;
constexpr std::time_t year = 31557600;

const long tick = read_number("CLOCK_TICK", 0);
const bool is_jumping = is_chosen("CLOCK_JUMPS", "1");
std::atomic<long> asked{0};
std::atomic<long> leaps{0};

// Forth and back in turns, farther each time, by three years at most.
std::time_t leap() {
    if (!is_jumping) return 0;
    const long count = ++leaps;
    return (count % 2 == 0 ? 1 : -1) * (year / 100) * (count % 300);
}

bool is_wall_clock(clockid_t clock) { return clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE; }

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* now) noexcept {
    static const auto real_clock = real(&::clock_gettime, "clock_gettime");
    if (clock == CLOCK_MONOTONIC && tick > 0) {
        const long elapsed = ++asked * tick;
        *now = {1000 + elapsed / microseconds, elapsed % microseconds * 1000};
        return 0;
    }
    const int result = real_clock(clock, now);
    if (result == 0 && is_wall_clock(clock)) now->tv_sec += leap();
    return result;
}

int gettimeofday(timeval* now, void* zone) noexcept {
    static const auto real_clock = real(&::gettimeofday, "gettimeofday");
    const int result = real_clock(now, zone);
    if (result == 0) now->tv_sec += leap();
    return result;
}

std::time_t time(std::time_t* now) noexcept {
    static const auto real_clock = real(&::time, "time");
    const std::time_t result = real_clock(nullptr) + leap();
    if (now) *now = result;
    return result;
}
}
