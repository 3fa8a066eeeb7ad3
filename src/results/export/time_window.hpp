#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gxrod {

class Hdf5Reader;

// A request for a part of a run: times, in statics load factors, or the name of a stage. Without any: all
// stages with time, in a run without time everything.
struct WindowRequest {
    std::optional<double> from, to;
    std::string stage;
};

struct TimeWindow {
    double first = 0.0, last = 0.0;
};

// Finds the window. Throws FileError if the results have no step yet or no such stage, or if nothing was
// written in the window.
TimeWindow find_window(const Hdf5Reader& file,
                       const std::filesystem::path& results,
                       const WindowRequest& request);

// Returns whether the axis of times is that of load factors.
bool is_of_load_factors(const Hdf5Reader& file);

// Lists the rows whose times are in the window.
std::vector<std::size_t> list_rows(const std::vector<double>& times, const TimeWindow& window);

// The least, largest and mean of numbers that are added one after another; NaN does not count.
class RangeOfNumbers {
  public:
    void add(double time, double number);

    double least, time_of_least, largest, time_of_largest;
    double mean() const;
    RangeOfNumbers();

  private:
    double sum_ = 0.0;
    std::size_t count_ = 0;
};

}  // namespace gxrod
