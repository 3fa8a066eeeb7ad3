#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "deck/problem.hpp"
#include "study/deck_variants.hpp"
#include "study/error_estimate.hpp"
#include "study/motion_trace.hpp"

// `gxrod verify DECK`: runs a user's own deck in several ways whose results must agree, or differ as the
// order of the method predicts.
namespace gxrod {

// The course and outcome of one of the runs.
struct VariantRun {
    DeckVariant variant;
    long elements = 0;
    long unknowns = 0;
    long steps = 0;              // in all stages
    std::vector<long> steps_at;  // taken up to each sample
    long rejected_steps = 0;
    bool is_cut_alike = true;  // for turned runs: whether they cut the same steps as the run before
    long newton_iterations = 0;
    double seconds = 0.0;
    std::string untried;  // why there was nothing to run or to compare with; it counts as whole then
    std::string failure;  // why it stopped early; for the resumed and threaded runs, how they differ
    TraceBooks books;
    std::vector<std::string> warnings;
    bool is_unstable = false;  // whether unstable equilibria were accepted

    bool is_whole() const { return failure.empty(); }
    // Returns the steps of the studied stage.
    long own_steps() const { return steps_at.empty() ? steps : steps - steps_at.front(); }
};

// A part of a run, and the steps taken in it.
struct UnrefinedPart {
    double from = 0.0;
    double until = 0.0;
    long coarse_steps = 0;
    long fine_steps = 0;
};

// Errors and differences of one series.
struct SeriesReport {
    Series series;
    double scale = 0.0;             // its largest change in the run; for rotations at most 1 rad
    bool is_still = false;          // it does not change; its scale is that of similar series
    ErrorEstimate steps;            // error by the step
    ErrorEstimate mesh;             // error by the mesh
    double order_difference = 0.0;  // largest difference with elements of the next order
    double turned_difference = 0.0;
    double round_off = 0.0;  // largest change when the model is turned a little more
    double simo_difference = 0.0;
    double error = 0.0;          // bound for step, mesh and round-off together; infinite if not known
    double trusted_until = 0.0;  // time up to which the error is within the tolerance

    // Returns a value relative to the scale; infinite if the scale is 0, as nothing of its kind changes.
    double relative(double value) const;
    bool is_right(double tolerance) const { return error <= tolerance * scale; }
};

struct DeckStudyOptions {
    std::size_t stage = 0;    // index of the studied stage, as of find_studied_stage
    unsigned seed = 1;        // seed of the random rotation
    double tolerance = 0.01;  // for errors relative to the scale of each series
    std::function<bool()> is_interrupted = [] { return false; };
    std::function<void(const VariantRun&)> report_run = [](const VariantRun&) {};
};

struct DeckStudy {
    std::string title;
    std::string deck;
    std::string stage;  // its name; "" for a deck of one stage
    double end_time = 1.0;
    bool is_static = false;
    bool follows_motion = false;   // whether an earlier stage moves in time
    bool depends_on_steps = true;  // false in statics alone with `objective` elements
    bool is_adaptive = false;
    double expected_order = 2.0;  // order of the scheme in the step
    int element_order = 1;        // the lowest order
    bool has_own_histories = true;
    std::vector<std::string> unrefined_rods;  // rods of meshes
    Vec3 rotation = Vec3::Zero();             // rotation vector of the turned run
    double tolerance = 0.01;
    // Movement of the unchanged deck relative to the model's length: the largest √(2 T/m) times the time.
    // Infinite in statics, where it is not known.
    double motion = std::numeric_limits<double>::infinity();
    std::vector<DeckVariant> variants;  // planned
    std::vector<VariantRun> runs;
    std::vector<SeriesReport> series;
    std::vector<double> times;                       // times of samples
    std::vector<std::vector<HistoryRow>> base_rows;  // rows of each series, for the unchanged deck
    bool is_interrupted = false;

    const VariantRun* find(VariantKind kind, int level = 0) const;
    // Finds the first part of the run in which a run with finer steps took hardly more of them. If steps are
    // cut as they do not converge, both runs may take the same steps, and equal results do not show small
    // errors.
    std::optional<UnrefinedPart> find_unrefined_part() const;
    bool has_finer_steps() const { return !find_unrefined_part(); }
    // Returns the order of a series in the mesh: with elements of order p, values at nodes converge with
    // order 2p, values at their middles with p.
    double mesh_order_of(const Series& of) const;
    // Returns whether runs of this kind were planned and none reached its end.
    bool lacks(VariantKind kind) const;
    // Returns whether errors by step and mesh are known, as far as the deck can be refined.
    bool knows_errors() const;
    // Returns whether the two turned runs show the effect of round-off.
    bool knows_round_off() const;
    // Returns whether turned runs cut the same steps as the unchanged deck. If round-off leads to other cuts,
    // results differ by the error of the step, which shows nothing about orientation.
    bool is_turned_cut_alike() const;
    // Returns whether steps were cut and finer runs do not show their error; changes by turning may be that
    // error.
    bool is_error_of_cuts_unknown() const;
    // Returns whether the model moves by no more than the round-off that steps accumulate in positions.
    bool hardly_moves() const;
    // Returns whether the turned runs show something about orientation.
    bool is_orientation_judged() const;
    // Returns the largest of a difference among all series, relative to their scales.
    double largest_difference(double SeriesReport::*difference) const;
    // Returns by how much a series may change when the model is turned.
    double turned_limit(const SeriesReport& report) const;
    // Returns whether the turned model differs by more than this limit, or fails where the unchanged one does
    // not.
    bool depends_on_orientation() const;
    // Returns whether all planned variants were run.
    bool is_whole() const;
    // Returns whether results depend neither on the orientation nor on stopping nor on threads, as they must
    // not for any step and mesh.
    bool is_sound() const;
    // Returns whether each equilibrium of the unchanged deck was stable.
    bool is_stable() const { return runs.empty() || !runs.front().is_unstable; }
    // Returns whether errors by step and mesh are within the tolerance in each series.
    bool has_small_errors() const;
    // Returns whether errors are small and the equilibria stable.
    bool is_accurate() const;
};

// Runs all variants. A failed variant is reported in its run; a wrong deck, or files that cannot be written,
// throw as usual. If the unchanged deck does not converge, it is the only run.
DeckStudy study_deck(const DeckTemplate& deck,
                     const std::vector<std::string>& overrides,
                     const std::vector<DeckVariant>& variants,
                     const DeckStudyOptions& options);

}  // namespace gxrod
