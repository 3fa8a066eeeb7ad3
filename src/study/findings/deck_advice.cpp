#include "study/findings/deck_advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/findings/share_words.hpp"

namespace gxrod {

namespace {

constexpr double order_slack = 0.5;  // below the scheme's order, before it is called lower
constexpr double most_refinement = 64.0;

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

class Adviser {
  public:
    explicit Adviser(const DeckStudy& study) : study_(&study) {}

    std::vector<std::string> take_sentences() { return std::move(sentences_); }

    void judge_steps() {
        const Worst worst = find_worst(*study_, &SeriesReport::steps);
        if (worst.report == nullptr || !worst.report->steps.is_known()) return;
        const ErrorEstimate& steps = worst.report->steps;
        const std::string what = worst.report->series.title();
        if (study_->is_static && !study_->follows_motion) {
            if (worst.share > 1e-6) {
                say("The state depends on the load steps by {} ({}). Elements objective do not; else this "
                    "is a second equilibrium.",
                    describe_share(worst.share),
                    what);
            }
            return;
        }
        if (is_negligible(worst)) return;
        if (!steps.is_supported && steps.differences.size() > 1) {
            say("Errors do not fall with the step ({}: {:.2g}, {:.2g}): these steps do not resolve the "
                "motion, or "
                "it is one in which errors grow without bound. Take shorter steps before anything else.",
                what,
                steps.differences[0],
                steps.differences[1]);
            return;
        }
        if (is_enough(worst)) return;
        if (steps.order && *steps.order < study_->expected_order - order_slack) {
            say("Errors fall with the step with order {:.1f}, less than the scheme's {:.0f} ({}): the "
                "steps are still too long for the fastest motion, or a load jumps.",
                *steps.order,
                study_->expected_order,
                what);
        }
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
        if (is_negligible(worst)) return;
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
        advise(worst,
               mesh,
               study_->mesh_order_of(worst.report->series),
               "mesh",
               "{0:.0f} times as many elements");
        const double raised = worst.report->relative(worst.report->order_difference);
        if (raised > 0.0) {
            say("Elements of the next order change {} by {}.",
                worst.report->series.title(),
                describe_share(raised));
        }
    }

  private:
    template <class... Values>
    void say(fmt::format_string<Values...> format, Values&&... values) {
        sentences_.push_back(fmt::format(format, std::forward<Values>(values)...));
    }

    // Whether what a step or mesh adds may stay …
    bool is_enough(const Worst& worst) const { return worst.share <= 0.5 * study_->tolerance; }
    // … however it falls.
    bool is_negligible(const Worst& worst) const {
        return worst.share <= negligible * study_->tolerance || study_->has_small_errors();
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
            sentences_.push_back(
                what + fmt::format("It falls too slowly to say what would mend that: refine the {} and "
                                   "ask again.",
                                   name));
            return;
        }
        sentences_.push_back(
            what + fmt::format(fmt::runtime(remedy), factor, std::pow(factor, 4.0)) +
            fmt::format(" would bring that to {}.", describe_share(worst.share / std::pow(factor, order))));
    }

    const DeckStudy* study_;
    std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> advise_on_steps(const DeckStudy& study) {
    Adviser adviser(study);
    adviser.judge_steps();
    return adviser.take_sentences();
}

std::vector<std::string> advise_on_mesh(const DeckStudy& study) {
    Adviser adviser(study);
    adviser.judge_mesh();
    return adviser.take_sentences();
}

}  // namespace gxrod
