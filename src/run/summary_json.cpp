#include "run/summary_json.hpp"

#include <nlohmann/json.hpp>

#include "model/version.hpp"

namespace gxrod {

namespace {

nlohmann::ordered_json describe_sweep(const std::string& stage, const SweepRecord& sweep) {
    nlohmann::ordered_json onsets = nlohmann::ordered_json::array();
    for (const Onset& onset : sweep.onsets) {
        onsets.push_back({{"value", onset.value},
                          {"kind", name_kind(onset)},
                          {"omega", onset.omega},
                          {"begins", onset.begins}});
    }
    return {{"stage", stage}, {"sweep", sweep.key}, {"modes", sweep.words}, {"onsets", onsets}};
}

nlohmann::ordered_json describe_shapes(const FoundShapes& found) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    bool is_complete = false;
    if (const auto* modes = std::get_if<ModesRecord>(&found.record)) {
        is_complete = modes->is_complete;
        for (const Mode& mode : modes->modes)
            rows.push_back(
                {{"frequency", mode.frequency}, {"growth", mode.growth}, {"words", mode.shape.words}});
    } else if (const auto* eigenvalues = std::get_if<EigenvaluesRecord>(&found.record)) {
        is_complete = eigenvalues->is_complete || eigenvalues->is_all;
        for (const Eigenmode& mode : eigenvalues->modes) {
            rows.push_back(
                {{"frequency", mode.frequency}, {"growth", mode.growth}, {"words", mode.shape.words}});
        }
    } else if (std::holds_alternative<ResponseRecord>(found.record)) {
        is_complete = true;
    } else if (const auto* sweep = std::get_if<SweepRecord>(&found.record)) {
        return describe_sweep(found.stage, *sweep);
    } else {
        const auto& buckling = std::get<BucklingRecord>(found.record);
        is_complete = buckling.is_complete;
        for (const BucklingFactor& one : buckling.factors)
            rows.push_back({{"factor", one.factor}, {"words", one.shape.words}});
    }
    return {{"stage", found.stage}, {"complete", is_complete}, {"shapes", rows}};
}

}  // namespace

nlohmann::ordered_json describe_summary(const RunSummary& summary,
                                        const std::string& deck,
                                        const std::string& results) {
    nlohmann::ordered_json found = nlohmann::ordered_json::array();
    for (const FoundShapes& shapes : summary.shapes) found.push_back(describe_shapes(shapes));
    return {
        {"status", name_of(summary.status)},
        {"reason", summary.reason},
        {"warnings", summary.warnings},
        {"findings", summary.findings},
        {"deck", deck},
        {"results", results},
        {"nodes", summary.nodes},
        {"elements", summary.elements},
        {"unknowns", summary.unknowns},
        {"integrator", summary.integrators},
        {"steps", summary.totals.steps},
        {"rejected_steps", summary.totals.rejected_steps},
        {"cuts", summary.cuts},
        {"newton_limit", summary.newton_limit},
        {"newton_iterations", summary.totals.newton_iterations},
        {"time", summary.time},
        {"found", found},
        {"wall_seconds",
         {{"total", summary.wall_seconds},
          {"setup", summary.phases.setup},
          {"assembly", summary.phases.assembly},
          {"solve", summary.phases.solve},
          {"update", summary.phases.update},
          {"output", summary.phases.output}}},
        {"threads", summary.threads},
        {"version", version},
    };
}

}  // namespace gxrod
