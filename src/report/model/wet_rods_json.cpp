#include "report/model/wet_rods_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/settings/analysis_traits.hpp"

namespace gxrod {
namespace {

using Json = nlohmann::ordered_json;

// Parts of a stage between which gravity is linear.
constexpr int most_parts = 20;

Json describe_section(double s, const SectionInFluid& fluid) {
    return {s, fluid.area, fluid.contents_area, fluid.contents_density, fluid.contents_pressure};
}

// [arc length, areas and contents] at the nodes of elements, or once; empty of a rod that is not in fluids.
Json describe_sections(const Model& model, const Rod& rod) {
    Json rows = Json::array();
    const auto& mean = model.sections[static_cast<std::size_t>(rod.section)].fluid;
    if (!mean) return rows;
    if (!rod.has_varying_sections()) return Json::array({describe_section(0.0, *mean)});
    for (std::size_t i = 0; i < rod.arc_length.size(); ++i)
        rows.push_back(describe_section(rod.arc_length[i], *rod.varying.at_nodes[i].fluid));
    return rows;
}

// [time of the results, size of gravity, density of the water that presses].
Json list_gravity(const Problem& problem) {
    Json rows = Json::array();
    double start = find_axis_start(problem.stages);
    for (std::size_t i = 0; i < problem.stages.size(); ++i) {
        const StagePlan& stage = problem.stages[i];
        const TimeVector& gravity = i == 0 ? problem.model.gravity : stage.actions.gravity;
        const Water& water = *(i == 0 ? problem.model.surroundings : stage.actions.surroundings).water;
        const double length = has_steps(stage.analysis) ? end_of(stage.analysis) : 0.0;
        for (int part = 0; part <= most_parts; ++part) {
            const double time = length * part / most_parts;
            // Without a surface there is no pressure outside.
            const double density = water.surface ? water.density_at(time) : 0.0;
            rows.push_back({start + time, gravity(time).norm(), density});
        }
        start += length;
    }
    return rows;
}

bool has_path(const Problem& problem) {
    return std::ranges::any_of(problem.stages,
                               [](const StagePlan& stage) { return is_path(stage.analysis); });
}

}  // namespace

Json describe_wet_rods(const Problem& problem) {
    Json json = Json::object();
    Json rods = Json::array();
    for (const Rod& rod : problem.model.rods) rods.push_back(describe_sections(problem.model, rod));
    json["rods"] = rods;
    const auto& water = problem.model.surroundings.water;
    // The time of a path does not say what acts.
    if (!water || has_path(problem)) return json;
    json["gravity"] = list_gravity(problem);
    json["surface"] = water->surface.value_or(0.0);
    return json;
}

}  // namespace gxrod
