#include "deck/analyses/build_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "deck/analyses/build_path.hpp"
#include "deck/analyses/build_response.hpp"
#include "deck/output/listed_values.hpp"
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

long find_steps(const CheckedTable& table, double end_time, const BuildContext& context) {
    if (table.gives("accuracy")) return first_part;
    if (table.gives("steps")) return table.get<long>("steps");
    const double time_step = table.get<double>("time_step");
    const double ratio = end_time / time_step;
    const double nearest = std::max(1.0, std::round(ratio));
    const bool is_whole = std::abs(ratio - nearest) <= divides * nearest;
    const double steps = is_whole ? nearest : std::ceil(ratio);
    if (steps > static_cast<double>(largest_step_count)) {
        context.add_fault(
            table,
            "time_step",
            fmt::format("{:.3g} steps are too many; expected at most {}", steps, largest_step_count));
        return 1;
    }
    if (!is_whole && !table.gives("adaptive")) {
        context.notes.push_back(fmt::format("{}: {} does not divide {}; {:.0f} steps of {} are taken",
                                            table.path_of("time_step"),
                                            time_step,
                                            end_time,
                                            steps,
                                            end_time / steps));
    }
    return static_cast<long>(steps);
}

std::optional<AdaptiveSettings> build_adaptive(const CheckedTable& analysis, const BuildContext& context) {
    if (analysis.gives("accuracy"))
        return AdaptiveSettings{.tolerance = part_of_a_step * analysis.get<double>("accuracy")};
    if (!analysis.gives("adaptive")) return std::nullopt;
    const CheckedTable& table = analysis.tables("adaptive").front();
    AdaptiveSettings adaptive;
    adaptive.tolerance = table.get<double>("tolerance");
    adaptive.min_step = table.get<double>("min_step");
    if (table.gives("max_step")) adaptive.max_step = table.get<double>("max_step");
    if (adaptive.max_step < adaptive.min_step) {
        context.add_fault(
            table,
            "max_step",
            fmt::format(
                "expected a number not below min_step, {}; found {}", adaptive.min_step, adaptive.max_step));
    }
    return adaptive;
}

// Says so where the first step is not what the deck asks for.
void note_first_step(const DynamicSettings& settings,
                     const CheckedTable& table,
                     const BuildContext& context) {
    const AdaptiveSettings& adaptive = *settings.adaptive;
    const double first = settings.time_step();
    if (first >= adaptive.min_step && first <= adaptive.max_step) return;
    const bool is_short = first < adaptive.min_step;
    context.notes.push_back(fmt::format("{}: the first step, {}, is {} adaptive.{}; it will be {}",
                                        table.path_of(table.gives("steps") ? "steps" : "time_step"),
                                        first,
                                        is_short ? "below" : "above",
                                        is_short ? "min_step" : "max_step",
                                        is_short ? adaptive.min_step : adaptive.max_step));
}

// Faults of the paper's tangent; `user` is what else the deck has in the place of its integrator, or "".
void check_paper_tangent(const CheckedTable& newton, const std::string& user, const BuildContext& context) {
    const std::string paper = word_of(tangent_choices, TangentKind::paper);
    if (!user.empty()) {
        context.add_fault(newton,
                          "tangent",
                          fmt::format("\"{}\" belongs to integrator \"{}\", not to {}",
                                      paper,
                                      card_of(Scheme::newmark_simplified).word,
                                      user));
    }
    if (!context.deck.tables("rod").empty()) {
        context.add_fault(
            newton, "tangent", fmt::format("\"{}\" is for decks of bodies alone; this one has rods", paper));
    }
}

// Stages that are found together share one matrix of their own.
void check_coupled_tangent(const CheckedTable& newton,
                           const DynamicSettings& settings,
                           bool is_open,
                           const BuildContext& context) {
    const TangentKind tangent = settings.newton.tangent;
    const SchemeCard& card = card_of(settings.scheme);
    if (!card.couples_stages || tangent == TangentKind::automatic || tangent == TangentKind::consistent)
        return;
    context.add_fault(
        newton,
        "tangent",
        fmt::format("\"{}\" {}; expected \"{}\"",
                    is_open ? open_scheme_word : card.word,
                    is_open ? "chooses the tangent, too"
                            : "finds the stages of a step together and has a tangent of its own",
                    word_of(tangent_choices, TangentKind::automatic)));
}

