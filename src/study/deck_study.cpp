#include "study/deck_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "rotation/rotation_map.hpp"
#include "study/method_traits.hpp"
#include "study/resumed_run.hpp"
#include "study/series_differences.hpp"
#include "study/series_reports.hpp"
#include "study/studied_stage.hpp"
#include "study/turned_problem.hpp"

namespace gxrod {

namespace {

constexpr double slack_in_time = 1e-9;     // of the end time
constexpr double least_straining = 1e-16;  // of the largest energy: less is round-off
constexpr double angle_more = 1e-6;        // rad, of the run that shows round-off

Quat make_random_rotation(unsigned seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    const auto next = [&] { return normal(generator); };
    const double w = next(), x = next(), y = next(), z = next();
    return Quat(w, x, y, z).normalized();
}

// Whether a stage before the last one moves in time or turns.
bool follows_motion(const std::vector<StagePlan>& stages) {
    return std::any_of(stages.begin(), stages.end() - 1, [](const StagePlan& stage) {
        return can_be_studied(stage.analysis) && !std::holds_alternative<StaticSettings>(stage.analysis);
    });
}

class DeckExaminer {
  public:
    DeckExaminer(const DeckTemplate& deck,
                 const std::vector<std::string>& overrides,
                 const DeckStudyOptions& options)
        : options_(&options),
          base_problem_(deck.build(overrides)),
          deck_(base_problem_.record.text, deck.file()) {
        complete(base_problem_);
        const Problem& problem = base_problem_;
        const AnalysisSettings& analysis = studied_analysis(problem);
        study_.title = problem.record.title;
        study_.deck = deck.file();
        if (problem.record.stages.size() > 1) study_.stage = problem.stages.back().name;
        study_.is_static = std::holds_alternative<StaticSettings>(analysis);
        study_.is_adaptive = adaptive_of(analysis) != nullptr;
        study_.expected_order = order_of(analysis);
        study_.element_order = lowest_order_of(problem.model);
        study_.follows_motion = follows_motion(problem.stages);
        study_.depends_on_steps =
            !study_.is_static || study_.follows_motion || has_elements_simo(problem.model);
        study_.unrefined_rods = list_unrefined_rods(problem);
        study_.tolerance = options.tolerance;
        study_.times = choose_times(analysis);
        study_.end_time = study_.times.back();
        series_ = list_series(problem.output);
        rotation_ = restrict_rotation(make_random_rotation(options.seed), problem.model);
        const std::optional<Vec3> axis = find_small_turn(problem.model);
        turns_by_little_ = axis.has_value();
        rotation_more_ = rotation_ * exp_quaternion(angle_more * axis.value_or(Vec3::Zero()));
        study_.rotation = log(rotation_);
    }

    DeckStudy examine(const std::vector<DeckVariant>& variants) {
        study_.variants = variants;
        try {
            for (const DeckVariant& variant : variants) {
                run(variant);
                options_->report_run(study_.runs.back());
                if (!study_.runs.front().is_whole()) break;
            }
        } catch (const StudyInterrupted&) {
            study_.is_interrupted = true;
        }
        if (!base_.rows.empty()) report_series();
        return std::move(study_);
    }

  private:
    void complete(Problem& problem) {
        end_with_stage(options_->stage, problem);
        study_.has_own_histories = !problem.output.histories.empty();
        if (!study_.has_own_histories) problem.output.histories = make_end_histories(problem.model);
    }

    // The user's overrides are part of the deck then, so that a variant's keys may exclude theirs.
    Problem build(const std::vector<std::string>& overrides) {
        Problem problem = deck_.build(overrides);
        complete(problem);
        return problem;
    }

    void run(const DeckVariant& variant) {
        VariantRun run;
        run.variant = variant;
        try {
            if (variant.kind == VariantKind::resumed) {
                run_resumed(run);
            } else {
                run_whole(run);
            }
        } catch (const StudyInterrupted&) {
            throw;
        } catch (const std::bad_alloc&) {
            if (study_.runs.empty()) throw;
            tell_unmade(run, "out of memory");
        } catch (const std::runtime_error& error) {
            if (study_.runs.empty()) throw;
            tell_unmade(run, error.what());
        }
        study_.runs.push_back(run);
    }

