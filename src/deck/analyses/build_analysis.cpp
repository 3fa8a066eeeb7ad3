#include "deck/analyses/build_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "deck/analyses/analysis_table.hpp"
#include "deck/analyses/build_path.hpp"
#include "deck/analyses/build_response.hpp"
#include "deck/analyses/listed_numbers.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"
#include "machine/printable.hpp"
#include "model/settings/scheme_card.hpp"
#include "model/settings/scheme_choice.hpp"

namespace gxrod {
namespace {

// A step divides the time if it does so up to this, relative.
constexpr double divides = 1e-9;

// Of `accuracy`: a step may err by this part of what is asked for at the end.
constexpr double part_of_a_step = 0.01;
// Where steps are chosen by `accuracy`, the first one is this part of the whole time; it is repeated with
// shorter ones while its error is too large.
constexpr long first_part = 10'000;

long find_steps(const AnalysisTable& table, const BuildContext& context) {
    if (table.accuracy) return first_part;
    if (table.steps) return *table.steps;
    const double ratio = table.end_time / *table.time_step;
    const double nearest = std::max(1.0, std::round(ratio));
    const bool is_whole = std::abs(ratio - nearest) <= divides * nearest;
    const double steps = is_whole ? nearest : std::ceil(ratio);
    if (steps > static_cast<double>(largest_step_count)) {
        context.add_fault(
            table,
            table.time_step,
            fmt::format("{:.3g} steps are too many; expected at most {}", steps, largest_step_count));
        return 1;
    }
    if (!is_whole && !table.adaptive) {
        context.notes.push_back(fmt::format("{}: {} does not divide {}; {:.0f} steps of {} are taken",
                                            table.path_of(&table.time_step),
                                            *table.time_step,
                                            table.end_time,
                                            steps,
                                            table.end_time / steps));
    }
    return static_cast<long>(steps);
}

std::optional<AdaptiveSettings> build_adaptive(const AnalysisTable& analysis, const BuildContext& context) {
    if (analysis.accuracy) return AdaptiveSettings{.tolerance = part_of_a_step * *analysis.accuracy};
    if (!analysis.adaptive) return std::nullopt;
    const AdaptiveTable& table = *analysis.adaptive;
    AdaptiveSettings adaptive{.tolerance = table.tolerance, .min_step = table.min_step};
    if (table.max_step) adaptive.max_step = *table.max_step;
    if (adaptive.max_step < adaptive.min_step) {
        context.add_fault(
            table,
            table.max_step,
            fmt::format(
                "expected a number not below min_step, {}; found {}", adaptive.min_step, adaptive.max_step));
    }
    return adaptive;
}

// Says so where the first step is not what the deck asks for.
void note_first_step(const DynamicSettings& settings,
                     const AnalysisTable& table,
                     const BuildContext& context) {
    const AdaptiveSettings& adaptive = *settings.adaptive;
    const double first = settings.time_step();
    if (first >= adaptive.min_step && first <= adaptive.max_step) return;
    const bool is_short = first < adaptive.min_step;
    context.notes.push_back(
        fmt::format("{}: the first step, {}, is {} adaptive.{}; it will be {}",
                    table.steps ? table.path_of(&table.steps) : table.path_of(&table.time_step),
                    first,
                    is_short ? "below" : "above",
                    is_short ? "min_step" : "max_step",
                    is_short ? adaptive.min_step : adaptive.max_step));
}

// Faults of the paper's tangent; `user` is what else the deck has in the place of its integrator, or "".
void check_paper_tangent(const NewtonTable& newton, const std::string& user, const BuildContext& context) {
    const std::string paper = word_of(tangent_choices, TangentKind::paper);
    if (!user.empty()) {
        context.add_fault(newton,
                          newton.tangent,
                          fmt::format("\"{}\" belongs to integrator \"{}\", not to {}",
                                      paper,
                                      card_of(Scheme::newmark_simplified).word,
                                      user));
    }
    if (!context.deck.tables("rod").empty()) {
        context.add_fault(newton,
                          newton.tangent,
                          fmt::format("\"{}\" is for decks of bodies alone; this one has rods", paper));
    }
}

// Stages that are found together share one matrix of their own.
void check_coupled_tangent(const NewtonTable& newton,
                           const DynamicSettings& settings,
                           bool is_open,
                           const BuildContext& context) {
    const TangentKind tangent = settings.newton.tangent;
    const SchemeCard& card = card_of(settings.scheme);
    if (!card.couples_stages || tangent == TangentKind::automatic || tangent == TangentKind::consistent)
        return;
    context.add_fault(
        newton,
        newton.tangent,
        fmt::format("\"{}\" {}; expected \"{}\"",
                    is_open ? open_scheme_word : card.word,
                    is_open ? "chooses the tangent, too"
                            : "finds the stages of a step together and has a tangent of its own",
                    word_of(tangent_choices, TangentKind::automatic)));
}

// A step of a motion changes the tangent little. Load steps change it much, and the pivots of their last one
// say whether equilibrium is stable.
void check_kept_tangent(const NewtonTable& newton, const std::string& user, const BuildContext& context) {
    context.add_fault(newton,
                      newton.tangent,
                      fmt::format("\"{}\" is for motions in time, not for {}; expected \"{}\"",
                                  word_of(tangent_choices, TangentKind::kept),
                                  user,
                                  word_of(tangent_choices, TangentKind::automatic)));
}

// Sets what the deck gives.
void read_newton(const AnalysisTable& analysis,
                 const std::string& user,
                 const BuildContext& context,
                 NewtonSettings& newton) {
    if (!analysis.newton) return;
    const NewtonTable& table = *analysis.newton;
    newton.tolerance = table.tolerance;
    newton.max_iterations = static_cast<int>(table.max_iterations);
    newton.tangent = table.tangent;
    if (newton.tangent == TangentKind::paper) check_paper_tangent(table, user, context);
    const bool is_motion =
        analysis.kind == AnalysisKind::dynamic || analysis.kind == AnalysisKind::quasi_static;
    if (newton.tangent == TangentKind::kept && !is_motion) check_kept_tangent(table, user, context);
}

DynamicSettings build_quasi_static(const AnalysisTable& table, const BuildContext& context) {
    DynamicSettings settings;
    settings.has_inertia = false;
    settings.scheme = quasi_static_scheme;
    settings.end_time = table.end_time;
    settings.steps = find_steps(table, context);
    settings.adaptive = build_adaptive(table, context);
    if (settings.adaptive) note_first_step(settings, table, context);
    read_newton(table, "quasi-static analyses", context, settings.newton);
    settings.linear_solver = table.linear_solver;
    return settings;
}

Scheme find_scheme(const AnalysisTable& table, const BuildContext& context) {
    const Scheme scheme = table.integrator.scheme.value_or(accurate_scheme);
    if (!table.accuracy || table.gives(table.integrator)) return scheme;
    for (const double* key : {&table.beta, &table.gamma}) {
        if (!table.gives(*key)) continue;
        context.add_fault(
            table,
            *key,
            fmt::format("accuracy without an integrator takes \"{}\", which does not use this key; give the "
                        "integrator",
                        card_of(accurate_scheme).word));
    }
    return accurate_scheme;
}

DynamicSettings build_dynamic(const AnalysisTable& table, const BuildContext& context) {
    DynamicSettings settings;
    settings.end_time = table.end_time;
    settings.steps = find_steps(table, context);
    settings.scheme = find_scheme(table, context);
    settings.beta = table.beta;
    settings.gamma = table.gamma;
    settings.spectral_radius = table.spectral_radius;
    settings.projects_start = table.start == StartVelocities::project;
    settings.adaptive = build_adaptive(table, context);
    if (settings.adaptive) note_first_step(settings, table, context);
    const bool is_papers_scheme = card_of(settings.scheme).has_paper_tangent;
    const std::string user = "\"" + word_of(scheme_choices, table.integrator) + "\"";
    read_newton(table, is_papers_scheme ? "" : user, context, settings.newton);
    if (table.newton) check_coupled_tangent(*table.newton, settings, !table.integrator.scheme, context);
    settings.linear_solver = table.linear_solver;
    return settings;
}

StaticSettings build_static(const AnalysisTable& table, const BuildContext& context) {
    StaticSettings settings;
    if (table.steps) settings.steps = *table.steps;
    read_newton(table, "static analyses", context, settings.newton);
    settings.linear_solver = table.linear_solver;
    return settings;
}

template <class Settings>
Settings build_shapes(const AnalysisTable& table) {
    Settings settings;
    if (table.count) settings.count = static_cast<int>(*table.count);
    if constexpr (requires { settings.below; }) settings.below = table.below;
    if constexpr (requires { settings.linearization; }) settings.linearization = table.linearization;
    return settings;
}

SteadySettings build_steady(const AnalysisTable& table, const BuildContext& context) {
    if (context.deck.tables("rotation").empty())
        context.add_fault(
            table, table.kind, "a steady stage turns with [rotation], which the deck does not have");
    return {build_static(table, context)};
}

EigenvalueSettings build_eigenvalues(const AnalysisTable& table, const BuildContext& context) {
    auto settings = build_shapes<EigenvalueSettings>(table);
    if (table.sweep) {
        settings.sweep = {table.sweep->key,
                          list_numbers(*table.sweep, context),
                          table.sweep->onset == OnsetSearch::locate,
                          table.sweep->shapes};
    }
    return settings;
}

PathSettings build_whole_path(const AnalysisTable& table, const BuildContext& context) {
    PathSettings path = build_path(table, context);
    read_newton(table, "paths", context, path.newton);
    path.linear_solver = table.linear_solver;
    return path;
}

AnalysisSettings build_analysis(const AnalysisTable& table, const BuildContext& context) {
    switch (table.kind) {
        case AnalysisKind::dynamic:
            break;
        case AnalysisKind::statics:
            return build_static(table, context);
        case AnalysisKind::quasi_static:
            return build_quasi_static(table, context);
        case AnalysisKind::path:
            return build_whole_path(table, context);
        case AnalysisKind::steady:
            return build_steady(table, context);
        case AnalysisKind::modes:
            return build_shapes<ModesSettings>(table);
        case AnalysisKind::buckling:
            return build_shapes<BucklingSettings>(table);
        case AnalysisKind::eigenvalues:
            return build_eigenvalues(table, context);
        case AnalysisKind::response:
            return build_response(table, context);
    }
    return build_dynamic(table, context);
}

// Groups, files and messages have the names of stages.
void check_stage_name(const AnalysisTable& table,
                      const std::vector<StagePlan>& earlier,
                      const BuildContext& context) {
    const std::string& name = table.stage_name;
    const bool is_plain = std::all_of(name.begin(), name.end(), [](char letter) {
        return letter == '_' || letter == '-' || std::isalnum(static_cast<unsigned char>(letter)) != 0;
    });
    if (name.empty() || !is_plain) {
        return context.add_fault(
            table, table.stage_name, "expected letters, digits, _ and -, found \"" + printable(name) + "\"");
    }
    const bool is_taken = std::any_of(
        earlier.begin(), earlier.end(), [&](const StagePlan& stage) { return stage.name == name; });
    if (is_taken)
        context.add_fault(table, table.stage_name, fmt::format("\"{}\" names an earlier stage, too", name));
}

// Gravity is a load once a revolution only where a frame turns.
void check_gravity(const StagePlan& stage,
                   bool turns,
                   const AnalysisTable& table,
                   const BuildContext& context) {
    const auto* response = std::get_if<ResponseSettings>(&stage.analysis);
    if (response == nullptr || !response->gravity) return;
    const std::vector<CheckedTable>& rotation = context.deck.tables("rotation");
    if (!turns || rotation.empty())
        return context.add_fault(
            table, table.gravity, "acts once a revolution, and the stage before is not one of kind steady");
    if (rotation.front().gives("spins"))
        context.add_fault(
            table,
            table.gravity,
            "what spins in a frame at rest has gravity as a load: expected the deck's key gravity");
}

// Modes and buckling know nothing of what turns with a frame.
void check_rotation(const std::vector<StagePlan>& stages, const BuildContext& context) {
    const auto is_steady = [](const StagePlan& stage) {
        return std::holds_alternative<SteadySettings>(stage.analysis);
    };
    const std::vector<CheckedTable>& rotation = context.deck.tables("rotation");
    if (!rotation.empty() && std::none_of(stages.begin(), stages.end(), is_steady)) {
        context.faults.add(rotation.front().place,
                           rotation.front().path,
                           "stages of kind steady turn with it, and the deck has none");
    }
    bool turns = false;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        if (has_steps(stages[i].analysis)) turns = is_steady(stages[i]);
        check_gravity(stages[i], turns, list_analyses(context.deck)[i], context);
        const std::string kind = kind_of(stages[i].analysis);
        if (!turns || (kind != "modes" && kind != "buckling")) continue;
        const AnalysisTable& table = list_analyses(context.deck)[i];
        context.add_fault(
            table, table.kind, "the stage before turns, and its motions need kind \"eigenvalues\"");
    }
}

// A sweep repeats what leads to its states.
void check_sweeps(const std::vector<StagePlan>& stages, const BuildContext& context) {
    std::string moving;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const std::string kind = kind_of(stages[i].analysis);
        if (has_steps(stages[i].analysis) && kind != "static" && kind != "steady") moving = kind;
        const auto* settings = std::get_if<EigenvalueSettings>(&stages[i].analysis);
        if (settings == nullptr || !settings->sweep || moving.empty()) continue;
        const AnalysisTable& table = list_analyses(context.deck)[i];
        context.add_fault(
            table,
            table.sweep,
            "only static and steady stages may come before, and one of kind " + moving + " does");
    }
}