bool leaves_scheme_open(const CheckedTable& table) {
    return table.get<std::string>("integrator") == open_scheme_word;
}

// Sets what the deck gives.
void read_newton(const CheckedTable& analysis,
                 const std::string& user,
                 const BuildContext& context,
                 NewtonSettings& newton) {
    if (!analysis.gives("newton")) return;
    const CheckedTable& table = analysis.tables("newton").front();
    if (table.gives("tolerance")) newton.tolerance = table.get<double>("tolerance");
    newton.max_iterations = static_cast<int>(table.get<long>("max_iterations"));
    if (!table.gives("tangent")) return;
    newton.tangent = value_of(tangent_choices, table.get<std::string>("tangent"));
    if (newton.tangent == TangentKind::paper) check_paper_tangent(table, user, context);
}

LinearSolverKind find_linear_solver(const CheckedTable& table) {
    return value_of(linear_solver_choices, table.get<std::string>("linear_solver"));
}

DynamicSettings build_quasi_static(const CheckedTable& table, const BuildContext& context) {
    DynamicSettings settings;
    settings.has_inertia = false;
    settings.scheme = quasi_static_scheme;
    settings.end_time = table.get<double>("end_time");
    settings.steps = find_steps(table, settings.end_time, context);
    settings.adaptive = build_adaptive(table, context);
    if (settings.adaptive) note_first_step(settings, table, context);
    read_newton(table, "quasi-static analyses", context, settings.newton);
    settings.linear_solver = find_linear_solver(table);
    return settings;
}

Scheme find_scheme(const CheckedTable& table, const BuildContext& context) {
    if (leaves_scheme_open(table)) return accurate_scheme;
    const Scheme scheme = value_of(scheme_choices, table.get<std::string>("integrator"));
    if (!table.gives("accuracy") || table.gives("integrator")) return scheme;
    for (const char* key : {"beta", "gamma"}) {
        if (!table.gives(key)) continue;
        context.add_fault(
            table,
            key,
            fmt::format("accuracy without an integrator takes \"{}\", which does not use this key; give the "
                        "integrator",
                        card_of(accurate_scheme).word));
    }
    return accurate_scheme;
}

DynamicSettings build_dynamic(const CheckedTable& table, const BuildContext& context) {
    DynamicSettings settings;
    settings.end_time = table.get<double>("end_time");
    settings.steps = find_steps(table, settings.end_time, context);
    settings.scheme = find_scheme(table, context);
    settings.beta = table.get<double>("beta");
    settings.gamma = table.get<double>("gamma");
    settings.spectral_radius = table.get<double>("spectral_radius");
    settings.projects_start = table.get<std::string>("start") == "project";
    settings.adaptive = build_adaptive(table, context);
    if (settings.adaptive) note_first_step(settings, table, context);
    const bool is_papers_scheme = card_of(settings.scheme).has_paper_tangent;
    const std::string user = "\"" + table.get<std::string>("integrator") + "\"";
    read_newton(table, is_papers_scheme ? "" : user, context, settings.newton);
    if (table.gives("newton") && table.tables("newton").front().gives("tangent"))
        check_coupled_tangent(table.tables("newton").front(), settings, leaves_scheme_open(table), context);
    settings.linear_solver = find_linear_solver(table);
    return settings;
}

StaticSettings build_static(const CheckedTable& table, const BuildContext& context) {
    StaticSettings settings;
    if (table.gives("steps")) settings.steps = table.get<long>("steps");
    read_newton(table, "static analyses", context, settings.newton);
    settings.linear_solver = find_linear_solver(table);
    return settings;
}

ModesSettings build_modes(const CheckedTable& table) {
    ModesSettings settings;
    if (table.gives("count")) settings.count = static_cast<int>(table.get<long>("count"));
    if (table.gives("below")) settings.below = table.get<double>("below");
    settings.linearization = value_of(linearization_choices, table.get<std::string>("linearization"));
    return settings;
}

BucklingSettings build_buckling(const CheckedTable& table) {
    BucklingSettings settings;
    if (table.gives("count")) settings.count = static_cast<int>(table.get<long>("count"));
    settings.linearization = value_of(linearization_choices, table.get<std::string>("linearization"));
    return settings;
}

