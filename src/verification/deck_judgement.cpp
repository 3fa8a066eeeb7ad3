#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/deck_study_text.hpp"

namespace gxrod {

namespace {

constexpr double order_slack = 0.5;    // below the scheme's order, before it is called lower
constexpr double least_whole = 0.995;  // what is 100 % with two digits
constexpr double most_told = 1000.0;   // of what is told as a share
constexpr double most_refinement = 64.0;

// "0.3 %", "130 %", and of what is small "2e-07".
std::string describe_share(double share) {
    if (share > most_told) return fmt::format("more than {:.0f} %", 100.0 * most_told);
    // Two digits of what is more than 100 % as of the rest.
    if (share >= least_whole) return fmt::format("{:.0f} %", std::stod(fmt::format("{:.1e}", 100.0 * share)));
    return share >= 1e-4 ? fmt::format("{:.2g} %", 100.0 * share) : fmt::format("{:.0e}", share);
}

// What step or mesh adds to the series that it adds most to.
struct Worst {
    const SeriesReport* report = nullptr;
    double share = 0.0;
};

Worst find_worst(const DeckStudy& study, ErrorEstimate SeriesReport::*part) {
    Worst worst;
    for (const SeriesReport& report : study.series) {
        if ((report.*part).is_round_off) continue;
        const double share = report.relative((report.*part).largest());
        if (!std::isfinite(share)) continue;
        if (worst.report == nullptr || share > worst.share) worst = {&report, share};
    }
    return worst;
}

double order_to_use(const ErrorEstimate& estimate, double expected) {
    return std::clamp(estimate.order.value_or(expected), order_slack, expected);
}

// By what to refine for half of the tolerance: a whole number.
double find_factor(double share, double tolerance, double order) {
    return std::ceil(std::pow(share / (0.5 * tolerance), 1.0 / order) - 1e-9);
}

class Judge {
  public:
    explicit Judge(const DeckStudy& study) : study_(&study) {}

    std::vector<std::string> judge() {
        if (study_->runs.empty()) return {"Interrupted before the first run had ended."};
        if (!study_->runs.front().is_whole()) {
            say("The deck as it is does not reach its end, so nothing can be said of it: {}",
                study_->runs.front().failure);
            return sentences_;
        }
        if (study_->is_interrupted) say("Interrupted: of the runs that are missing nothing is said.");
        judge_soundness();
        judge_orientation();
        if (study_->has_finer_steps()) {
            if (study_->knows_errors())
                judge_accuracy();
            else
                tell_lack_of_runs();
            tell_round_off();
            judge_steps();
            judge_mesh();
            tell_unrefined_rods();
        } else {
            tell_lack_of_steps();
        }
        judge_books();
        tell_failures();
        return sentences_;
    }

  private:
    template <class... Values>
    void say(fmt::format_string<Values...> format, Values&&... values) {
        sentences_.push_back(fmt::format(format, std::forward<Values>(values)...));
    }

    void judge_soundness() {
        for (const VariantKind kind : {VariantKind::resumed, VariantKind::two_threads}) {
            const VariantRun* run = study_->find(kind);
            if (run == nullptr || run->is_whole()) continue;
            say("The run \"{}\" is not the same as the deck as it is: {}. This must not be; please report "
                "it.",
                run->variant.title,
                run->failure);
        }
    }

    bool has_failed(VariantKind kind) const {
        const VariantRun* run = study_->find(kind);
        return run != nullptr && !run->is_whole();
    }

    void judge_orientation() {
        if (study_->depends_on_orientation()) {
            say("The motion depends on how the model stands in space, by more than its errors. If no "
                "expression of the deck hides a direction, and a smaller newton.tolerance does not mend it, "
                "please report it.");
        } else if (study_->hardly_moves()) {
            say("The model hardly moves, by {:.0e} of its size: velocities, accelerations and what they add "
                "to forces are those of round-off, and nothing is said of its orientation.",
                study_->motion);
        } else if (study_->is_error_of_cuts_unknown()) {
            say("Steps were cut, and the error of that is not known: nor is whether turning the model in "
                "space changes its motion by more.");
        } else if (study_->is_orientation_judged()) {
            return;
        } else if (!has_failed(VariantKind::turned) && !has_failed(VariantKind::turned_more)) {
            tell_turned_steps();
        } else {
            say("A run that was turned in space failed, which round-off can decide where it grows or where "
                "steps are cut: nothing is said of the orientation.");
        }
    }

