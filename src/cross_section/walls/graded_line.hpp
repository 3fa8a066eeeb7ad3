#pragma once

#include <vector>

namespace gxrod {

// Sizes of the elements along a line.
struct LineGrading {
    double at_start = 0.0, at_end = 0.0;  // at its ends
    double growth = 0.7;  // per distance from there: an element is about twice as long as the one before
    double largest = 0.0;
};

// Returns where elements of a line meet, as fractions from 0 to 1: as many as fit, two at least.
std::vector<double> grade_line(double length, const LineGrading& grading);

}  // namespace gxrod
