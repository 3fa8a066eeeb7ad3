#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "deck/problem.hpp"
#include "study/deck_variants.hpp"
#include "study/error_estimate.hpp"
#include "study/motion_trace.hpp"

// `gxrod verify DECK`: a user's own deck, run in several ways that must agree, or differ as the order of the
// method says.
namespace gxrod {

// One of the runs, as it went.
struct VariantRun {
    DeckVariant variant;
    long elements = 0;
    long unknowns = 0;
    long steps = 0;
    std::vector<long> steps_at;  // up to each sample
    long rejected_steps = 0;
    bool is_cut_alike = true;  // of turned runs: where the steps of the run before it were
    long newton_iterations = 0;
    double seconds = 0.0;
    std::string untried;  // why there was nothing to try, or to compare with: it is whole then
    std::string failure;  // why it ended before its end; of the resumed and threaded runs, how they differ
    TraceBooks books;
    std::vector<std::string> warnings;
    bool is_unstable = false;  // whether unstable equilibria were accepted

    bool is_whole() const { return failure.empty(); }
};

// A part of a run, and the steps taken in it.
struct UnrefinedPart {
    double from = 0.0;
    double until = 0.0;
    long coarse_steps = 0;
    long fine_steps = 0;
};

// What is known of one series.
struct SeriesReport {
    Series series;
    double scale = 0.0;             // the largest change of it in the run; of rotations 1 rad at most
    bool is_still = false;          // it does not change: errors are by the scale of its like
    ErrorEstimate steps;            // what the step adds
    ErrorEstimate mesh;             // what the mesh adds
    double order_difference = 0.0;  // to elements of the next order, at most
    double turned_difference = 0.0;
    double round_off = 0.0;  // what turning the model a little more changes
    double simo_difference = 0.0;
    double error = 0.0;          // of step, mesh and round-off together, at most; infinite if it is not known
    double trusted_until = 0.0;  // the time up to which it is within the tolerance

    // Infinite if there is nothing to judge it by: nothing of its kind changes.
    double relative(double value) const;
    bool is_right(double tolerance) const { return error <= tolerance * scale; }
};

struct DeckStudyOptions {
    unsigned seed = 1;        // of the random rotation
    double tolerance = 0.01;  // of errors, by the scale of each series, that the user calls right
    std::function<bool()> is_interrupted = [] { return false; };
    std::function<void(const VariantRun&)> report_run = [](const VariantRun&) {};
};

struct DeckStudy {
    std::string title;
    std::string deck;
    double end_time = 1.0;
    bool is_static = false;
    bool depends_on_steps = true;  // statics of elements objective do not
    bool is_adaptive = false;
    double expected_order = 2.0;  // of the scheme, in the step
    int element_order = 1;        // the lowest
    bool has_own_histories = true;
    std::vector<std::string> unrefined_rods;  // of meshes
    Vec3 rotation = Vec3::Zero();             // rotation vector of the turned run
    double tolerance = 0.01;
    // How far the deck as it is moves, by the model's length: √(2 T/m), at most, times the time. Infinite in
    // statics, where it is not known.
    double motion = std::numeric_limits<double>::infinity();
    std::vector<DeckVariant> variants;  // that were to be run
    std::vector<VariantRun> runs;
    std::vector<SeriesReport> series;
    std::vector<double> times;                              // of samples
    std::vector<std::vector<HistoryPoint::Row>> base_rows;  // of each series, the deck as it is
    bool is_interrupted = false;

    const VariantRun* find(VariantKind kind, int level = 0) const;
    // The first part of the run in which a run with finer steps took hardly more of them. Where steps are cut
    // since they do not converge they may take the same ones, and equal results are then no sign of small
    // errors.
    std::optional<UnrefinedPart> find_unrefined_part() const;
    bool has_finer_steps() const { return !find_unrefined_part(); }
    // Of a series: nodes converge with order 2p of elements of order p, what their middles have with p.
    double mesh_order_of(const Series& of) const;
    // Whether runs of this kind were asked for and none reached its end.
    bool lacks(VariantKind kind) const;
    // Whether something is known of what step and mesh add, as far as the deck can be refined.
    bool knows_errors() const;
    // Whether the two turned runs show what round-off changes.
    bool knows_round_off() const;
    // Whether steps of the turned runs were cut where those of the deck as it is were. If round-off decides
    // otherwise, they differ by the error of the step, which says nothing of orientation.
    bool is_turned_cut_alike() const;
    // Whether steps were cut and finer runs show no error of them. What turning changes may be that error.
    bool is_error_of_cuts_unknown() const;
    // Whether the model moves by no more than what steps add up of round-off in places.
    bool hardly_moves() const;
    // Whether the turned runs say something about orientation.
    bool is_orientation_judged() const;
    // The largest of all series, by their scales.
    double largest_difference(double SeriesReport::*difference) const;
    // How far a series may differ once the model is turned.
    double turned_limit(const SeriesReport& report) const;
    // Whether a turned model moves otherwise, by more than that, or fails where as it is it does not.
    bool depends_on_orientation() const;
    // Whether all planned variants were run.
    bool is_whole() const;
    // Whether nothing was seen of what must not be for any step and mesh: that it depends on the orientation,
    // on stopping, on threads.
    bool is_sound() const;
    // Whether each equilibrium of the deck as it is was stable.
    bool is_stable() const { return runs.empty() || !runs.front().is_unstable; }
    // Whether what step and mesh add to each series is within the tolerance …
    bool has_small_errors() const;
    // … and the equilibria are stable.
    bool is_accurate() const;
};

// Runs all. A variant that fails is reported in its run; a deck that is wrong, or files that cannot be
// written, throw as ever. If the deck as it is does not converge, that is its only run.
DeckStudy study_deck(const DeckTemplate& deck,
                     const std::vector<std::string>& overrides,
                     const std::vector<DeckVariant>& variants,
                     const DeckStudyOptions& options);

}  // namespace gxrod
