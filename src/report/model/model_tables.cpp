#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <tuple>

#include "deck/schema/choices.hpp"
#include "model/settings/analysis_traits.hpp"
#include "model/settings/newton_choice.hpp"
#include "model/settings/scheme_card.hpp"
#include "model/ties/joint_card.hpp"
#include "model/ties/ties.hpp"
#include "numerics/eigenvalues.hpp"
#include "report/model/centres_json.hpp"
#include "report/model/model_json.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t most_rows = 50;  // of a table

template <class Part>
std::span<const Part> first_of(const std::vector<Part>& parts) {
    return std::span(parts).first(std::min(parts.size(), most_rows));
}

// Says that a table has not all rows; "" if it has.
template <class Part>
std::string tell_rest(const std::vector<Part>& parts) {
    return parts.size() > most_rows ? fmt::format("The first {} of {}.", most_rows, parts.size()) : "";
}

bool is_diagonal(const Mat6& matrix) { return matrix.isDiagonal(1e-12); }

Json describe_sections(const Model& model) {
    Json rows = Json::array();
    bool has_coupling = false;
    for (const Section& section : first_of(model.sections)) {
        const bool is_coupled = !is_diagonal(section.stiffness) || !is_diagonal(section.mass);
        has_coupling = has_coupling || is_coupled;
        Json row{section.name + (is_coupled ? " *" : "")};
        for (int i = 0; i < 6; ++i) row.push_back(section.stiffness(i, i));
        row.push_back(section.mass(0, 0));
        for (int i = 3; i < 6; ++i) row.push_back(section.mass(i, i));
        rows.push_back(row);
    }
    std::string note = tell_rest(model.sections);
    if (has_coupling) note += " * has couplings outside this diagonal: see the deck.";
    return {{"title", "Sections"},
            {"columns", {"", "EA", "GAy", "GAz", "GJ", "EIy", "EIz", "rhoA", "rhoJ", "rhoIy", "rhoIz"}},
            {"rows", rows},
            {"note", note}};
}

Json describe_rods(const Model& model) {
    Json rows = Json::array();
    for (const Rod& rod : first_of(model.rods)) {
        rows.push_back({rod.name,
                        model.sections[rod.section].name,
                        word_of(element_kind_choices, rod.kind),
                        rod.element_count(),
                        rod.order,
                        rod.length});
    }
    return {{"title", "Rods"},
            {"columns", {"", "section", "element", "elements", "order", "length"}},
            {"rows", rows},
            {"note", tell_rest(model.rods)}};
}

Json describe_body_table(const Model& model) {
    Json rows = Json::array();
    for (const Body& body : first_of(model.bodies)) {
        rows.push_back({body.name,
                        model.nodes[body.node].name,
                        body.mass,
                        in_parentheses(find_symmetric_eigen(body.inertia).values),
                        in_parentheses(body.centre_of_mass)});
    }
    return {{"title", "Rigid bodies"},
            {"columns", {"", "node", "mass", "principal inertia", "centre of mass, body axes"}},
            {"rows", rows},
            {"note", tell_rest(model.bodies)}};
}

std::string name_end(const Model& model, const Anchor& end) {
    return end.is_ground() ? std::string("ground") : model.nodes[end.node].name;
}

// The table of ties of a kind that are elements; `names` is its title in lower case.
template <class Element>
Json describe_tie_table(const Model& model, std::string names, const std::vector<Element>& ties) {
    Json columns{"", "from", "to"};
    for (const auto& [heading, number] : list_numbers(ties.front())) columns.push_back(heading);
    Json rows = Json::array();
    for (const Element& tie : first_of(ties)) {
        Json row{tie.name, name_end(model, tie.ends[0]), name_end(model, tie.ends[1])};
        for (const auto& [heading, number] : list_numbers(tie)) row.push_back(number);
        rows.push_back(row);
    }
    names[0] = static_cast<char>(std::toupper(names[0]));
    return {{"title", names}, {"columns", columns}, {"rows", rows}, {"note", tell_rest(ties)}};
}

Json describe_joint_table(const Model& model) {
    Json rows = Json::array();
    for (const Joint& joint : first_of(model.joints)) {
        const bool has_axis = joint.has_turn() || joint.has_slide();
        rows.push_back({joint.name,
                        std::string(card_of(joint.kind).word),
                        name_end(model, joint.a.anchor),
                        name_end(model, joint.b.anchor),
                        in_parentheses(find_place(model, joint.a.anchor)),
                        has_axis ? in_parentheses(joint.a.axes.col(0)) : std::string()});
    }
    return {{"title", "Joints"},
            {"columns", {"", "type", "from", "to", "at", "axis"}},
            {"rows", rows},
            {"note", tell_rest(model.joints)}};
}

Json describe_gear_table(const Model& model) {
    Json rows = Json::array();
    for (const Gear& gear : first_of(model.gears)) {
        const auto name = [&](const GearSide& side) {
            return fmt::format("{} of {}", side.is_turn ? "turn" : "slide", model.joints[side.joint].name);
        };
        rows.push_back({gear.name, gear.ratio, name(gear.sides[0]), name(gear.sides[1])});
    }
    return {{"title", "Gears"},
            {"columns", {"", "ratio", "first", "second"}},
            {"rows", rows},
            {"note", tell_rest(model.gears)}};
}

std::string describe_components(const std::array<bool, 6>& components) {
    std::string text;
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (components[i]) text += fmt::format("{}{}", text.empty() ? "" : " ", component_names[i]);
    }
    return text;
}

