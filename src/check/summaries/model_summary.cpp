#include "check/summaries/model_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "assembly/system.hpp"
#include "assembly/system_measures.hpp"
#include "check/mechanism/mechanism.hpp"
#include "check/summaries/condition_summary.hpp"
#include "check/summaries/joint_summary.hpp"
#include "check/summaries/rod_summary.hpp"
#include "check/summaries/tie_summary.hpp"
#include "check/surroundings/fluid_summary.hpp"
#include "model/settings/analysis_traits.hpp"
#include "model/settings/frame_interval.hpp"
#include "model/settings/scheme_card.hpp"
#include "numerics/eigenvalues.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {

namespace {

std::string describe_body(const Model& model, const Body& body) {
    const std::string text =
        fmt::format("body {}: mass {:.6g}, principal inertia {}, node {} at {}, centre of mass {} from it\n",
                    body.name,
                    body.mass,
                    in_parentheses(find_symmetric_eigen(body.inertia).values),
                    model.nodes[body.node].name,
                    in_parentheses(model.nodes[body.node].position),
                    in_parentheses(body.attitude * body.centre_of_mass));
    return text + describe_fluid(model, body);
}

ItemList list_rods(const Model& model) {
    ItemList list{"rods", {}};
    double shortest = std::numeric_limits<double>::infinity();
    double longest = 0.0;
    double length = 0.0;
    for (const Rod& rod : model.rods) {
        list.items.push_back(describe_rod(model, rod));
        shortest = std::min(shortest, rod.length);
        longest = std::max(longest, rod.length);
        length += rod.length;
    }
    list.sum = fmt::format("length {:.6g} to {:.6g}, together {:.6g}", shortest, longest, length);
    return list;
}

double sum_mass(const Model& model) {
    double mass = 0.0;
    for (const Rod& rod : model.rods) mass += model.sections[rod.section].mass(0, 0) * rod.length;
    for (const Body& body : model.bodies) mass += body.mass;
    return mass;
}

}  // namespace

std::vector<ItemList> list_model(const Model& model, const DeckWords& words) {
    ItemList sections{"sections", {}};
    for (const Section& section : model.sections) sections.items.push_back(describe_section(section));
    ItemList bodies{"bodies", {}};
    for (const Body& body : model.bodies) bodies.items.push_back(describe_body(model, body));
    std::vector<ItemList> lists{sections, list_rods(model), bodies};
    for (ItemList& list : list_element_summaries(model)) lists.push_back(std::move(list));
    lists.push_back(list_joints(model));
    lists.push_back(list_gears(model));
    lists.push_back(list_mechanisms(model));
    for (ItemList& list : list_conditions(model, words)) lists.push_back(std::move(list));
    return lists;
}

std::string describe_total(const Model& model) {
    const System system(model);
    return fmt::format("total: mass {:.6g}, {} nodes, {} elements, {} unknowns\n",
                       sum_mass(model),
                       model.nodes.size(),
                       SystemMeasures(system).count_elements(),
                       system.equations().count());
}

namespace {

std::string describe_dynamic(const DynamicSettings& settings) {
    if (!settings.has_inertia) {
        const std::string steps =
            settings.adaptive ? fmt::format("steps by their error, tolerance {:.6g}, first step {:.6g}",
                                            settings.adaptive->tolerance,
                                            settings.time_step())
                              : fmt::format("{} steps of {:.6g}", settings.steps, settings.time_step());
        return fmt::format("quasi-static analysis: {} to t = {:.6g}\n", steps, settings.end_time);
    }
    std::string parameters;
    const SchemeCard& card = card_of(settings.scheme);
    if (card.parameters == SchemeParameters::newmark) {
        parameters = fmt::format(" (beta {:.6g}, gamma {:.6g})", settings.beta, settings.gamma);
    } else if (card.parameters == SchemeParameters::spectral_radius) {
        parameters = fmt::format(" (spectral radius {:.6g})", settings.spectral_radius);
    }
    const std::string chosen =
        settings.chosen_for.empty() ? "" : fmt::format(" (auto: {})", settings.chosen_for);
    if (settings.adaptive) {
        return fmt::format(
            "dynamic analysis: {}{}, steps by their error, tolerance {:.6g}, first step {:.6g}, to t = "
            "{:.6g}\n",
            card.word,
            chosen,
            settings.adaptive->tolerance,
            settings.time_step(),
            settings.end_time);
    }
    return fmt::format("dynamic analysis: {}{}{}, {} steps of {:.6g} to t = {:.6g}\n",
                       card.word,
                       parameters,
                       chosen,
                       settings.steps,
                       settings.time_step(),
                       settings.end_time);
}

}  // namespace