    // If the machine lacks resources for one of the runs, the others are kept.
    static void tell_unmade(VariantRun& run, const std::string& reason) {
        const bool must_be_equal =
            run.variant.kind == VariantKind::resumed || run.variant.kind == VariantKind::two_threads;
        (must_be_equal ? run.untried : run.failure) = "it could not be made: " + reason;
    }

    TraceRequest make_request(int threads) const {
        return {series_, study_.times, threads, options_->is_interrupted};
    }

    void run_whole(VariantRun& run) {
        Problem problem = build(run.variant.overrides);
        if (run.variant.kind == VariantKind::turned) turn_problem(rotation_, problem);
        if (run.variant.kind == VariantKind::turned_more) turn_problem(rotation_more_, problem);
        const int threads = run.variant.kind == VariantKind::two_threads ? 2 : 1;
        MotionTrace trace = trace_motion(problem, make_request(threads));
        run.elements = trace.elements;
        run.unknowns = trace.unknowns;
        run.steps = trace.steps;
        run.steps_at = trace.steps_at;
        run.rejected_steps = static_cast<long>(trace.rejected_at.size());
        run.newton_iterations = trace.newton_iterations;
        run.seconds = trace.seconds;
        run.failure = trace.failure;
        run.books = trace.books;
        run.warnings = trace.warnings;
        run.is_unstable = trace.is_unstable;
        take(run, std::move(trace));
    }

    void take(VariantRun& run, MotionTrace trace) {
        switch (run.variant.kind) {
            case VariantKind::as_it_is:
                base_ = std::move(trace);
                break;
            case VariantKind::finer_steps:
                if (run.is_whole()) found_.steps.push_back(std::move(trace.rows));
                break;
            case VariantKind::finer_mesh:
                if (run.is_whole()) found_.meshes.push_back(std::move(trace.rows));
                break;
            case VariantKind::higher_order:
                if (run.is_whole()) found_.order_differences = compare(base_, trace, Quat::Identity());
                break;
            case VariantKind::simo:
                if (run.is_whole()) found_.simo_differences = compare(base_, trace, Quat::Identity());
                break;
            case VariantKind::turned:
                if (run.is_whole()) {
                    found_.turned_differences = compare(base_, trace, rotation_);
                    run.is_cut_alike = is_cut_alike(base_, trace);
                }
                turned_ = std::move(trace);
                break;
            case VariantKind::turned_more:
                take_round_off(run, trace);
                break;
            case VariantKind::two_threads:
                run.failure = find_inequality(trace);
                break;
            case VariantKind::resumed:
                break;
        }
    }

    // Of runs that both fail, up to there.
    void take_round_off(VariantRun& run, const MotionTrace& trace) {
        if (!turns_by_little_) {
            run.untried = "a plane model in water, air or on the ground can only be turned by half a turn";
            return;
        }
        if (run.is_whole() && !turned_.is_whole()) run.untried = "the turned run failed";
        if (run.is_whole() != turned_.is_whole()) return;
        run.is_cut_alike = is_cut_alike(turned_, trace);
        if (run.is_cut_alike) {
            found_.round_off = list_differences(turned_, trace, rotation_more_ * rotation_.conjugate());
        } else {
            run.untried = "other steps were taken";
        }
    }

    // Times of steps by their error are never the same: of them counts are compared.
    bool is_cut_alike(const MotionTrace& one, const MotionTrace& other) const {
        if (one.steps != other.steps) return false;
        return study_.is_adaptive ? one.rejected_at.size() == other.rejected_at.size()
                                  : one.rejected_at == other.rejected_at;
    }

    // Of each series, at each sample, between a run that is turned by `rotation` and another one.
    std::vector<std::vector<double>> list_differences(const MotionTrace& one,
                                                      const MotionTrace& other,
                                                      const Quat& rotation) const {
        std::vector<std::vector<double>> differences;
        for (std::size_t k = 0; k < series_.size(); ++k) {
            std::vector<HistoryRow> turned = one.rows[k];
            for (HistoryRow& row : turned) row = turn_row(series_[k].turning, rotation, row);
            differences.push_back(compute_differences(series_[k], turned, other.rows[k]));
        }
        return differences;
    }

