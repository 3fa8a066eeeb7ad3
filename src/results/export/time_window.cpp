#include "results/export/time_window.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "machine/file_error.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double same_window_time = 1e-9;  // relative

// The times of a stage, with that at which it starts.
TimeWindow find_stage_window(const Hdf5Reader& file,
                             const std::filesystem::path& results,
                             const std::string& stage,
                             const std::vector<double>& times) {
    const std::string path = "/stages/" + stage;
    if (!file.has("/stages") || !file.has(path)) {
        const std::vector<std::string> known =
            file.has("/stages") ? file.members("/stages") : std::vector<std::string>{};
        throw FileError(
            results,
            "has no stage " + stage,
            known.empty() ? "its deck has no stages" : fmt::format("it has {}", fmt::join(known, ", ")));
    }
    const auto number = static_cast<double>(file.integer_attribute(path, "number"));
    const std::vector<double> stages = file.numbers("/histories/stage");
    const std::size_t rows = std::min(stages.size(), times.size());
    std::size_t first = 0;
    while (first < rows && stages[first] != number) ++first;
    if (first == rows) throw FileError(results, "has no steps of stage " + stage);
    std::size_t last = first;
    while (last + 1 < rows && stages[last + 1] == number) ++last;
    return {times[first > 0 ? first - 1 : 0], times[last]};
}

}  // namespace

bool is_of_load_factors(const Hdf5Reader& file) {
    return file.text_attribute("/histories/time", "dimension") == "1";
}

TimeWindow find_window(const Hdf5Reader& file,
                       const std::filesystem::path& results,
                       const WindowRequest& request) {
    const std::vector<double> times = file.numbers("/histories/time");
    if (times.empty()) throw FileError(results, "has no complete step yet");
    TimeWindow window{times.front(), times.back()};
    if (!request.stage.empty())
        window = find_stage_window(file, results, request.stage, times);
    else if (!is_of_load_factors(file) && window.first < 0.0 && window.last > 0.0)
        window.first = 0.0;
    window.first = request.from.value_or(window.first);
    window.last = request.to.value_or(window.last);
    if (list_rows(times, window).empty()) {
        throw FileError(results,
                        fmt::format("has no step from {:.10g} to {:.10g}", window.first, window.last),
                        fmt::format("its steps are from {:.10g} to {:.10g}", times.front(), times.back()));
    }
    return window;
}

std::vector<std::size_t> list_rows(const std::vector<double>& times, const TimeWindow& window) {
    const double slack = same_window_time * (std::abs(window.first) + std::abs(window.last));
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < times.size(); ++row) {
        if (times[row] >= window.first - slack && times[row] <= window.last + slack) rows.push_back(row);
    }
    return rows;
}

RangeOfNumbers::RangeOfNumbers()
    : least(not_a_number),
      time_of_least(not_a_number),
      largest(not_a_number),
      time_of_largest(not_a_number) {}

void RangeOfNumbers::add(double time, double number) {
    if (std::isnan(number)) return;
    if (count_ == 0 || number < least) {
        least = number;
        time_of_least = time;
    }
    if (count_ == 0 || number > largest) {
        largest = number;
        time_of_largest = time;
    }
    sum_ += number;
    ++count_;
}

double RangeOfNumbers::mean() const { return count_ > 0 ? sum_ / static_cast<double>(count_) : not_a_number; }

}  // namespace gxrod
