#include "deck/problem.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "deck/build_analysis.hpp"
#include "deck/build_bodies.hpp"
#include "deck/build_loads.hpp"
#include "deck/build_output.hpp"
#include "deck/build_rods.hpp"
#include "deck/build_supports.hpp"
#include "deck/overrides.hpp"
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

// Checks every text that names a point, and returns those of rods.
std::vector<RodPoint> check_points(const BuildContext& context) {
    std::vector<RodPoint> of_rods;
    const auto check = [&](const CheckedTable& table, const std::string& text) -> std::optional<Point> {
        const std::variant<Point, std::string> found = context.names.find(text);
        if (const auto* message = std::get_if<std::string>(&found)) {
            context.add_fault(table, "at", *message);
            return std::nullopt;
        }
        const Point& point = std::get<Point>(found);
        if (const auto* of_rod = std::get_if<RodPoint>(&point)) of_rods.push_back(*of_rod);
        return point;
    };
    for (const CheckedTable& body : context.deck.tables("body")) {
        const auto* text = std::get_if<std::string>(&body.find("at")->value);
        if (text == nullptr) continue;
        const std::optional<Point> point = check(body, *text);
        if (point && std::holds_alternative<BodyPoint>(*point)) {
            context.add_fault(body, "at", fmt::format("\"{}\" is a body; expected a point of a rod", *text));
        }
    }
    for (const char* key : {"load", "support", "history"}) {
        for (const CheckedTable& table : context.deck.tables(key)) check(table, table.get<std::string>("at"));
    }
    return of_rods;
}

Problem build_problem(const CheckedTable& deck, FaultList& faults) {
    Problem problem;
    const PointNames names(deck);
    BuildContext context{deck, names, faults, problem.notes, problem.model, {}, {}};
    check_names(deck, faults);
    const std::vector<RodPoint> points = check_points(context);
    problem.model.gravity = deck.get<Vec3>("gravity");
    build_sections(context);
    build_rods(points, context);
    build_bodies(context);
    build_supports(context);
    build_loads(context);
    problem.analysis = build_analysis(context);
    check_load_functions(problem.analysis, context);
    problem.output = build_output(context);
    problem.record.title = deck.get<std::string>("title");
    problem.record.units = deck.get<std::string>("units");
    return problem;
}

std::string read_file(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw FileError(path, "is a folder, expected a deck");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileError(path, "cannot be read");
    std::ostringstream text;
    text << file.rdbuf();
    if (file.bad()) throw FileError(path, "cannot be read");
    return text.str();
}

}  // namespace

Problem read_problem(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
    return read_problem_text(read_file(deck), deck.string(), overrides);
}

Problem read_problem_text(std::string_view text,
                          const std::string& file,
                          const std::vector<std::string>& overrides) {
    DeckNode tree = read_toml(text, file);
    FaultList faults(file, overrides);
    apply_overrides(overrides, tree, faults);
    const CheckedTable deck = check_deck(tree, faults);
    faults.throw_if_any();
    Problem problem = build_problem(deck, faults);
    faults.throw_if_any();
    problem.record.name = std::filesystem::path(file).filename().string();
    problem.record.text =
        overrides.empty() ? std::string(text) : write_overridden_deck(problem.record.name, overrides, tree);
    return problem;
}

}  // namespace gxrod
