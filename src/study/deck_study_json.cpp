#include "study/deck_study_text.hpp"

#include "model/version.hpp"

namespace gxrod {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_points = 500;  // of a curve

// Which samples a curve has; none if there is to be no curve.
using Chosen = std::vector<std::size_t>;

Chosen choose_samples(std::size_t count, bool with_curves) {
    Chosen chosen;
    if (!with_curves || count == 0) return chosen;
    const std::size_t points = std::min(count, most_points);
    for (std::size_t i = 0; i + 1 < points; ++i) chosen.push_back(i * (count - 1) / (points - 1));
    chosen.push_back(count - 1);
    return chosen;
}

template <class Value>
Json pick(const std::vector<Value>& values, const Chosen& chosen) {
    Json picked = Json::array();
    for (const std::size_t i : chosen) picked.push_back(i < values.size() ? Json(values[i]) : Json(nullptr));
    return picked;
}

Json to_json(const ErrorEstimate& estimate, const Chosen& chosen) {
    if (!estimate.is_known()) return nullptr;
    Json json{{"differences", estimate.differences},
              {"order", estimate.order ? Json(*estimate.order) : Json(nullptr)},
              {"error", estimate.largest()},
              {"supported", estimate.is_supported}};
    if (!chosen.empty()) json["errors"] = pick(estimate.errors, chosen);
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
            {"rejected_steps", run.rejected_steps},
            {"newton_iterations", run.newton_iterations},
            {"seconds", run.seconds},
            {"untried", run.untried.empty() ? Json(nullptr) : Json(run.untried)},
            {"failure", run.is_whole() ? Json(nullptr) : Json(run.failure)},
            {"warnings", run.warnings},
            {"books", to_json(run.books)}};
}

Json to_json(const SeriesReport& report, bool knows_round_off, const Chosen& chosen) {
    return {{"point", report.series.point},
            {"quantity", report.series.name},
            {"scale", report.scale},
            {"still", report.is_still},
            {"steps", to_json(report.steps, chosen)},
            {"mesh", to_json(report.mesh, chosen)},
            {"error", report.error},
            {"relative_error", report.relative(report.error)},
            {"trusted_until", report.trusted_until},
            {"next_order_difference", report.order_difference},
            {"round_off", knows_round_off ? Json(report.round_off) : Json(nullptr)},
            {"turned_difference", report.turned_difference},
            {"simo_difference", report.simo_difference}};
}

}  // namespace

Json to_json(const DeckStudy& study, bool with_curves) {
    Json json{{"gxrod_version", version},
              {"deck", study.deck},
              {"stage", study.stage.empty() ? Json(nullptr) : Json(study.stage)},
              {"title", study.title},
              {"analysis", study.is_static ? "static" : "dynamic"},
              {"end_time", study.end_time},
              {"expected_order", study.expected_order},
              {"tolerance", study.tolerance},
              {"motion", study.motion},
              {"rotation", {study.rotation.x(), study.rotation.y(), study.rotation.z()}},
              {"own_histories", study.has_own_histories},
              {"unrefined_rods", study.unrefined_rods},
              {"interrupted", study.is_interrupted},
              {"sound", study.is_whole() ? Json(study.is_sound()) : Json(nullptr)},
              {"orientation_judged", study.is_orientation_judged()},
              {"stable", study.is_stable()},
              {"accurate", study.is_accurate()},
              {"judgement", judge(study)},
              {"runs", Json::array()},
              {"series", Json::array()}};
    for (const VariantRun& run : study.runs) json["runs"].push_back(to_json(run));
    const std::size_t samples = study.base_rows.empty() ? 0 : study.base_rows.front().size();
    const Chosen chosen = choose_samples(samples, with_curves);
    for (std::size_t k = 0; k < study.series.size(); ++k) {
        Json series = to_json(study.series[k], study.knows_round_off(), chosen);
        if (with_curves) series["values"] = pick(study.base_rows[k], chosen);
        json["series"].push_back(series);
    }
    if (with_curves) json["times"] = pick(study.times, chosen);
    return json;
}

}  // namespace gxrod