SteadySettings build_steady(const CheckedTable& table, const BuildContext& context) {
    if (context.deck.tables("rotation").empty())
        context.add_fault(
            table, "kind", "a steady stage turns with [rotation], which the deck does not have");
    return {build_static(table, context)};
}

EigenvalueSettings build_eigenvalues(const CheckedTable& table, const BuildContext& context) {
    EigenvalueSettings settings;
    if (table.gives("count")) settings.count = static_cast<int>(table.get<long>("count"));
    if (!table.gives("sweep")) return settings;
    const CheckedTable& sweep = table.tables("sweep").front();
    settings.sweep = {sweep.get<std::string>("key"),
                      list_values(sweep, context),
                      sweep.get<std::string>("onset") == "locate"};
    return settings;
}

AnalysisSettings build_analysis(const CheckedTable& table, const BuildContext& context) {
    const std::string& kind = table.get<std::string>("kind");
    if (kind == "static") return build_static(table, context);
    if (kind == "quasi-static") return build_quasi_static(table, context);
    if (kind == "steady") return build_steady(table, context);
    if (kind == "eigenvalues") return build_eigenvalues(table, context);
    if (kind == "response") return build_response(table, context);
    if (kind == "path") {
        PathSettings path = build_path(table, context);
        read_newton(table, "paths", context, path.newton);
        path.linear_solver = find_linear_solver(table);
        return path;
    }
    if (kind == "modes") return build_modes(table);
    if (kind == "buckling") return build_buckling(table);
    return build_dynamic(table, context);
}

// Groups, files and messages have the names of stages.
void check_stage_name(const CheckedTable& table,
                      const std::vector<StagePlan>& earlier,
                      const BuildContext& context) {
    const std::string& name = table.get<std::string>("name");
    const bool is_plain = std::all_of(name.begin(), name.end(), [](char letter) {
        return letter == '_' || letter == '-' || std::isalnum(static_cast<unsigned char>(letter)) != 0;
    });
    if (name.empty() || !is_plain) {
        return context.add_fault(
            table, "name", "expected letters, digits, _ and -, found \"" + printable(name) + "\"");
    }
    const bool is_taken = std::any_of(
        earlier.begin(), earlier.end(), [&](const StagePlan& stage) { return stage.name == name; });
    if (is_taken) context.add_fault(table, "name", fmt::format("\"{}\" names an earlier stage, too", name));
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
        const std::string kind = kind_of(stages[i].analysis);
        if (!turns || (kind != "modes" && kind != "buckling")) continue;
        context.add_fault(context.deck.tables("stage")[i],
                          "kind",
                          "the stage before turns, and its motions need kind \"eigenvalues\"");
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
        context.add_fault(
            context.deck.tables("stage")[i],
            "sweep",
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
    const std::vector<CheckedTable>& tables = context.deck.tables("stage");
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        const CheckedTable& table = tables.empty() ? context.deck.tables("analysis").front() : tables[i];
        auto* dynamic = std::get_if<DynamicSettings>(&context.stages[i].analysis);
        if (dynamic == nullptr || !dynamic->has_inertia || !leaves_scheme_open(table)) continue;
        std::optional<double> accuracy;
        if (table.gives("accuracy")) accuracy = table.get<double>("accuracy");
        const SchemeChoice choice =
            choose_scheme(make_model_of(context.stages[i], i == 0, context.model), accuracy);
        dynamic->scheme = choice.scheme;
        dynamic->chosen_for = choice.reason;
    }
}

std::vector<StagePlan> build_stages(const BuildContext& context) {
    std::vector<StagePlan> stages;
    const auto add = [&](std::string name, const CheckedTable& table) {
        stages.push_back({std::move(name), build_analysis(table, context)});
        stages.back().end = std::make_shared<double>(end_of(stages.back().analysis));
        build_follow(table, stages, context);
    };
    for (const CheckedTable& table : context.deck.tables("stage")) {
        check_stage_name(table, stages, context);
        add(table.get<std::string>("name"), table);
    }
    if (stages.empty()) add("", context.deck.tables("analysis").front());
    check_rotation(stages, context);
    check_sweeps(stages, context);
    return stages;
}

}  // namespace gxrod
