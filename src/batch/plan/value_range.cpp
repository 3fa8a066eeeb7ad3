#include "batch/plan/value_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace gxrod {
namespace {

// Without the round-off of its last digit: 0.01 for 0.010000000000000002.
double round_off(double number) {
    const std::string text = fmt::format("{:.15g}", number);
    double rounded = number;
    std::from_chars(text.data(), text.data() + text.size(), rounded);
    return rounded;
}

}  // namespace

std::string write_number(double number) {
    constexpr double exactly_whole = 9007199254740992.0;  // 2^53
    if (std::abs(number) < exactly_whole && number == std::floor(number) && !std::signbit(number)) {
        return fmt::format("{}", static_cast<long>(number));
    }
    return fmt::format("{}", number);
}

std::vector<double> space_out(double from, double to, long count, Spacing spacing) {
    std::vector<double> exact;
    std::vector<double> rounded;
    for (long i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count - 1);
        exact.push_back(spacing == Spacing::linear ? from * (1.0 - part) + to * part
                                                   : from * std::exp(std::log(to / from) * part));
        rounded.push_back(round_off(exact.back()));
    }
    for (std::vector<double>* numbers : {&exact, &rounded}) {
        numbers->front() = from;
        numbers->back() = to;
    }
    const bool is_distinct = std::adjacent_find(rounded.begin(), rounded.end()) == rounded.end();
    return is_distinct ? rounded : exact;
}

}  // namespace gxrod
