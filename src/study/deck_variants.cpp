#include "study/deck_variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/text/override_key.hpp"
#include "model/settings/analysis_traits.hpp"
#include "model/settings/newton_choice.hpp"
#include "study/method_traits.hpp"
#include "study/studied_stage.hpp"
#include "watch/quantities.hpp"

namespace gxrod {

namespace {

constexpr int highest_order = 4;
constexpr double error_fall = 16.0;  // of one step of sdirk-4, estimated with order 3, with half the step

std::string rod_key(const std::string& name, const char* key) { return join_key({"rod", name, key}, 3); }

// The rods whose deck gives their number and order of elements: all but those of a mesh.
std::vector<const Rod*> list_rods(const Problem& problem, bool of_meshes) {
    const DeckNode deck = read_toml(problem.record.text, problem.record.name);
    std::vector<const Rod*> rods;
    const DeckEntry* tables = deck.find("rod");
    for (const Rod& rod : problem.model.rods) {
        const DeckEntry* table = tables == nullptr ? nullptr : tables->node.find(rod.name);
        const bool is_of_mesh = table == nullptr || table->node.find("elements") == nullptr;
        if (is_of_mesh == of_meshes) rods.push_back(&rod);
    }
    return rods;
}

// The tolerance that halves the steps `level` times, and bounds of theirs and of Newton's method that let it.
std::vector<std::string> refine(const AdaptiveSettings& adaptive,
                                const NewtonSettings& newton,
                                const std::string& table,
                                int level) {
    std::vector<std::string> overrides;
    const auto divide = [&](const char* key, double value, double divisor) {
        for (int i = 0; i < level; ++i) value /= divisor;
        overrides.push_back(fmt::format("{}.{}={:.17g}", table, key, value));
    };
    divide("adaptive.tolerance", adaptive.tolerance, error_fall);
    if (adaptive.min_step > 0.0) divide("adaptive.min_step", adaptive.min_step, 2.0);
    if (std::isfinite(adaptive.max_step)) divide("adaptive.max_step", adaptive.max_step, 2.0);
    if (newton.tolerance) divide("newton.tolerance", *newton.tolerance, error_fall);
    return overrides;
}

// Whether a signal measures along axes that do not turn with the model.
bool measures_directions(const Problem& problem) {
    return std::ranges::any_of(problem.signals, [&](const SignalPlan& signal) {
        if (!signal.measure) return false;
        const HistoryRequest& request = problem.output.histories[signal.measure->history];
        return request.relative_node < 0 &&
               quantity_of(request.target, signal.measure->quantity).turning != Turning::none;
    });
}

// The keys of a stage's table that refine its steps.
std::vector<std::string> refine_steps(const AnalysisSettings& analysis, const std::string& table, int level) {
    std::vector<std::string> overrides;
    if (const AdaptiveSettings* adaptive = adaptive_of(analysis))
        overrides = refine(*adaptive, newton_of(analysis), table, level);
    const auto* dynamic = std::get_if<DynamicSettings>(&analysis);
    const long steps = dynamic != nullptr ? dynamic->steps : steps_of(analysis);
    overrides.push_back(fmt::format("{}.steps={}", table, (1 << level) * steps));
    return overrides;
}

const char* title_finer_steps(const AnalysisSettings& analysis, int level) {
    if (adaptive_of(analysis) != nullptr)
        return level == 1 ? "1/16 of the tolerance" : "1/256 of the tolerance";
    if (std::holds_alternative<DynamicSettings>(analysis))
        return level == 1 ? "half the step" : "a quarter of the step";
    return level == 1 ? "twice the load steps" : "four times the load steps";
}

// Of all stages up to the studied one; paths choose their steps by themselves.
DeckVariant make_finer_steps(const Problem& problem, int level) {
    DeckVariant variant{VariantKind::finer_steps, level, title_finer_steps(studied_analysis(problem), level)};
    variant.cost = 1 << level;
    for (std::size_t i = 0; i < problem.stages.size(); ++i) {
        const StagePlan& stage = problem.stages[i];
        if (!has_steps(stage.analysis) || is_path(stage.analysis)) continue;
        const std::string table = stage.name.empty() ? "analysis" : fmt::format("stage[{}]", i);
        for (std::string& key : refine_steps(stage.analysis, table, level))
            variant.overrides.push_back(std::move(key));
    }
    return variant;
}

DeckVariant make_finer_mesh(const std::vector<const Rod*>& rods, int level) {
    DeckVariant variant{
        VariantKind::finer_mesh, level, level == 1 ? "twice the elements" : "four times the elements"};
    const int factor = 1 << level;
    variant.cost = factor;
    for (const Rod* rod : rods) {
        variant.overrides.push_back(
            fmt::format("{}={}", rod_key(rod->name, "elements"), factor * rod->element_count()));
    }
    return variant;
}

}  // namespace

std::vector<DeckVariant> list_variants(const Problem& problem, int levels) {
    std::vector<DeckVariant> variants{{VariantKind::as_it_is, 0, "as it is"}};
    for (int level = 1; level <= levels; ++level) variants.push_back(make_finer_steps(problem, level));
    const std::vector<const Rod*> refinable = list_rods(problem, false);
    for (int level = 1; level <= levels && !refinable.empty(); ++level) {
        variants.push_back(make_finer_mesh(refinable, level));
    }
    DeckVariant order{VariantKind::higher_order, 1, "elements of the next order", {}, 2.0};
    DeckVariant simo{VariantKind::simo, 0, "elements simo", {}, 1.5};
    for (const Rod* rod : refinable) {
        if (rod->order < highest_order)
            order.overrides.push_back(fmt::format("{}={}", rod_key(rod->name, "order"), rod->order + 1));
    }
    for (const Rod& rod : problem.model.rods) {
        if (rod.kind == ElementKind::objective)
            simo.overrides.push_back(fmt::format("{}=simo", rod_key(rod.name, "element")));
    }
    if (!order.overrides.empty()) variants.push_back(order);
    if (!measures_directions(problem)) {
        variants.push_back({VariantKind::turned, 0, "turned in space"});
        variants.push_back({VariantKind::turned_more, 0, "turned by 1e-6 rad more"});
    }
    if (!simo.overrides.empty()) variants.push_back(simo);
    variants.push_back({VariantKind::resumed, 0, "stopped midway and resumed"});
    variants.push_back({VariantKind::two_threads, 0, "two threads"});
    return variants;
}

std::vector<std::string> list_unrefined_rods(const Problem& problem) {
    std::vector<std::string> names;
    for (const Rod* rod : list_rods(problem, true)) names.push_back(rod->name);
    return names;
}

double total_cost(const std::vector<DeckVariant>& variants) {
    double cost = 0.0;
    for (const DeckVariant& variant : variants) cost += variant.cost;
    return cost;
}

}  // namespace gxrod
