// Stands before the C library's sine (LD_PRELOAD):
//
//   SINE_DRIFT   by how much more each sine is off than the last, in units of 1e-15 of it: a program that
//   computes
//                with it gets other results, and others whenever it repeats what it does
#include <atomic>
#include <cmath>

#include "shim_symbols.hpp"

namespace {

using namespace gxrod::faults;

constexpr double unit = 1e-15;

const long drift = read_number("SINE_DRIFT", 0);
std::atomic<long> asked{0};

}  // namespace

extern "C" double sin(double angle) noexcept {
    static const auto real_sine = real(static_cast<double (*)(double)>(nullptr), "sin");
    return real_sine(angle) * (1.0 + unit * static_cast<double>(++asked * drift));
}
