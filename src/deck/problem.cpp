#include "deck/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "deck/analyses/analysis_table.hpp"
#include "deck/analyses/build_analysis.hpp"
#include "deck/analyses/build_initial.hpp"
#include "deck/analyses/build_path.hpp"
#include "deck/analyses/build_response.hpp"
#include "deck/bodies/body_table.hpp"
#include "deck/bodies/build_outlines.hpp"
#include "deck/checks/check_conserving.hpp"
#include "deck/checks/check_functions.hpp"
#include "deck/checks/check_memory.hpp"
#include "deck/checks/check_points.hpp"
#include "deck/checks/check_velocities.hpp"
#include "deck/contact/contact_table.hpp"
#include "deck/contact/read_obstacle_meshes.hpp"
#include "deck/drives/build_drives.hpp"
#include "deck/drives/build_inputs.hpp"
#include "deck/drives/build_signals.hpp"
#include "deck/expressions/function_files.hpp"
#include "deck/joints/joints.hpp"
#include "deck/loads/acting.hpp"
#include "deck/loads/combinations.hpp"
#include "deck/loads/loads.hpp"
#include "deck/output/history_table.hpp"
#include "deck/output/output_table.hpp"
#include "deck/places/plane.hpp"
#include "deck/reading/copies.hpp"
#include "deck/reading/validation.hpp"
#include "deck/rods/build_connections.hpp"
#include "deck/rods/build_rods.hpp"
#include "deck/rods/imperfections.hpp"
#include "deck/rods/read_rod_nets.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/top_level.hpp"
#include "deck/sections/build_sections.hpp"
#include "deck/sections/large_shapes.hpp"
#include "deck/sections/section_files.hpp"
#include "deck/sections/shapes/section_materials.hpp"
#include "deck/sections/shapes/wall_shape.hpp"
#include "deck/supports/build_supports.hpp"
#include "deck/surroundings/build_surroundings.hpp"
#include "deck/surroundings/contents_flow.hpp"
#include "deck/surroundings/vessel_table.hpp"
#include "deck/text/further_faults.hpp"
#include "deck/text/overrides.hpp"
#include "deck/text/program_laws.hpp"
#include "deck/text/resumption.hpp"
#include "deck/text/text_file.hpp"
#include "deck/ties/ties.hpp"
#include "machine/file_error.hpp"
#include "machine/machine_memory.hpp"
#include "mesh/sections/held_meshes.hpp"
#include "model/settings/scheme_card.hpp"

