#pragma once

#include <vector>

#include "verification/motion_trace.hpp"

namespace gxrod {

// Between two rows of a series: the length of the difference; of rotations the angle between them.
double distance(const Series& series, const HistoryPoint::Row& one, const HistoryPoint::Row& other);

// Between two runs, at each sample that both have.
std::vector<double> compute_differences(const Series& series,
                                        const std::vector<HistoryPoint::Row>& one,
                                        const std::vector<HistoryPoint::Row>& other);

// Whether two rows are the same to the last bit; of quaternions both signs are the same rotation.
bool is_same(const Series& series, const HistoryPoint::Row& one, const HistoryPoint::Row& other);

// How much each series changes in a run, the length by which its errors are to be judged: of places the way
// from the start, of rotations at most 1 rad, of the rest the largest value. Where a series stays as it was,
// the largest scale of another with the same quantity is taken, and it is_still.
struct SeriesScale {
    double scale = 0.0;
    bool is_still = false;
};
std::vector<SeriesScale> compute_scales(const std::vector<Series>& series,
                                        const std::vector<std::vector<HistoryPoint::Row>>& rows);

}  // namespace gxrod
