#include <algorithm>
#include <cmath>
#include <limits>

#include "study/deck_study.hpp"

namespace gxrod {

namespace {

// What turning a model may change: by the scale, what solvers leave; and times what round-off was seen to
// change, one case of many. The error that is there anyhow explains as much, too.
constexpr double turned_tolerance = 1e-6;
constexpr double turned_round_off = 100.0;
// Of the numbers of steps of two levels, at least: 2 where none is cut.
constexpr double least_growth = 1.25;
// Of the model's length: less is thousands of units in the last place of coordinates, at most.
constexpr double least_motion = 1e-12;

// Parts of a run in which steps are counted have so many of them at least.
constexpr long steps_of_part = 8;

// Between samples that are far enough from each other.
std::optional<UnrefinedPart> compare_steps(const VariantRun& coarse,
                                           const VariantRun& fine,
                                           double growth,
                                           const std::vector<double>& times) {
    const auto is_refined = [&](long coarse_steps, long fine_steps) {
        return static_cast<double>(fine_steps) >= growth * static_cast<double>(coarse_steps);
    };
    const double end = times.empty() ? 0.0 : times.back();
    if (!is_refined(coarse.own_steps(), fine.own_steps()))
        return UnrefinedPart{0.0, end, coarse.own_steps(), fine.own_steps()};
    const std::size_t samples = std::min({coarse.steps_at.size(), fine.steps_at.size(), times.size()});
    std::size_t first = 0;
    for (std::size_t i = 1; i < samples; ++i) {
        const long steps = coarse.steps_at[i] - coarse.steps_at[first];
        if (steps < steps_of_part) continue;
        const long more = fine.steps_at[i] - fine.steps_at[first];
        if (!is_refined(steps, more)) return UnrefinedPart{times[first], times[i], steps, more};
        first = i;
    }
    return std::nullopt;
}

}  // namespace

double SeriesReport::relative(double value) const {
    if (value == 0.0) return 0.0;
    return scale > 0.0 ? value / scale : std::numeric_limits<double>::infinity();
}

const VariantRun* DeckStudy::find(VariantKind kind, int level) const {
    for (const VariantRun& run : runs) {
        if (run.variant.kind == kind && run.variant.level == level) return &run;
    }
    return nullptr;
}

std::optional<UnrefinedPart> DeckStudy::find_unrefined_part() const {
    if (!depends_on_steps) return std::nullopt;
    const VariantRun* coarse = runs.empty() ? nullptr : &runs.front();
    double growth = least_growth;
    for (int level = 1; const VariantRun* finer = find(VariantKind::finer_steps, level); ++level) {
        if (!finer->is_whole()) {
            growth *= least_growth;
            continue;
        }
        if (const auto part = compare_steps(*coarse, *finer, growth, times)) return part;
        coarse = finer;
        growth = least_growth;
    }
    return std::nullopt;
}

double DeckStudy::mesh_order_of(const Series& of) const {
    return of.quantity->has_strain_order ? element_order : 2.0 * element_order;
}

bool DeckStudy::lacks(VariantKind kind) const {
    const auto is_asked = [&](const DeckVariant& variant) { return variant.kind == kind; };
    const auto is_done = [&](const VariantRun& run) { return run.variant.kind == kind && run.is_whole(); };
    return std::any_of(variants.begin(), variants.end(), is_asked) &&
           std::none_of(runs.begin(), runs.end(), is_done);
}

bool DeckStudy::knows_errors() const {
    return unrefined_rods.empty() && has_finer_steps() && !lacks(VariantKind::finer_steps) &&
           !lacks(VariantKind::finer_mesh);
}

bool DeckStudy::knows_round_off() const {
    const VariantRun* more = find(VariantKind::turned_more);
    return more != nullptr && more->is_whole() && more->untried.empty();
}

bool DeckStudy::is_turned_cut_alike() const {
    return std::all_of(runs.begin(), runs.end(), [](const VariantRun& run) { return run.is_cut_alike; });
}

bool DeckStudy::is_error_of_cuts_unknown() const {
    const bool is_known = has_finer_steps() && !lacks(VariantKind::finer_steps);
    return !runs.empty() && runs.front().rejected_steps > 0 && !is_known;
}

bool DeckStudy::hardly_moves() const { return motion < least_motion; }

double DeckStudy::largest_difference(double SeriesReport::*difference) const {
    double most = 0.0;
    for (const SeriesReport& report : series) {
        const double part = report.relative(report.*difference);
        if (std::isfinite(part)) most = std::fmax(most, part);
    }
    return most;
}

double DeckStudy::turned_limit(const SeriesReport& report) const {
    const double error =
        std::isfinite(report.error) ? report.error : report.steps.largest() + report.mesh.largest();
    return std::max({turned_tolerance * report.scale, turned_round_off * report.round_off, error});
}

bool DeckStudy::is_orientation_judged() const {
    if (hardly_moves() || is_error_of_cuts_unknown() || !is_turned_cut_alike()) return false;
    const VariantRun* turned = find(VariantKind::turned);
    const VariantRun* more = find(VariantKind::turned_more);
    // Without the second nothing is known of round-off.
    if (turned != nullptr && more == nullptr && is_interrupted) return false;
    const bool is_turned_whole = turned == nullptr || turned->is_whole();
    const bool is_more_whole = more == nullptr || more->is_whole();
    if (is_turned_whole || is_more_whole) return is_turned_whole && is_more_whole;
    // Round-off can decide that they fail where steps are cut anyhow, and where it grows.
    return runs.front().rejected_steps == 0 &&
           largest_difference(&SeriesReport::round_off) < turned_tolerance;
}

bool DeckStudy::depends_on_orientation() const {
    if (!is_orientation_judged()) return false;
    const VariantRun* turned = find(VariantKind::turned);
    if (turned != nullptr && !turned->is_whole()) return true;
    return std::any_of(series.begin(), series.end(), [&](const SeriesReport& report) {
        return report.turned_difference > turned_limit(report);
    });
}

bool DeckStudy::is_whole() const { return !runs.empty() && runs.front().is_whole() && !is_interrupted; }

bool DeckStudy::is_sound() const {
    const auto holds = [&](VariantKind kind) {
        const VariantRun* run = find(kind);
        return run == nullptr || run->is_whole();
    };
    return holds(VariantKind::resumed) && holds(VariantKind::two_threads) && !depends_on_orientation();
}

bool DeckStudy::has_small_errors() const {
    return !series.empty() && std::all_of(series.begin(), series.end(), [&](const SeriesReport& report) {
        return report.is_right(tolerance);
    });
}

bool DeckStudy::is_accurate() const { return is_stable() && has_small_errors(); }

}  // namespace gxrod