namespace gxrod {
namespace {

// Points, springs, bushings, joints, gears and tendons go by their names.
void check_names(const CheckedTable& deck, FaultList& faults) {
    std::vector<const CheckedTable*> tables;
    std::vector<std::string> kinds = list_tie_words();
    kinds.insert(kinds.end(), {"rod", "body", "tendon", "chamber", "obstacle"});
    for (const std::string& kind : kinds) {
        for (const CheckedTable& table : deck.tables(kind)) tables.push_back(&table);
    }
    std::ranges::sort(tables, {}, &CheckedTable::place);
    std::map<std::string, const CheckedTable*> earlier;
    for (const CheckedTable* table : tables) {
        const auto [first, is_new] = earlier.emplace(table->name, table);
        if (is_new) continue;
        faults.add(
            table->place, table->path, first->second->path + " has this name too, and points go by it");
    }
}

// What acts in each stage that takes steps; the model has that of the first stage.
void build_actions(const SurroundingsFiles& files, const LoadFiles& loads, BuildContext& context) {
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        if (i > 0 && !has_steps(context.stages[i].analysis)) continue;
        context.stage = i;
        StageActions first;
        if (i > 0) first = take_actions(context.model);
        const auto* timed = std::get_if<DynamicSettings>(&context.stages[i].analysis);
        context.model.has_inertia = timed == nullptr || timed->has_inertia;
        context.model.has_time = timed != nullptr;
        build_supports(context);
        check_velocities(context);
        build_joint_actions(context);
        build_sleeve_actions(context);
        build_loads(loads, context);
        build_rotation(context);
        build_tendons(context);
        build_actuations(context);
        build_contents_flow(context);
        build_magnets(context);
        build_surroundings(files, context);
        move_with_vessels(files, context);
        build_contact(context);
        check_functions(context);
        check_conserving(context);
        if (i == 0) continue;
        context.stages[i].actions = take_actions(context.model);
        set_actions(std::move(first), context.model);
    }
    context.stage = 0;
}

// "radau-5"; of stages "move: radau-5, rest: generalized-alpha".
std::string list_integrators(const std::vector<StagePlan>& stages) {
    std::string text;
    for (const StagePlan& stage : stages) {
        const auto* dynamic = std::get_if<DynamicSettings>(&stage.analysis);
        if (dynamic == nullptr || !dynamic->has_inertia) continue;
        if (!text.empty()) text += ", ";
        if (!stage.name.empty()) text += stage.name + ": ";
        text += card_of(dynamic->scheme).word;
    }
    return text;
}

void note_stages(const std::vector<StagePlan>& stages, DeckRecord& record) {
    record.is_static = true;
    record.integrators = list_integrators(stages);
    for (const StagePlan& stage : stages) {
        if (!stage.name.empty()) record.stages.push_back(stage.name);
        record.has_statics = record.has_statics || !is_timed(stage.analysis);
        record.finds_shapes = record.finds_shapes || !has_steps(stage.analysis);
        record.has_paths = record.has_paths || is_path(stage.analysis);
        record.follows_limits = follows_limits(stages);
        record.is_static = record.is_static && !is_timed(stage.analysis);
    }
}

// The files that a deck names: its meshes, and its tables of numbers.
struct DeckFiles {
    const MeshFiles& meshes;
    const TableFiles& tables;
};

Problem build_problem(const CheckedTable& deck, const DeckFiles& files, FaultList& faults) {
    Problem problem;
    const RodNets nets = read_rod_nets(deck, files.meshes, faults, problem.record.meshes);
    const SectionFiles section_files = read_section_files(deck, files.tables, faults, problem.record.meshes);
    const SurroundingsFiles surroundings =
        read_surroundings_files(deck, files.tables, faults, problem.record.meshes);
    const LoadFiles loads = read_load_files(deck, files.tables, faults, problem.record.meshes);
    std::map<std::string, std::shared_ptr<const TriangleMesh>> obstacle_meshes =
        read_obstacle_meshes(deck, files.meshes, faults, problem.record.meshes, problem.notes);
    auto cam_points = read_cam_files(deck, files.tables, faults, problem.record.meshes);
    auto section_meshes = read_section_meshes(deck, files.meshes, faults, problem.record.meshes);
    check_memory(deck, nets, count_usable_bytes(), faults);
    faults.throw_if_any();
    const PointNames names(deck, points_of(nets));
    BuildContext context{deck, names, faults, problem.notes, problem.model};
    context.obstacle_meshes = std::move(obstacle_meshes);
    context.section_meshes = std::move(section_meshes);
    context.cam_points = std::move(cam_points);
    check_names(deck, faults);
    context.stages = build_stages(context);
    check_stage_names(context);
    check_combinations(context);
    build_inputs(context);
    plan_signals(context);
    const std::vector<RodPoint> points = check_points(context);
    check_materials(context);
    build_sections(context);
    build_rods(points, nets, section_files, context);
    build_connections(nets, context);
    build_bodies(context);
    for (const ElementTieTable& tie : element_tie_tables) tie.build(context);
    build_yielding_supports(context);
    build_joints(context);
    build_gears(context);
    build_sleeves(context);
    problem.outlines = build_outlines(files.meshes, problem.record.meshes, context);
    build_plane(context);
    build_initial(context);
    build_actions(surroundings, loads, context);
    build_path_targets(context);
    build_excitation(context);
    choose_schemes(context);
    check_contact(context);
    set_frame_intervals(context);
    problem.output = build_output(context);
    const std::vector<HistoryRequest> asked = build_histories(context);
    problem.output.histories.insert(problem.output.histories.begin(), asked.begin(), asked.end());
    problem.signals = build_signals(problem.output.histories, context);
    name_response_points(problem.output.histories, context);
    problem.stages = std::move(context.stages);
    note_stages(problem.stages, problem.record);
    problem.record.title = top_level_of(deck).title;
    problem.record.units = top_level_of(deck).units;
    return problem;
}

std::string read_deck_file(const std::filesystem::path& path) {
    std::string text = read_text_file(path, "a deck", most_deck_bytes);
    if (text.starts_with("gxrod\r\n\x1a") || text.starts_with("\x89HDF")) {
        throw FileError(path, "is a results file, not a deck", "gxrod resume, report and export read those");
    }
    return text;
}

// A text, where its meshes and tables are, and how faults name it.
struct DeckSource {
    const std::string& text;
    const std::string& file;
    const MeshFiles& meshes;
    TableFiles tables;
    bool is_varied = false;  // for one value of a sweep, or of a number to differentiate by
};

CheckedTable check_with_tables(const DeckNode& tree,
                               const TableFiles& files,
                               std::vector<MeshRecord>& records,
                               FaultList& faults) {
    if (!has_function_files(tree) && !has_copies(tree)) return check_deck(tree, faults);
    DeckNode filled = tree;
    expand_copies(filled, faults);
    faults.throw_if_any();
    fill_function_tables(filled, files, records, faults);
    return check_deck(filled, faults);
}

Problem read_source(const DeckSource& source,
                    const std::vector<std::string>& overrides,
                    const DeckRecord* before = nullptr);

// The problem with a value for a key, as deck and files were read.
Problem vary(const DeckRecord& record, const std::string& key, double value) {
    return read_source({record.text, record.name, MeshFiles(record.meshes), TableFiles(record.meshes), true},
                       {fmt::format("{}={}", key, value)});
}

// Lets each sweep build its models, and tries the first of them.
void prepare_sweeps(const DeckNode& tree, const CheckedTable& deck, Problem& problem, FaultList& faults) {
    for (std::size_t i = 0; i < problem.stages.size(); ++i) {
        StagePlan& stage = problem.stages[i];
        const auto* settings = std::get_if<EigenvalueSettings>(&stage.analysis);
        if (settings == nullptr || !settings->sweep) continue;
        stage.vary = [record = std::make_shared<DeckRecord>(problem.record),
                      key = settings->sweep->key](double value) { return vary(*record, key, value); };
        const SweepTable& table = *list_analyses(deck)[i].get().sweep;
        const std::string& key = settings->sweep->key;
        const Place place = table.place_of(&table.key);
        const std::string path = table.path_of(&table.key);
        const std::string lack = describe_missing_parameter(key, tree);
        if (!lack.empty()) faults.add(place, path, "the deck has no " + lack);
        const double first = settings->sweep->values.front();
        try {
            stage.vary(first);
        } catch (const DeckError& error) {
            faults.add(place, path, fmt::format("with {}={}: {}", key, first, error.faults.front().message));
        }
    }
}

// Inputs that no expression reads. The deck and the model have each of them anyway.
void note_idle_inputs(Problem& problem) {
    for (const std::shared_ptr<Input>& input : problem.model.inputs) {
        if (input.use_count() > 2) continue;
        problem.notes.push_back(
            fmt::format("input.{}: nothing uses it; expressions of t read it by its name", input->name()));
    }
}

// The deck of a tree that has its overrides, with one to resume, if any: a key that must not differ is a
// fault. Throws with `faults` and those of the first phase that finds some.
Problem build_overridden(const DeckNode& tree,
                         const DeckSource& source,
                         const std::vector<std::string>& overrides,
                         const DeckRecord* before,
                         FaultList& faults) {
    // Differences between models are to be those of their numbers, not of cells.
    std::optional<HeldMeshes> held;
    if (source.is_varied) held.emplace();
    std::vector<MeshRecord> tables;
    const CheckedTable deck = check_with_tables(tree, source.tables, tables, faults);
    faults.throw_if_any();
    if (before != nullptr) check_resumption(read_toml(before->text, before->name), tree, faults);
    faults.throw_if_any();
    Problem problem = build_problem(deck, {source.meshes, source.tables}, faults);
    faults.throw_if_any();
    apply_imperfections(deck, source.tables, source.is_varied, problem, faults);
    faults.throw_if_any();
    note_idle_inputs(problem);
    for (const MeshRecord& table : tables) keep_file(table.file, table.bytes, problem.record.meshes);
    problem.record.name = std::filesystem::path(source.file).filename().string();
    if (source.is_varied) return problem;
    FaultList questions(source.file, overrides);
    question_large_shapes(deck, problem.model, questions);
    for (const DeckFault& question : questions.list()) problem.notes.push_back(describe(question));
    problem.record.text =
        overrides.empty() ? source.text : write_overridden_deck(problem.record.name, overrides, tree);
    prepare_sweeps(tree, deck, problem, faults);
    faults.throw_if_any();
    return problem;
}

// The same of a tree without overrides. Throws with the faults of all phases.
Problem build_tree(DeckNode tree,
                   const DeckSource& source,
                   const std::vector<std::string>& overrides,
                   const DeckRecord* before) {
    FaultList faults(source.file, overrides);
    apply_overrides(overrides, tree, faults);
    try {
        return build_overridden(tree, source, overrides, before, faults);
    } catch (const DeckError& error) {
        // Keys of copies are not those of the tree.
        if (source.is_varied || has_copies(tree)) throw;
        const auto build = [&](const DeckNode& rest) {
            FaultList further(source.file, overrides);
            build_overridden(rest, source, overrides, before, further);
        };
        throw DeckError(find_further_faults(error.faults, std::move(tree), build));
    }
}

Problem read_source(const DeckSource& source,
                    const std::vector<std::string>& overrides,
                    const DeckRecord* before) {
    return build_tree(read_toml(source.text, source.file), source, overrides, before);
}

// Meshes and tables.
void check_files(const DeckRecord& before, const DeckRecord& now, const std::string& file) {
    for (const MeshRecord& mesh : now.meshes) {
        const auto same = std::find_if(before.meshes.begin(),
                                       before.meshes.end(),
                                       [&](const MeshRecord& other) { return other.file == mesh.file; });
        if (same != before.meshes.end() && same->bytes == mesh.bytes) continue;
        throw FileError(file, "the file " + mesh.file + " is another one than the run's");
    }
}

void check_same_mesh(const DeckRecord& before,
                     const Model& now,
                     const MeshFiles& meshes,
                     const std::string& file) {
    if (have_same_mesh(read_source({before.text, before.name, meshes, TableFiles(before.meshes)}, {}).model,
                       now))
        return;
    throw DeckError({{file,
                      0,
                      0,
                      "",
                      "makes another mesh than the run's; keep the order of rods and bodies, and the points "
                      "that get a node: those of relative_to, too"}});
}

}  // namespace

