#include "verification/study.hpp"

#include "verification/benchmark.hpp"
#include "verification/rod_schemes_study.hpp"
#include "verification/rubin2007_report.hpp"

#include <algorithm>

namespace gxrod {

bool StudyResult::matches() const {
    return std::all_of(checks.begin(), checks.end(), [](const Check& check) { return check.passed(); });
}

const std::vector<Study>& studies() {
    static const std::vector<Study> all = [] {
        std::vector<Study> list = {
            {"rod_schemes",
             "The integrators on flexible rods: errors of orientation, energy and momentum against cost",
             "order",
             "asked by Rubin (2007); reference by radau-5 with many more steps",
             rod_schemes::report},
            {"rubin2007",
             "The rigid body of Rubin (2007), section 6, by every scheme against its exact solution",
             "rigid body",
             "Rubin (2007), section 6; maxima of the errors by an independent program",
             rubin2007::report},
        };
        for (const Benchmark& benchmark : benchmarks()) {
            list.push_back({benchmark.name,
                            benchmark.sentence,
                            benchmark.kind,
                            benchmark.source,
                            [&benchmark](const StudyOptions&) { return report_benchmark(benchmark); }});
        }
        return list;
    }();
    return all;
}

}  // namespace gxrod