    // The largest of them.
    std::vector<double> compare(const MotionTrace& one,
                                const MotionTrace& other,
                                const Quat& rotation) const {
        std::vector<double> differences;
        for (const std::vector<double>& of_series : list_differences(one, other, rotation))
            differences.push_back(largest_of(of_series));
        return differences;
    }

    // Which series is not the same as of the deck as it is, to the last bit.
    std::string find_inequality(const MotionTrace& trace) const {
        if (!trace.is_whole()) return trace.failure;
        for (std::size_t k = 0; k < series_.size(); ++k) {
            for (std::size_t i = 0; i < base_.samples; ++i) {
                if (!is_same(series_[k], base_.rows[k][i], trace.rows[k][i]))
                    return describe_inequality(k, i);
            }
        }
        return "";
    }

    std::string describe_inequality(std::size_t series, std::size_t sample) const {
        return fmt::format("{} differs at t = {:.10g}", series_[series].title(), study_.times[sample]);
    }

    void run_resumed(VariantRun& run) {
        const Problem problem = build({});
        const ResumedRun resumed = run_with_stop(problem, study_.end_time, make_request(1));
        const VariantRun& base = study_.runs.front();
        run.elements = base.elements;
        run.unknowns = base.unknowns;
        run.steps = resumed.steps;
        run.rejected_steps = resumed.rejected_steps;
        run.newton_iterations = resumed.newton_iterations;
        run.seconds = resumed.seconds;
        run.failure = resumed.failure;
        if (run.failure.empty() && resumed.rows.empty()) {
            run.untried = "no step is left to resume with";
        } else if (run.failure.empty()) {
            run.failure = find_inequality(resumed, study_.is_adaptive);
        }
    }

    // At samples where steps end; of steps by their error, at the end alone.
    std::string find_inequality(const ResumedRun& resumed, bool at_end_alone) const {
        std::size_t step = 0;
        for (std::size_t i = at_end_alone ? base_.samples - 1 : 0; i < base_.samples; ++i) {
            const double slack = slack_in_time * study_.end_time;
            while (step < resumed.times.size() && resumed.times[step] < study_.times[i] - slack) ++step;
            if (step == resumed.times.size())
                return fmt::format("no step ends at t = {:.10g}", study_.times[i]);
            if (resumed.times[step] > study_.times[i] + slack) continue;
            for (std::size_t k = 0; k < series_.size(); ++k) {
                if (!is_same(series_[k], base_.rows[k][i], resumed.rows[step][k]))
                    return describe_inequality(k, i);
            }
        }
        return "";
    }

    void report_series() {
        const double speed = base_.mass > 0.0 ? base_.books.momentum_scale / base_.mass : 0.0;
        if (base_.mass > 0.0 && !study_.is_static) study_.motion = speed * study_.end_time / base_.length;
        const TraceBooks& books = base_.books;
        const bool is_strained = books.largest_strain_energy > least_straining * books.largest_energy;
        found_.natural = {
            base_.length, speed, is_strained ? books.largest_strain_energy : books.largest_energy};
        found_.base = std::move(base_.rows);
        study_.series = make_reports(series_, found_, study_);
        study_.base_rows = std::move(found_.base);
    }

    const DeckStudyOptions* options_;
    Problem base_problem_;
    DeckTemplate deck_;  // with the user's overrides
    std::vector<Series> series_;
    Quat rotation_;
    Quat rotation_more_;
    bool turns_by_little_ = true;
    DeckStudy study_;
    MotionTrace base_;
    MotionTrace turned_;
    StudyRows found_;
};

}  // namespace

DeckStudy study_deck(const DeckTemplate& deck,
                     const std::vector<std::string>& overrides,
                     const std::vector<DeckVariant>& variants,
                     const DeckStudyOptions& options) {
    return DeckExaminer(deck, overrides, options).examine(variants);
}

}  // namespace gxrod
