#include <algorithm>
#include <cmath>

#include "verification/deck_study.hpp"

namespace gxrod {

namespace {

// What turning a model may change, by the scale: solver tolerances, and a part of the error that is there
// anyhow.
constexpr double turned_tolerance = 1e-6;
constexpr double turned_part = 0.01;
constexpr double turned_round_off = 100.0;  // times what round-off was seen to change, one case of many
// Of the numbers of steps of two levels, at least: 2 where none is cut.
constexpr double least_growth = 1.25;

}  // namespace

const VariantRun* DeckStudy::find(VariantKind kind, int level) const {
    for (const VariantRun& run : runs) {
        if (run.variant.kind == kind && run.variant.level == level) return &run;
    }
    return nullptr;
}

bool DeckStudy::has_finer_steps() const {
    if (is_static) return true;
    const VariantRun* coarse = runs.empty() ? nullptr : &runs.front();
    for (int level = 1; const VariantRun* finer = find(VariantKind::finer_steps, level); ++level) {
        if (!finer->is_whole()) break;
        if (static_cast<double>(finer->steps) < least_growth * static_cast<double>(coarse->steps))
            return false;
        coarse = finer;
    }
    return true;
}

bool DeckStudy::is_turned_cut_alike() const {
    const VariantRun* turned = find(VariantKind::turned);
    return turned == nullptr || turned->is_cut_alike;
}

double DeckStudy::largest_difference(double SeriesReport::*difference) const {
    double most = 0.0;
    for (const SeriesReport& report : series) most = std::fmax(most, report.relative(report.*difference));
    return most;
}

double DeckStudy::turned_limit(const SeriesReport& report) const {
    const double known = std::isfinite(report.error) ? report.error : report.mesh.largest();
    const double by_error = is_turned_cut_alike() ? turned_part * known : report.error;
    return std::max({turned_tolerance * report.scale, turned_round_off * report.round_off, by_error});
}

bool DeckStudy::is_sound() const {
    const auto holds = [&](VariantKind kind) {
        const VariantRun* run = find(kind);
        return run == nullptr || run->is_whole();
    };
    // That a turned model alone fails is a matter of round-off, if one turned by a hair more does not.
    const VariantRun* more = find(VariantKind::turned_more);
    const bool is_turned_able = holds(VariantKind::turned) || (more != nullptr && more->is_whole());
    return holds(VariantKind::resumed) && holds(VariantKind::two_threads) && is_turned_able &&
           std::all_of(series.begin(), series.end(), [&](const SeriesReport& report) {
               return report.turned_difference <= turned_limit(report);
           });
}

bool DeckStudy::is_accurate() const {
    return std::all_of(series.begin(), series.end(), [&](const SeriesReport& report) {
        return report.error <= tolerance * report.scale;
    });
}

}  // namespace gxrod