    void tell_turned_steps() {
        std::vector<std::string> counts;
        for (const VariantKind kind :
             {VariantKind::as_it_is, VariantKind::turned, VariantKind::turned_more}) {
            if (const VariantRun* run = study_->find(kind))
                counts.push_back(
                    fmt::format("{} and {} {}", run->steps, run->rejected_steps, run->variant.title));
        }
        say("Turned in space, other steps were taken, which round-off can decide (steps and cuts: {}): that "
            "the motion then differs by {} says nothing of its orientation.",
            fmt::join(counts, ", "),
            describe_share(study_->largest_difference(&SeriesReport::turned_difference)));
    }

    // Where runs that would show errors are missing.
    void tell_lack_of_runs() {
        std::vector<std::string> titles;
        for (const DeckVariant& variant : study_->variants) {
            const bool shows_errors =
                variant.kind == VariantKind::finer_steps || variant.kind == VariantKind::finer_mesh;
            if (shows_errors && study_->lacks(variant.kind)) titles.push_back(variant.title);
        }
        say("How right the series are is not known, as no such run has reached its end: {}.",
            fmt::join(titles, ", "));
    }

    // Where nothing is known of errors: finer steps were the same ones, nearly.
    void tell_lack_of_steps() {
        const VariantRun& base = study_->runs.front();
        std::string counts = fmt::format("{}", base.steps);
        for (int level = 1; const VariantRun* run = study_->find(VariantKind::finer_steps, level); ++level) {
            if (run->is_whole()) counts += fmt::format(", {} with {}", run->steps, run->variant.title);
        }
        if (study_->is_adaptive) {
            say("Something else than the tolerance sets the steps, such as what Newton's method needs ({}): "
                "what they add cannot be told, nor how right the series are. Choose a smaller tolerance "
                "before anything else.",
                counts);
        } else {
            say("Steps that did not converge were cut, and finer ones came to nearly the same ({}): what the "
                "step adds cannot be told, nor how right the series are. Take more than {} steps before "
                "anything else.",
                counts,
                base.steps);
        }
    }

    void judge_accuracy() {
        std::vector<std::string> right;
        for (const SeriesReport& report : study_->series) {
            if (report.error <= study_->tolerance * report.scale) right.push_back(report.series.title());
        }
        const std::string goal = describe_share(study_->tolerance);
        if (right.size() == study_->series.size()) {
            say("All series are right to {} of their largest change.", goal);
            return;
        }
        if (!right.empty()) say("Right to {} of their largest change: {}.", goal, fmt::join(right, ", "));
        std::vector<std::string> wrong, still;
        for (const SeriesReport& report : study_->series) {
            if (report.error <= study_->tolerance * report.scale) continue;
            (report.scale > 0.0 ? wrong : still)
                .push_back(report.scale > 0.0 ? describe_miss(report) : report.series.title());
        }
        if (!wrong.empty()) say("Not right to {}: {}.", goal, fmt::join(wrong, ", "));
        if (!still.empty())
            say("Not to be judged, as nothing of the kind changes but by round-off: {}.",
                fmt::join(still, ", "));
    }

    // "tip force (2.8 %, right up to t = 4.55)".
    std::string describe_miss(const SeriesReport& report) const {
        const std::string size = describe_share(report.relative(report.error));
        const char* clock = study_->is_static ? "load factor" : "t =";
        return report.trusted_until > 0.0 ? fmt::format("{} ({}, right up to {} {:.4g})",
                                                        report.series.title(),
                                                        size,
                                                        clock,
                                                        report.trusted_until)
                                          : fmt::format("{} ({})", report.series.title(), size);
    }

    // Of the series that has the fewest digits.
    void tell_round_off() {
        const SeriesReport* worst = nullptr;
        for (const SeriesReport& report : study_->series) {
            const double share = report.relative(report.round_off);
            if (std::isfinite(share) && share > 0.5 * study_->tolerance &&
                (worst == nullptr || share > worst->relative(worst->round_off)))
                worst = &report;
        }
        if (worst == nullptr) return;
        say("Round-off alone changes {} by {}: the model lets it have no more digits, whatever the step and "
            "mesh.",
            worst->series.title(),
            describe_share(worst->relative(worst->round_off)));
    }

    // Whether what a step or mesh adds may stay.
    bool is_enough(const Worst& worst) const {
        return worst.share <= 0.5 * study_->tolerance || study_->is_accurate();
    }

