#pragma once

#include <string>
#include <vector>

#include "study/deck_study_text.hpp"
#include "watch/quantities.hpp"

// Studies that were made up, to be judged.
namespace gxrod::test {

inline ErrorEstimate make_estimate(double size, double order, double expected = 2.0) {
    const double fall = std::exp2(-order);
    const double first = size * (1.0 - fall);
    return estimate_error({{0.0, first}, {0.0, first * fall}}, expected, 1e-12);
}

inline SeriesReport make_report(const std::string& point, double step, double mesh) {
    SeriesReport report;
    report.series = {point, "position", 0, find_quantity("position"), Turning::vector};
    report.scale = 2.0;
    report.steps = make_estimate(2.0 * step, 2.0);
    report.mesh = make_estimate(2.0 * mesh, 2.0);
    report.error = 2.0 * (step + mesh);
    report.trusted_until = report.error <= 0.02 ? 1.0 : 0.25;
    return report;
}

inline DeckStudy make_study(const std::vector<SeriesReport>& series) {
    DeckStudy study;
    for (const DeckVariant& variant : {DeckVariant{VariantKind::as_it_is, 0, "as it is"},
                                       DeckVariant{VariantKind::finer_steps, 1, "half the step"},
                                       DeckVariant{VariantKind::turned, 0, "turned in space"},
                                       DeckVariant{VariantKind::resumed, 0, "stopped midway and resumed"},
                                       DeckVariant{VariantKind::two_threads, 0, "two threads"}}) {
        VariantRun run;
        run.variant = variant;
        run.books.largest_energy = 10.0;
        run.books.largest_energy_error = 0.01;
        study.runs.push_back(run);
    }
    study.series = series;
    return study;
}

inline bool says(const DeckStudy& study, const std::string& part) {
    for (const std::string& sentence : judge(study)) {
        if (sentence.find(part) != std::string::npos) return true;
    }
    return false;
}

}  // namespace gxrod::test
