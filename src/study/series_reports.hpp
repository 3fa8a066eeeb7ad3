#pragma once

#include <vector>

#include "study/deck_study.hpp"
#include "study/series_differences.hpp"

namespace gxrod {

// What the runs of a study found of its series, at its samples.
struct StudyRows {
    using Rows = std::vector<std::vector<HistoryPoint::Row>>;  // of each series
    Rows base;                                                 // the deck as it is
    std::vector<Rows> steps;                                   // of each level that reached its end
    std::vector<Rows> meshes;
    NaturalScales natural;                       // of the deck as it is
    std::vector<std::vector<double>> round_off;  // differences, of each series; none if they are not known
    // The largest differences, of each series; none without that run.
    std::vector<double> order_differences;
    std::vector<double> turned_differences;
    std::vector<double> simo_differences;
};

// Of each series its scale, what step, mesh and round-off add, and until when it is right. `study` has its
// runs already.
std::vector<SeriesReport> make_reports(const std::vector<Series>& series,
                                       const StudyRows& found,
                                       const DeckStudy& study);

}  // namespace gxrod
