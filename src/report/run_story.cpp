#include "report/run_story.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "model/contact.hpp"
#include "model/energy_round_off.hpp"
#include "model/ties/ties.hpp"
#include "report/blocks/contact_blocks.hpp"
#include "report/blocks/step_blocks.hpp"
#include "report/model/centres_json.hpp"
#include "report/model/line_end_json.hpp"
#include "results/energy_warning.hpp"
#include "results/tables/deck_reading.hpp"

namespace gxrod {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t most_supports = 500;
constexpr std::size_t most_arrows = 300;
constexpr std::size_t most_joints = 500;
constexpr std::size_t most_springs = 500;  // and as many of each other kind of tie that is an element

std::string text_of(const Hdf5Reader& file, const std::string& name) {
    return file.has_attribute("/", name) ? file.text_attribute("/", name) : "";
}

void rebuild(const Hdf5Reader& file, RunStory& story) {
    const DeckRecord record = read_deck_record(file);
    story.deck = record.text;
    try {
        auto problem = std::make_unique<Problem>(rebuild_problem(record));
        if (refine_cells(problem->model, story.topology)) {
            story.problem = std::move(problem);
        } else {
            story.why_no_problem = "its deck makes another mesh with this version of gxrod";
        }
    } catch (const Hdf5Error&) {
        throw;
    } catch (const std::exception& error) {
        story.why_no_problem = error.what();
    }
}

// How many of these parts are drawn; a sentence on the others.
std::size_t count_drawn(std::size_t all, std::size_t most, const char* names, RunStory& story) {
    if (all <= most) return all;
    story.left_out.push_back(fmt::format("Of {} {}, the first {} are drawn.", all, names, most));
    return most;
}

void mark_ends(const std::vector<Tie>& ties, std::size_t most, const char* names, RunStory& story) {
    for (std::size_t i = 0, drawn = count_drawn(ties.size(), most, names, story); i < drawn; ++i) {
        for (const Anchor& end : ties[i].ends) {
            if (!end.is_ground()) story.marked_nodes.push_back(end.node);
        }
    }
}

void add_drawing(RunStory& story) {
    const Model& model = story.problem->model;
    story.arrows = list_load_arrows(model);
    story.arrows.resize(count_drawn(story.arrows.size(), most_arrows, "arrows of loads", story));
    for (const LoadArrow& arrow : story.arrows) story.marked_nodes.push_back(arrow.node);
    const std::size_t supports = count_drawn(model.supports.size(), most_supports, "supports", story);
    for (std::size_t i = 0; i < supports; ++i) story.marked_nodes.push_back(model.supports[i].node);
    std::vector<Tie> joints = list_ties(model, TieKind::joint);
    std::ranges::copy(list_ties(model, TieKind::sleeve), std::back_inserter(joints));
    mark_ends(joints, most_joints, "joints", story);
    for_each_element_list(model, [&](TieKind kind, const auto&) {
        mark_ends(list_ties(model, kind), most_springs, card_of(kind).names, story);
    });
}

// Bodies whose places alone are known.
Json bare_bodies(const RunStory& story, const NodeNumbers& number) {
    Json bodies = Json::array();
    for (const int node : story.topology.body_nodes) {
        if (bodies.size() == most_bodies) break;
        bodies.push_back({{"name", ""},
                          {"node", number(node)},
                          {"centre", {0.0, 0.0, 0.0}},
                          {"attitude", {1.0, 0.0, 0.0, 0.0}},
                          {"axes", {1.0, 0.0, 0.0, 0.0}},
                          {"half_sizes", {0.0, 0.0, 0.0}}});
    }
    return bodies;
}

Json describe_arrows(const RunStory& story, const NodeNumbers& number) {
    Json arrows = Json::array();
    for (const LoadArrow& arrow : story.arrows) {
        arrows.push_back(
            {{"key", arrow.key}, {"node", number(arrow.node)}, {"along_rod", arrow.is_along_rod}});
    }
    return arrows;
}

// What frames and steps count.
const char* name_time(const Hdf5Reader& file, bool is_static) {
    if (!is_static) return "time";
    if (!file.has("/histories/load_factor")) return "load factor";
    return file.has("/histories/stage") ? "time" : "arc length";
}

}  // namespace