// The model as a stage has it.
Model make_model_of(const StagePlan& stage, bool is_first, const Model& model) {
    Model own = model;
    if (!is_first) set_actions(stage.actions, own);
    return own;
}

}  // namespace

void choose_schemes(BuildContext& context) {
    const auto tables = list_analyses(context.deck);
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        const AnalysisTable& table = tables[i];
        auto* dynamic = std::get_if<DynamicSettings>(&context.stages[i].analysis);
        if (dynamic == nullptr || !dynamic->has_inertia || table.integrator.scheme) continue;
        const SchemeChoice choice =
            choose_scheme(make_model_of(context.stages[i], i == 0, context.model), table.accuracy);
        dynamic->scheme = choice.scheme;
        dynamic->chosen_for = choice.reason;
    }
}

std::vector<StagePlan> build_stages(const BuildContext& context) {
    std::vector<StagePlan> stages;
    for (const AnalysisTable& table : list_analyses(context.deck)) {
        if (table.spec == &stage_table()) check_stage_name(table, stages, context);
        stages.push_back({table.stage_name, build_analysis(table, context)});
        stages.back().end = std::make_shared<double>(end_of(stages.back().analysis));
        build_follow(table, stages, context);
    }
    check_rotation(stages, context);
    check_sweeps(stages, context);
    return stages;
}

}  // namespace gxrod