Problem read_problem(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
    return read_problem_text(read_deck_file(deck), deck.string(), overrides);
}

Problem read_problem_text(std::string_view text,
                          const std::string& file,
                          const std::vector<std::string>& overrides) {
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    const MeshFiles meshes(folder);
    const std::string kept(text);
    return read_source({kept, file, meshes, TableFiles(folder)}, overrides);
}

Problem rebuild_problem(const DeckRecord& record, const std::vector<std::string>& overrides) {
    return read_source({record.text, record.name, MeshFiles(record.meshes), TableFiles(record.meshes)},
                       overrides);
}

DeckTemplate::DeckTemplate(const std::filesystem::path& deck) : DeckTemplate(read_deck_file(deck), deck) {}

DeckTemplate::DeckTemplate(std::string text, const std::filesystem::path& file)
    : file_(file.string()),
      text_(std::move(text)),
      tree_(read_toml(text_, file_)),
      meshes_(file.parent_path()) {}

Problem DeckTemplate::build(const std::vector<std::string>& overrides, bool is_varied) const {
    const TableFiles tables(std::filesystem::path(file_).parent_path());
    return build_tree(tree_, {text_, file_, meshes_, tables, is_varied}, overrides, nullptr);
}

Problem read_resumption(const DeckRecord& before,
                        const std::filesystem::path& deck,
                        const std::vector<std::string>& overrides) {
    if (before.text.starts_with(program_laws_note)) {
        throw DeckError({{before.name,
                          0,
                          0,
                          "",
                          "was run by a program with laws or functions of its own, which its results do not "
                          "have; continue the run in that program, from a checkpoint"}});
    }
    if (deck.empty()) {
        const MeshFiles kept(before.meshes);
        Problem problem =
            read_source({before.text, before.name, kept, TableFiles(before.meshes)}, overrides, &before);
        if (!overrides.empty()) check_same_mesh(before, problem.model, kept, before.name);
        return problem;
    }
    const MeshFiles meshes(deck.parent_path());
    const std::string file = deck.string();
    const std::string text = read_deck_file(deck);
    Problem problem = read_source({text, file, meshes, TableFiles(deck.parent_path())}, overrides, &before);
    check_files(before, problem.record, deck.string());
    check_same_mesh(before, problem.model, meshes, deck.string());
    return problem;
}

}  // namespace gxrod
