#include "study/deck_study_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gxrod {

namespace {

std::string describe_order(const ErrorEstimate& estimate) {
    if (estimate.order) return fmt::format("{:.2f}", *estimate.order);
    return "-";
}

std::string describe_error(const SeriesReport& report, double error) {
    const double share = report.relative(error);
    return std::isfinite(share) ? fmt::format("{:.1e}", share) : "?";
}

// An error by the series' scale: "1.2e-03", or "?" where runs do not support it.
std::string describe_part(const SeriesReport& report, const ErrorEstimate& estimate) {
    if (!estimate.is_known()) return "-";
    const std::string value = describe_error(report, estimate.largest());
    const bool is_sure = estimate.is_supported || estimate.differences.size() == 1 || value == "?";
    return is_sure ? value : value + "?";
}

std::string describe_trust(const DeckStudy& study, const SeriesReport& report) {
    if (!std::isfinite(report.error)) return "?";
    if (report.trusted_until >= study.end_time) return "all";
    return fmt::format("{:.4g}", report.trusted_until);
}

std::size_t longest_title(const DeckStudy& study) {
    std::size_t width = std::string("series").size();
    for (const SeriesReport& report : study.series) width = std::max(width, report.series.title().size());
    return width;
}

double ratio(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

// "3.1e-03 (with half the step 7.8e-04)".
std::string describe_balance(const DeckStudy& study, double TraceBooks::*error, double TraceBooks::*scale) {
    const auto value = [&](const VariantRun& run) {
        return fmt::format("{:.1e}", ratio(run.books.*error, run.books.*scale));
    };
    std::string text = value(study.runs.front());
    const VariantRun* finer = study.find(VariantKind::finer_steps, 1);
    if (finer != nullptr && finer->is_whole())
        text += fmt::format(" (with {} {})", finer->variant.title, value(*finer));
    return text;
}

std::string describe_difference(const DeckStudy& study,
                                const VariantRun& run,
                                double SeriesReport::*difference,
                                const char* words = "differs by") {
    if (!run.is_whole()) return "failed";
    if (!run.untried.empty()) return "not known: " + run.untried;
    return fmt::format("{} {:.1e}", words, study.largest_difference(difference));
}

std::string describe_equality(const VariantRun& run) {
    return fmt::format("{}: {}\n",
                       run.variant.title,
                       !run.untried.empty() ? "not tried: " + run.untried
                       : run.is_whole()     ? "the same to the last bit"
                                            : "NOT the same: " + run.failure);
}

}  // namespace

std::string describe_plan(const std::vector<DeckVariant>& variants) {
    return fmt::format("{} runs, which cost about {:.3g} times what the deck costs as it is\n",
                       variants.size(),
                       total_cost(variants));
}

std::string run_head() {
    return fmt::format(
        "{:<28}{:>10}{:>10}{:>9}{:>9}{:>10}\n", "run", "elements", "unknowns", "steps", "Newton", "seconds");
}

std::string describe_run(const VariantRun& run) {
    std::string line = fmt::format("{:<28}{:>10}{:>10}{:>9}{:>9}{:>10.2f}\n",
                                   run.variant.title,
                                   run.elements,
                                   run.unknowns,
                                   run.steps,
                                   run.newton_iterations,
                                   run.seconds);
    if (!run.is_whole()) line += fmt::format("  {}\n", run.failure);
    return line;
}

std::string describe_errors(const DeckStudy& study) {
    const std::size_t width = longest_title(study) + 2;
    std::string text = fmt::format("{:<{}}{:>12}{:>11}{:>7}{:>11}{:>7}{:>11}{:>10}\n",
                                   "series",
                                   width,
                                   "change",
                                   study.is_static ? "load steps" : "step",
                                   "order",
                                   "mesh",
                                   "order",
                                   "error",
                                   "right to");
    for (const SeriesReport& report : study.series) {
        text += fmt::format("{:<{}}{:>12.4g}{:>11}{:>7}{:>11}{:>7}{:>11}{:>10}\n",
                            report.series.title(),
                            width,
                            report.is_still ? 0.0 : report.scale,
                            describe_part(report, report.steps),
                            describe_order(report.steps),
                            describe_part(report, report.mesh),
                            describe_order(report.mesh),
                            describe_error(report, report.error),
                            describe_trust(study, report));
    }
    text += fmt::format(
        "change: the largest in the run; of rotations 1 rad at most; errors are by it, or where it is 0 by "
        "what is large in the model.\nstep, mesh: errors of the deck as it is, estimated from the finer "
        "runs; with ? where they do not fall as errors do. error: both.\nright to: the time up to which "
        "the error is below {:g}.\n",
        study.tolerance);
    return text;
}

std::string describe_properties(const DeckStudy& study) {
    std::string text;
    const TraceBooks& books = study.runs.front().books;
    if (books.largest_energy > 0.0) {
        text += fmt::format(
            "energy, its imbalance by the largest energy: {}\n",
            describe_balance(study, &TraceBooks::largest_energy_error, &TraceBooks::largest_energy));
    }
    if (!study.is_static && books.momentum_scale > 0.0) {
        text +=
            fmt::format("momentum, less the impulses, by its scale: linear {}, angular {}\n",
                        describe_balance(study, &TraceBooks::linear_imbalance, &TraceBooks::momentum_scale),
                        describe_balance(study, &TraceBooks::angular_imbalance, &TraceBooks::angular_scale));
    }
    if (const VariantRun* turned = study.find(VariantKind::turned)) {
        const bool is_same = study.is_orientation_judged() && !study.depends_on_orientation();
        text += fmt::format("{} by {:.3g} rad: {}\n",
                            turned->variant.title,
                            study.rotation.norm(),
                            describe_difference(study,
                                                *turned,
                                                &SeriesReport::turned_difference,
                                                is_same ? "the same, turned, to" : "differs by"));
    }
    if (const VariantRun* more = study.find(VariantKind::turned_more)) {
        text += fmt::format("{}, which shows round-off: {}\n",
                            more->variant.title,
                            describe_difference(study, *more, &SeriesReport::round_off));
    }
    for (const VariantKind kind : {VariantKind::higher_order, VariantKind::simo}) {
        const VariantRun* run = study.find(kind, kind == VariantKind::higher_order ? 1 : 0);
        if (run == nullptr) continue;
        const auto difference =
            kind == VariantKind::simo ? &SeriesReport::simo_difference : &SeriesReport::order_difference;
        text += fmt::format("{}: {}\n", run->variant.title, describe_difference(study, *run, difference));
    }
    for (const VariantKind kind : {VariantKind::resumed, VariantKind::two_threads}) {
        if (const VariantRun* run = study.find(kind)) text += describe_equality(*run);
    }
    return text;
}

}  // namespace gxrod