    void judge_steps() {
        const Worst worst = find_worst(*study_, &SeriesReport::steps);
        if (worst.report == nullptr || !worst.report->steps.is_known()) return;
        const ErrorEstimate& steps = worst.report->steps;
        const std::string what = worst.report->series.title();
        if (study_->is_static) {
            if (worst.share > 1e-6) {
                say("The state depends on the load steps by {} ({}). Elements objective do not; else this "
                    "is a second equilibrium.",
                    describe_share(worst.share),
                    what);
            }
            return;
        }
        if (!steps.is_supported && steps.differences.size() > 1) {
            say("Errors do not fall with the step ({}: {:.2g}, {:.2g}): these steps do not resolve the "
                "motion, or "
                "it is one in which errors grow without bound. Take shorter steps before anything else.",
                what,
                steps.differences[0],
                steps.differences[1]);
            return;
        }
        if (steps.order && *steps.order < study_->expected_order - order_slack) {
            say("Errors fall with the step with order {:.1f}, less than the scheme's {:.0f} ({}): the "
                "steps are still too long for the fastest motion, or a load jumps.",
                *steps.order,
                study_->expected_order,
                what);
        }
        if (is_enough(worst)) return;
        const char* remedy =
            study_->is_adaptive
                ? "Steps {0:.0f} times as short, with 1/{1:.0f} of the tolerance and 1/{0:.0f} of "
                  "min_step, max_step and the first step,"
                : "A step {0:.0f} times as short";
        advise(worst, steps, study_->expected_order, "step", remedy);
    }

    void judge_mesh() {
        const Worst worst = find_worst(*study_, &SeriesReport::mesh);
        if (worst.report == nullptr || !worst.report->mesh.is_known()) return;
        const ErrorEstimate& mesh = worst.report->mesh;
        if (!mesh.is_supported && mesh.differences.size() > 1) {
            say("Errors do not fall with the mesh ({}: {:.2g}, {:.2g}): it is too coarse for this motion, "
                "or the series has no limit, as a force has none at a front. Take more elements before "
                "anything else.",
                worst.report->series.title(),
                mesh.differences[0],
                mesh.differences[1]);
            return;
        }
        if (is_enough(worst)) return;
        advise(worst, mesh, study_->mesh_order, "mesh", "{0:.0f} times as many elements");
        const double raised = worst.report->relative(worst.report->order_difference);
        if (raised > 0.0) {
            say("Elements of the next order change {} by {}.",
                worst.report->series.title(),
                describe_share(raised));
        }
    }

    void tell_unrefined_rods() {
        if (study_->unrefined_rods.empty()) return;
        say("Not known is what the elements of rods from mesh files ({}) add, as they cannot be refined "
            "here; compare with a finer mesh.",
            fmt::join(study_->unrefined_rods, ", "));
    }

    // `remedy` has places for by what to refine, and for its fourth power.
    void advise(const Worst& worst,
                const ErrorEstimate& estimate,
                double expected,
                const char* name,
                const char* remedy) {
        const double order = order_to_use(estimate, expected);
        const double factor = find_factor(worst.share, study_->tolerance, order);
        const std::string what = fmt::format(
            "The {} adds {} to {}. ", name, describe_share(worst.share), worst.report->series.title());
        if (factor > most_refinement) {
            sentences_.push_back(what + "No refinement within reach would mend that.");
            return;
        }
        sentences_.push_back(
            what + fmt::format(fmt::runtime(remedy), factor, std::pow(factor, 4.0)) +
            fmt::format(" would bring that to {}.", describe_share(worst.share / std::pow(factor, order))));
    }

    void judge_books() {
        const TraceBooks& books = study_->runs.front().books;
        if (books.largest_energy <= 0.0) return;
        const double share = books.largest_energy_error / books.largest_energy;
        if (share <= study_->tolerance) return;
        const VariantRun* finer = study_->find(VariantKind::finer_steps, 1);
        const bool is_mended = finer == nullptr || !finer->is_whole() ||
                               finer->books.largest_energy_error < books.largest_energy_error;
        say("Energy is out of balance by {} of its largest value; {}",
            describe_share(share),
            is_mended ? "halve the step until it is not."
                      : fmt::format("{} does not mend that.", finer->variant.title));
    }

    void tell_failures() {
        for (const VariantRun& run : study_->runs) {
            const bool must_be_equal =
                run.variant.kind == VariantKind::resumed || run.variant.kind == VariantKind::two_threads;
            if (run.is_whole() || must_be_equal) continue;
            say("The run \"{}\" failed, so that estimates lack it: {}.", run.variant.title, run.failure);
        }
    }

    const DeckStudy* study_;
    std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> judge(const DeckStudy& study) { return Judge(study).judge(); }

}  // namespace gxrod
