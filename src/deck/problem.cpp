#include "deck/problem.hpp"

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

#include "deck/build_analysis.hpp"
#include "deck/build_bodies.hpp"
#include "deck/build_connections.hpp"
#include "deck/build_initial.hpp"
#include "deck/build_loads.hpp"
#include "deck/build_output.hpp"
#include "deck/build_rods.hpp"
#include "deck/build_sections.hpp"
#include "deck/build_supports.hpp"
#include "deck/check_functions.hpp"
#include "deck/check_points.hpp"
#include "deck/check_velocities.hpp"
#include "deck/overrides.hpp"
#include "deck/read_rod_nets.hpp"
#include "deck/validation.hpp"
#include "model/file_error.hpp"

namespace gxrod {
namespace {

void check_names(const CheckedTable& deck, FaultList& faults) {
    for (const CheckedTable& body : deck.tables("body")) {
        for (const CheckedTable& rod : deck.tables("rod")) {
            if (rod.name != body.name) continue;
            const CheckedTable& later = rod.place < body.place ? body : rod;
            const CheckedTable& earlier = rod.place < body.place ? rod : body;
            faults.add(later.place, later.path, earlier.path + " has this name too, and points go by it");
        }
    }
}

Problem build_problem(const CheckedTable& deck, const MeshFiles& files, FaultList& faults) {
    Problem problem;
    const RodNets nets = read_rod_nets(deck, files, faults, problem.record.meshes);
    const PointNames names(deck, points_of(nets));
    BuildContext context{deck, names, faults, problem.notes, problem.model};
    check_names(deck, faults);
    context.analysis = build_analysis(context);
    const std::vector<RodPoint> points = check_points(context);
    build_sections(context);
    build_rods(points, nets, context);
    build_connections(context);
    build_bodies(context);
    build_initial(context);
    build_supports(context);
    check_velocities(context);
    build_loads(context);
    check_functions(context);
    check_linear_solver(context);
    problem.analysis = context.analysis;
    problem.output = build_output(context);
    problem.record.is_static = std::holds_alternative<StaticSettings>(problem.analysis);
    problem.record.title = deck.get<std::string>("title");
    problem.record.units = deck.get<std::string>("units");
    return problem;
}

std::string read_file(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw FileError(path, "is a folder, expected a deck");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileError(path, "cannot be read", std::generic_category().message(errno));
    std::ostringstream text;
    text << file.rdbuf();
    if (file.bad()) throw FileError(path, "cannot be read");
    return text.str();
}

Problem read_problem_with(const MeshFiles& files,
                          std::string_view text,
                          const std::string& file,
                          const std::vector<std::string>& overrides) {
    DeckNode tree = read_toml(text, file);
    FaultList faults(file, overrides);
    apply_overrides(overrides, tree, faults);
    const CheckedTable deck = check_deck(tree, faults);
    faults.throw_if_any();
    Problem problem = build_problem(deck, files, faults);
    faults.throw_if_any();
    problem.record.name = std::filesystem::path(file).filename().string();
    problem.record.text =
        overrides.empty() ? std::string(text) : write_overridden_deck(problem.record.name, overrides, tree);
    return problem;
}

}  // namespace

Problem read_problem(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
    return read_problem_text(read_file(deck), deck.string(), overrides);
}

Problem read_problem_text(std::string_view text,
                          const std::string& file,
                          const std::vector<std::string>& overrides) {
    return read_problem_with(MeshFiles(std::filesystem::path(file).parent_path()), text, file, overrides);
}

Problem rebuild_problem(const DeckRecord& record, const std::vector<std::string>& overrides) {
    return read_problem_with(MeshFiles(record.meshes), record.text, record.name, overrides);
}

}  // namespace gxrod
