#include "verification/deck_study_text.hpp"

namespace gxrod {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const ErrorEstimate& estimate, bool with_curves) {
    if (!estimate.is_known()) return nullptr;
    Json json{{"differences", estimate.differences},
              {"order", estimate.order ? Json(*estimate.order) : Json(nullptr)},
              {"error", estimate.largest()},
              {"supported", estimate.is_supported}};
    if (with_curves) json["errors"] = estimate.errors;
    return json;
}

Json to_json(const TraceBooks& books) {
    return {{"largest_energy", books.largest_energy},
            {"energy_error", books.largest_energy_error},
            {"momentum_scale", books.momentum_scale},
            {"linear_imbalance", books.linear_imbalance},
            {"angular_scale", books.angular_scale},
            {"angular_imbalance", books.angular_imbalance}};
}

Json to_json(const VariantRun& run) {
    return {{"run", run.variant.title},
            {"set", run.variant.overrides},
            {"elements", run.elements},
            {"unknowns", run.unknowns},
            {"steps", run.steps},
            {"newton_iterations", run.newton_iterations},
            {"seconds", run.seconds},
            {"failure", run.is_whole() ? Json(nullptr) : Json(run.failure)},
            {"books", to_json(run.books)}};
}

Json to_json(const SeriesReport& report, bool with_curves) {
    return {{"point", report.series.point},
            {"quantity", report.series.name},
            {"scale", report.scale},
            {"still", report.is_still},
            {"steps", to_json(report.steps, with_curves)},
            {"mesh", to_json(report.mesh, with_curves)},
            {"error", report.error},
            {"relative_error", report.relative(report.error)},
            {"trusted_until", report.trusted_until},
            {"next_order_difference", report.order_difference},
            {"turned_difference", report.turned_difference},
            {"simo_difference", report.simo_difference}};
}

}  // namespace

Json to_json(const DeckStudy& study, bool with_curves) {
    Json json{{"deck", study.deck},
              {"title", study.title},
              {"analysis", study.is_static ? "static" : "dynamic"},
              {"end_time", study.end_time},
              {"expected_order", study.expected_order},
              {"tolerance", study.tolerance},
              {"rotation", {study.rotation.x(), study.rotation.y(), study.rotation.z()}},
              {"own_histories", study.has_own_histories},
              {"interrupted", study.is_interrupted},
              {"sound", study.is_sound()},
              {"accurate", study.is_accurate()},
              {"judgement", judge(study)},
              {"runs", Json::array()},
              {"series", Json::array()}};
    for (const VariantRun& run : study.runs) json["runs"].push_back(to_json(run));
    for (std::size_t k = 0; k < study.series.size(); ++k) {
        Json series = to_json(study.series[k], with_curves);
        if (with_curves) series["values"] = study.base_rows[k];
        json["series"].push_back(series);
    }
    if (with_curves) json["times"] = study.times;
    return json;
}

}  // namespace gxrod
