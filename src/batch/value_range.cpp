#include "batch/value_range.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace gxrod {
namespace {

// Without the round-off of its last digit: 0.01 for 0.010000000000000002.
double round_off(double number) { return std::stod(fmt::format("{:.15g}", number)); }

}  // namespace

std::string write_number(double number) {
    constexpr double exactly_whole = 9007199254740992.0;  // 2^53
    if (std::abs(number) < exactly_whole && number == std::floor(number) && !std::signbit(number)) {
        return fmt::format("{}", static_cast<long>(number));
    }
    return fmt::format("{}", number);
}

std::vector<double> space_out(double from, double to, long count, Spacing spacing) {
    std::vector<double> numbers;
    for (long i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count - 1);
        const double number = spacing == Spacing::linear ? from + (to - from) * part
                                                         : from * std::exp(std::log(to / from) * part);
        numbers.push_back(round_off(number));
    }
    numbers.front() = from;
    numbers.back() = to;
    return numbers;
}

}  // namespace gxrod