// The supports of a stage; those of the first are in the model.
const std::vector<Support>& supports_of(const Problem& problem, std::size_t stage) {
    return stage == 0 ? problem.model.supports : problem.stages[stage].actions.supports;
}

// What holds a node, and in which stages.
struct HeldNode {
    const Support* support;
    std::string stages;
};

std::vector<HeldNode> list_held_nodes(const Problem& problem) {
    std::vector<HeldNode> held;
    std::map<std::tuple<int, std::array<bool, 6>, std::array<bool, 6>>, std::size_t> numbers;
    for (std::size_t stage = 0; stage < problem.stages.size(); ++stage) {
        if (stage > 0 && !has_steps(problem.stages[stage].analysis)) continue;
        for (const Support& support : supports_of(problem, stage)) {
            const auto [number, is_new] =
                numbers.try_emplace({support.node, support.fixed, support.moved}, held.size());
            if (is_new) held.push_back({&support, ""});
            std::string& stages = held[number->second].stages;
            stages += (stages.empty() ? "" : ", ") + problem.stages[stage].name;
        }
    }
    return held;
}

Json describe_support_table(const Problem& problem) {
    const bool has_stages = problem.stages.size() > 1;
    const std::vector<HeldNode> held = list_held_nodes(problem);
    Json columns{"", "fixed", "moved"}, rows = Json::array();
    if (has_stages) columns.push_back("stages");
    for (const auto& [support, stages] : first_of(held)) {
        rows.push_back({problem.model.nodes[support->node].name,
                        describe_components(support->fixed),
                        describe_components(support->moved)});
        if (has_stages) rows.back().push_back(stages);
    }
    return {{"title", "Supports"}, {"columns", columns}, {"rows", rows}, {"note", tell_rest(held)}};
}

// Pairs of a name and a number or a text.
Json list_settings(const AnalysisSettings& analysis) {
    Json rows = Json::array();
    const auto add_newton = [&](const NewtonSettings& newton) {
        rows.push_back({"Newton's tolerance", choose_newton_tolerance(analysis)});
        rows.push_back({"most iterations", newton.max_iterations});
    };
    if (const auto* dynamic = std::get_if<DynamicSettings>(&analysis)) {
        rows.push_back({"integrator",
                        std::string(card_of(dynamic->scheme).word) +
                            (dynamic->chosen_for.empty() ? "" : " (auto: " + dynamic->chosen_for + ")")});
        rows.push_back({"end time", dynamic->end_time});
        if (dynamic->steps > 0) {
            const double step = dynamic->time_step();
            rows.push_back({dynamic->adaptive ? "first step" : "time step", step});
        }
        if (dynamic->adaptive) rows.push_back({"tolerance of a step", dynamic->adaptive->tolerance});
        add_newton(dynamic->newton);
    } else if (has_steps(analysis)) {
        if (is_path(analysis)) {
            rows.push_back({"kind", "path"});
        } else if (steps_of(analysis) > 0) {
            rows.push_back({"load steps", steps_of(analysis)});
        }
        add_newton(newton_of(analysis));
    } else {
        rows.push_back({"kind", kind_of(analysis)});
    }
    return rows;
}

// A row for each stage, with all settings that any of them has; those of `kind` say it once.
Json describe_stage_settings(const std::vector<StagePlan>& stages) {
    std::vector<std::string> names{"kind"};
    std::vector<std::map<std::string, Json>> settings;
    for (const StagePlan& stage : stages) {
        settings.emplace_back()["kind"] = kind_of(stage.analysis);
        for (const Json& setting : list_settings(stage.analysis)) {
            const std::string name = setting[0];
            if (std::ranges::find(names, name) == names.end()) names.push_back(name);
            settings.back()[name] = setting[1];
        }
    }
    Json columns{""}, rows = Json::array();
    for (const std::string& name : names) columns.push_back(name);
    for (std::size_t i = 0; i < std::min(stages.size(), most_rows); ++i) {
        Json row{stages[i].name};
        for (const std::string& name : names)
            row.push_back(settings[i].contains(name) ? settings[i][name] : "");
        rows.push_back(row);
    }
    return {{"title", "Stages"}, {"columns", columns}, {"rows", rows}, {"note", tell_rest(stages)}};
}

Json describe_analysis(const Problem& problem) {
    if (problem.stages.size() > 1) return describe_stage_settings(problem.stages);
    return {{"title", "Analysis"}, {"columns", Json::array()}, {"rows", list_settings(problem.analysis())}};
}

}  // namespace

Json describe_tables(const Problem& problem) {
    const Model& model = problem.model;
    Json tables = Json::array({describe_analysis(problem)});
    if (!model.sections.empty()) tables.push_back(describe_sections(model));
    if (Json centres = describe_centre_table(model); !centres["rows"].empty()) tables.push_back(centres);
    if (!model.rods.empty()) tables.push_back(describe_rods(model));
    if (!model.bodies.empty()) tables.push_back(describe_body_table(model));
    for_each_element_list(model, [&](TieKind kind, const auto& ties) {
        if (!ties.empty()) tables.push_back(describe_tie_table(model, card_of(kind).names, ties));
    });
    if (!model.joints.empty()) tables.push_back(describe_joint_table(model));
    if (!model.gears.empty()) tables.push_back(describe_gear_table(model));
    if (Json supports = describe_support_table(problem); !supports["rows"].empty())
        tables.push_back(supports);
    return tables;
}

}  // namespace gxrod
