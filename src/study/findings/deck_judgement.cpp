#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "study/deck_study_text.hpp"
#include "study/findings/deck_advice.hpp"
#include "study/findings/share_words.hpp"

namespace gxrod {

namespace {

// Times what round-off was seen to change, one case of many.
constexpr double near_round_off = 100.0;

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
        judge_stability();
        judge_orientation();
        if (study_->has_finer_steps()) {
            if (study_->knows_errors())
                judge_accuracy();
            else
                tell_lack_of_runs();
            tell_round_off();
            add(advise_on_steps(*study_));
            add(advise_on_mesh(*study_));
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

    void add(std::vector<std::string> sentences) {
        std::move(sentences.begin(), sentences.end(), std::back_inserter(sentences_));
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

    void judge_stability() {
        if (study_->is_stable()) return;
        say("No series is called right, since the structure would not stay at these equilibria: {}.",
            fmt::join(study_->runs.front().warnings, "; "));
    }

    bool has_failed(VariantKind kind) const {
        const VariantRun* run = study_->find(kind);
        return run != nullptr && !run->is_whole();
    }

    void judge_orientation() {
        if (study_->depends_on_orientation()) {
            say("The motion depends on the model's orientation in space, by more than its errors. If no "
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
        if (!study_->unrefined_rods.empty()) {
            say("How right the series are is not known, as the elements of rods from mesh files ({}) cannot "
                "be "
                "refined here; compare with a finer mesh.",
                fmt::join(study_->unrefined_rods, ", "));
            return;
        }
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
        const UnrefinedPart part = study_->find_unrefined_part().value_or(UnrefinedPart{});
        const VariantRun& base = study_->runs.front();
        const bool is_all = part.coarse_steps == base.own_steps() || part.until <= 0.0;
        const std::string where =
            is_all ? "" : fmt::format("between t = {:.4g} and {:.4g}, ", part.from, part.until);
        const std::string counts =
            fmt::format("{}{}, {} with finer ones", where, part.coarse_steps, part.fine_steps);
        if (study_->is_adaptive) {
            say("Something else than the tolerance sets the steps, such as what Newton's method needs ({}): "
                "what they add cannot be determined, nor how right the series are. Choose a smaller "
                "tolerance "
                "before anything else.",
                counts);
        } else {
            say("Steps that did not converge were cut, and finer ones came to nearly the same ({}): what the "
                "step adds cannot be determined, nor how right the series are. Take {} before anything else.",
                counts,
                is_all ? fmt::format("more than {} steps", base.own_steps()) : "shorter steps");
        }
    }

    void judge_accuracy() {
        const std::string goal = describe_share(study_->tolerance);
        if (study_->is_accurate()) {
            say("All series are right to {} of their largest change.", goal);
            return;
        }
        if (!study_->is_stable() && study_->has_small_errors()) {
            say("Step and mesh add less than {} to all series.", goal);
            return;
        }
        std::vector<std::string> right, wrong, still, unknown;
        for (const SeriesReport& report : study_->series) {
            const std::string title = report.series.title();
            if (report.is_right(study_->tolerance)) {
                right.push_back(title);
            } else if (!std::isfinite(report.error)) {
                unknown.push_back(title);
            } else if (report.scale > 0.0) {
                wrong.push_back(describe_miss(report));
            } else if (report.error <= near_round_off * report.round_off) {
                still.push_back(title);
            } else {
                wrong.push_back(title + " (it changes in finer runs alone)");
            }
        }
        if (!right.empty()) {
            say("{} {} of their largest change: {}.",
                study_->is_stable() ? "Right to" : "Step and mesh add less than",
                goal,
                fmt::join(right, ", "));
        }
        if (!wrong.empty()) say("Not right to {}: {}.", goal, fmt::join(wrong, ", "));
        if (!unknown.empty())
            say("Not known, as the finer runs do not come nearer to each other, or elements of the next "
                "order show "
                "what they miss: {}.",
                fmt::join(unknown, ", "));
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

    void judge_books() {
        const TraceBooks& books = study_->runs.front().books;
        // In statics it is the work of loads alone that is summed up coarsely.
        if (study_->is_static || books.largest_energy <= 0.0) return;
        const double share = books.largest_energy_error / books.largest_energy;
        if (share <= study_->tolerance) return;
        say("Energy is out of balance by {} of its largest value{}.",
            describe_share(share),
            describe_remedy(books));
    }

    // "; half the step does not mend that".
    std::string describe_remedy(const TraceBooks& books) const {
        const VariantRun* finer = study_->find(VariantKind::finer_steps, 1);
        if (finer == nullptr || !finer->is_whole()) return "";
        if (finer->books.largest_energy_error >= books.largest_energy_error)
            return fmt::format("; {} does not mend that", finer->variant.title);
        return study_->is_adaptive ? "; take a smaller tolerance until it is not"
                                   : "; halve the step until it is not";
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
