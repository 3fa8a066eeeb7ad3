#pragma once

#include <vector>

#include "study/motion_trace.hpp"

namespace gxrod {

// Computes the distance of two rows of a series: the length of their difference; for rotations the angle
// between them.
double distance(const Series& series, const HistoryRow& one, const HistoryRow& other);

// Computes the distances of two runs at each sample that both have.
std::vector<double> compute_differences(const Series& series,
                                        const std::vector<HistoryRow>& one,
                                        const std::vector<HistoryRow>& other);

// Returns whether two rows are the same to the last bit; quaternions of either sign are the same rotation.
bool is_same(const Series& series, const HistoryRow& one, const HistoryRow& other);

// Large values in a model: its length, the speed of all its mass at the largest kinetic energy, and its
// largest strain energy, or its largest energy if it has none.
struct NaturalScales {
    double length = 0.0;
    double speed = 0.0;
    double energy = 0.0;

    double of(Size size) const;  // 0 if nothing is known
};

// The change of a series in a run, with which its errors are compared: for positions the distance from the
// start, for rotations at most 1 rad, for the rest the largest value. A series is_still if it is small
// compared with the same quantity elsewhere or with the model's natural scale, or within ten times the effect
// of round-off, such as the moment at a free end; its scale is then the larger quantity.
struct SeriesScale {
    double scale = 0.0;
    bool is_still = false;
};
std::vector<SeriesScale> compute_scales(const std::vector<Series>& series,
                                        const std::vector<std::vector<HistoryRow>>& rows,
                                        const NaturalScales& natural,
                                        const std::vector<double>& round_off);

}  // namespace gxrod
