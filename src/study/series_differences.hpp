#pragma once

#include <vector>

#include "study/motion_trace.hpp"

namespace gxrod {

// Between two rows of a series: the length of the difference; of rotations the angle between them.
double distance(const Series& series, const HistoryPoint::Row& one, const HistoryPoint::Row& other);

// Between two runs, at each sample that both have.
std::vector<double> compute_differences(const Series& series,
                                        const std::vector<HistoryPoint::Row>& one,
                                        const std::vector<HistoryPoint::Row>& other);

// Whether two rows are the same to the last bit; of quaternions both signs are the same rotation.
bool is_same(const Series& series, const HistoryPoint::Row& one, const HistoryPoint::Row& other);

// What is large in a model: its length, the speed of all mass at its largest kinetic energy, its largest
// strain energy, or without any its largest energy.
struct NaturalScales {
    double length = 0.0;
    double speed = 0.0;
    double energy = 0.0;

    double of(Quantity quantity) const;  // 0 if nothing is known
};

// How much each series changes in a run, the length by which its errors are to be judged: of places the way
// from the start, of rotations at most 1 rad, of the rest the largest value. A series is_still if it
// is small compared with the same quantity elsewhere or with the model's own, or within ten times what
// round-off alone changes, such as the moment at a free end; its scale is then that larger quantity.
struct SeriesScale {
    double scale = 0.0;
    bool is_still = false;
};
std::vector<SeriesScale> compute_scales(const std::vector<Series>& series,
                                        const std::vector<std::vector<HistoryPoint::Row>>& rows,
                                        const NaturalScales& natural,
                                        const std::vector<double>& round_off);

}  // namespace gxrod
