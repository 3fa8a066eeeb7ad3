#pragma once

#include <array>
#include <vector>

#include "watch/quantity.hpp"

namespace gxrod {

// Computes values at given times of rows that come step by step: the row itself if a step ends at the time,
// else the cubic through the four steps around it, at the end the four before it.
class TraceSampler {
  public:
    using Rows = std::vector<HistoryRow>;  // a row for each series

    // The times ascend; `end_time` sets what is near.
    TraceSampler(const std::vector<double>& times, double end_time);

    void add(double time, const Rows& rows);

    // Returns, for each sample so far, the rows of all series.
    const std::vector<Rows>& samples() const { return samples_; }

  private:
    void sample_between(double time);

    const std::vector<double>* times_;
    double tolerance_;
    std::vector<Rows> samples_;
    std::vector<double> last_times_;  // times of the last steps, four at most
    std::vector<Rows> last_rows_;
};

}  // namespace gxrod