namespace {

// "frames every 0.01", "frames at 3 times", or "" where they follow the steps.
std::string describe_frame_times(const OutputSettings& output) {
    if (output.interval) return fmt::format("frames every {:.6g}", *output.interval);
    if (output.times.empty()) return "";
    return fmt::format("frames at {} time{}", output.times.size(), output.times.size() == 1 ? "" : "s");
}

std::string describe_frames(const AnalysisSettings& settings, long every) {
    if (every == 0) {
        return fmt::format(
            "{} frames at most, one in each {}th part of the time", default_frames + 1, default_frames);
    }
    const auto* dynamic = std::get_if<DynamicSettings>(&settings);
    const bool is_open = is_path(settings) || (dynamic != nullptr && dynamic->adaptive);
    const std::string interval = every == 1 ? "one every step" : fmt::format("one every {} steps", every);
    if (is_open) return "frames, " + interval;
    const long steps = steps_of(settings);
    return fmt::format("{} frames, {}", 1 + steps / every + (steps % every == 0 ? 0 : 1), interval);
}

// "path: until t = 2 or arc length 5 or 300 steps, with its branches"
std::string describe_path(const PathSettings& path) {
    std::vector<std::string> ends;
    for (const auto& bound : {path.least_load, path.greatest_load}) {
        if (bound) ends.push_back(fmt::format("t = {:.6g}", *bound));
    }
    if (path.arc) ends.push_back(fmt::format("arc length {:.6g}", *path.arc));
    if (path.steps) ends.push_back(fmt::format("{} step{}", *path.steps, *path.steps == 1 ? "" : "s"));
    if (path.points)
        ends.push_back(fmt::format("{} critical point{}", *path.points, *path.points == 1 ? "" : "s"));
    std::string branches;
    if (path.branches == 1) branches = ", and the branches that leave it";
    if (path.branches > 1) branches = fmt::format(", and {} generations of branches", path.branches);
    return fmt::format("path of equilibria until {}{}\n", fmt::join(ends, " or "), branches);
}

}  // namespace

std::string describe_analysis(const AnalysisSettings& settings) {
    if (const auto* path = std::get_if<PathSettings>(&settings)) return describe_path(*path);
    if (const auto* dynamic = std::get_if<DynamicSettings>(&settings)) return describe_dynamic(*dynamic);
    if (const auto* modes = std::get_if<ModesSettings>(&settings)) {
        if (modes->below) return fmt::format("modes: all below {:.6g} cycles per time\n", *modes->below);
        return fmt::format("modes: the {} of lowest frequency\n", modes->count);
    }
    if (const auto* buckling = std::get_if<BucklingSettings>(&settings))
        return fmt::format("linear buckling: the {} smallest factors\n", buckling->count);
    const auto* eigenvalues = std::get_if<EigenvalueSettings>(&settings);
    if (eigenvalues != nullptr && eigenvalues->sweep) {
        return fmt::format("eigenvalues: the {} nearest to 0, at {} values of {}\n",
                           eigenvalues->count,
                           eigenvalues->sweep->values.size(),
                           eigenvalues->sweep->key);
    }
    if (eigenvalues != nullptr) return fmt::format("eigenvalues: the {} nearest to 0\n", eigenvalues->count);
    const auto* response = std::get_if<ResponseSettings>(&settings);
    if (response != nullptr && response->gravity) return "response to gravity, once a revolution\n";
    if (response != nullptr)
        return fmt::format("response to forces at {} frequencies\n", response->omegas.size());
    if (std::holds_alternative<SteadySettings>(settings)) {
        return fmt::format("steady rotation: {} steps of the load factor t from 0 to 1\n",
                           steps_of(settings));
    }
    return fmt::format("static analysis: {} steps of the load factor t from 0 to 1\n", steps_of(settings));
}

std::string describe_signals(const std::vector<SignalPlan>& signals, const OutputSettings& output) {
    std::string text;
    for (const SignalPlan& signal : signals) {
        std::string source = "a function of t";
        if (signal.measure)
            source = output.histories[signal.measure->history].name + " " + signal.measure->quantity;
        if (signal.filter > 0.0) source += fmt::format(", filtered by {:.6g}", signal.filter);
        if (signal.is_rate) source.insert(0, "rate of ");
        if (signal.pid) {
            source = fmt::format("controller (proportional {:.6g}, integral {:.6g}, derivative {:.6g}) of {}",
                                 signal.pid->proportional,
                                 signal.pid->integral,
                                 signal.pid->derivative,
                                 source);
        }
        text += fmt::format("signal {}: {}", signal.name, source);
        if (signal.lower) text += fmt::format(", at least {:.6g}", *signal.lower);
        if (signal.upper) text += fmt::format(", at most {:.6g}", *signal.upper);
        text += signal.is_continuous ? "; acts in the step that it measures\n" : "; acts one step later\n";
    }
    return text;
}

std::string describe_output(const std::vector<StagePlan>& stages, const OutputSettings& output) {
    std::string text = "output: ";
    const char* separator = "";
    for (const StagePlan& stage : stages) {
        if (!has_steps(stage.analysis)) continue;
        const std::string by_time = is_timed(stage.analysis) ? describe_frame_times(output) : "";
        const std::string frames =
            by_time.empty() ? describe_frames(stage.analysis, stage.frame_interval) : by_time;
        text += separator + (stages.size() > 1 ? "of stage " + stage.name + " " : "") + frames;
        separator = ", ";
    }
    if (*separator == '\0') text += "one frame";
    for (const HistoryRequest& history : output.histories) {
        text += fmt::format(", history {} at {}", history.name, history.at);
    }
    if (output.history_interval)
        text += fmt::format(", histories every {:.6g} too", *output.history_interval);
    if (!output.stresses.empty()) text += ", stresses along rods, exposure by " + output.stresses;
    return text + "\n";
}

}  // namespace gxrod
