#pragma once

#include <vector>

#include "study/deck_study.hpp"
#include "study/series_differences.hpp"

namespace gxrod {

// Rows of the series of a study from its runs, at its samples.
struct StudyRows {
    using Rows = std::vector<std::vector<HistoryRow>>;  // rows of each series
    Rows base;                                          // the unchanged deck
    std::vector<Rows> steps;                            // for each level that reached its end
    std::vector<Rows> meshes;
    NaturalScales natural;                       // scales of the unchanged deck
    std::vector<std::vector<double>> round_off;  // differences of each series; empty if not known
    // The largest differences of each series; empty without the run.
    std::vector<double> order_differences;
    std::vector<double> turned_differences;
    std::vector<double> simo_differences;
};

// Reports the scale of each series, its errors by step, mesh and round-off, and until when it is right.
// `study` must have its runs.
std::vector<SeriesReport> make_reports(const std::vector<Series>& series,
                                       const StudyRows& found,
                                       const DeckStudy& study);

}  // namespace gxrod