RunStory read_run_story(const Hdf5Reader& file) {
    RunStory story;
    story.is_static = text_of(file, "analysis") == "static";
    story.topology = read_topology(file);
    rebuild(file, story);
    const std::vector<int>& bodies = story.topology.body_nodes;
    const std::size_t drawn = count_drawn(bodies.size(), most_bodies, "bodies", story);
    for (std::size_t i = 0; i < drawn; ++i) story.marked_nodes.push_back(bodies[i]);
    if (story.problem) add_drawing(story);
    if (file.has_attribute("/", "reason_nodes"))
        story.fail_nodes = file.integers_attribute("/", "reason_nodes");
    std::erase_if(story.fail_nodes,
                  [&](std::int64_t node) { return node < 0 || node >= story.topology.nodes; });
    for (const std::int64_t node : story.fail_nodes) story.marked_nodes.push_back(static_cast<int>(node));
    return story;
}

std::vector<std::string> list_warnings(const Hdf5Reader& file, const RunStory& story, std::size_t steps) {
    std::vector<std::string> warnings;
    const std::string status = text_of(file, "status");
    const std::string reason = text_of(file, "reason");
    if (status == "failed") warnings.push_back("The run failed: " + reason);
    if (status == "interrupted")
        warnings.push_back("The run was interrupted; what follows is what it got to.");
    if (status == "running") {
        warnings.push_back(
            "The run had not ended when this page was made, or was killed; this is what it got to.");
    }
    const double round_off = story.problem ? compute_energy_round_off(story.problem->model) : 0.0;
    std::string imbalance = describe_imbalance(survey_energy(file, story.is_static, steps), round_off);
    std::istringstream lines(text_of(file, "warnings"));
    for (std::string line; std::getline(lines, line);) {
        if (line == imbalance) imbalance.clear();
        line.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(line.front())));
        warnings.push_back(line.ends_with('.') ? line : line + ".");
    }
    // Runs that were killed, or are of an earlier program, list nothing of energies.
    if (!imbalance.empty()) warnings.push_back("Mind that " + imbalance + ".");
    return warnings;
}

Json describe_run(const Hdf5Reader& file, const RunStory& story, const NodeNumbers& number) {
    Json json;
    for (const char* name :
         {"gxrod_version", "title", "deck_name", "deck_sha256", "units", "analysis", "status", "reason"}) {
        json[name] = text_of(file, name);
    }
    json["deck"] = story.deck;
    json["is_static"] = story.is_static;
    json["time_name"] = name_time(file, story.is_static);
    json["nodes"] = story.topology.nodes;
    json["elements"] = story.topology.rod_cells.size();
    json["fail_nodes"] = Json::array();
    for (const std::int64_t node : story.fail_nodes)
        json["fail_nodes"].push_back(number(static_cast<int>(node)));
    json["why_no_model"] = story.why_no_problem;
    json["arrows"] = describe_arrows(story, number);
    if (!story.problem) {
        json["bodies"] = bare_bodies(story, number);
        for (const char* parts : {"supports", "joints"}) json[parts] = Json::array();
        describe_element_ties({}, number, most_springs, json);
        for (const char* parts : {"tables", "rods", "centres", "obstacles"}) json[parts] = Json::array();
        return json;
    }
    const Model& model = story.problem->model;
    json["unknowns"] = count_unknowns(model);
    json["surroundings"] = describe_surroundings(*story.problem);
    json["obstacles"] = describe_obstacles(model);
    json["has_contact"] = !model.contact.is_empty();
    json["has_contact_friction"] = rubs(model.contact);
    json["bodies"] = describe_bodies(model, number, most_bodies);
    json["supports"] = describe_supports(model, number, most_supports);
    json["joints"] = describe_joints(model, number, most_joints);
    describe_element_ties(model, number, most_springs, json);
    json["tables"] = describe_tables(*story.problem);
    if (Json ends = describe_line_ends(file); !ends.is_null()) json["tables"].push_back(std::move(ends));
    json["centres"] = describe_centres_along(model);
    json["rods"] = Json::array();
    for (const Rod& rod : model.rods) json["rods"].push_back(rod.name);
    return json;
}

}  // namespace gxrod
