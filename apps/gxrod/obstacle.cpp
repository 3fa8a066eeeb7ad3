#include <cmath>
#include <filesystem>
#include <memory>

#include "exit_code.hpp"
#include "machine/file_error.hpp"
#include "mesh/line_mesh.hpp"
#include "mesh/triangles/stl_file.hpp"
#include "mesh/triangles/triangle_examination.hpp"
#include "mesh/triangles/triangle_file.hpp"
#include "report/model/mesh_picture.hpp"
#include "report/page_file.hpp"
#include "say.hpp"
#include "verbs.hpp"

namespace gxrod {
namespace {

struct ObstacleArguments {
    std::string file;
    double scale = 1.0;
    double feature_angle = 0.1;
    std::string picture;
    bool is_strict = false;
    bool force = false;
};

// "1 open edge", "2 open edges".
std::string count_things(std::size_t count, const std::string& thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string describe_measures(const TriangleMesh& mesh, const TriangleExamination& found) {
    const Vec3 size = found.high - found.low;
    constexpr double degree = M_PI / 180.0;
    std::string text = fmt::format("{}: {} of {}, sides {:.4g} to {:.4g}\n",
                                   mesh.file,
                                   count_things(mesh.triangles.size(), "triangle"),
                                   count_things(found.parts, "part"),
                                   found.least_side,
                                   found.greatest_side);
    text += fmt::format(
        "box: {:.6g} × {:.6g} × {:.6g}, from ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g})\n",
        size[0],
        size[1],
        size[2],
        found.low[0],
        found.low[1],
        found.low[2],
        found.high[0],
        found.high[1],
        found.high[2]);
    text += fmt::format("area: {:.8g}\n", found.area);
    text +=
        found.volume ? fmt::format("volume: {:.8g}\n", *found.volume) : std::string("volume: not closed\n");
    return text + fmt::format(
                      "edges: {} sharp (turned by more than {:.4g} rad); the surface turns by {:.4g} rad, "
                      "{:.3g} degrees, at most\n",
                      found.sharp_edges,
                      mesh.feature_angle,
                      found.greatest_turn,
                      found.greatest_turn / degree);
}

std::string describe_flipped(const std::vector<int>& flipped) {
    constexpr std::size_t most_named = 8;
    std::string text = fmt::format("{} the other way around than most of {} part: triangle{} ",
                                   count_things(flipped.size(), "facet"),
                                   flipped.size() == 1 ? "its" : "their",
                                   flipped.size() == 1 ? "" : "s");
    for (std::size_t i = 0; i < std::min(flipped.size(), most_named); ++i)
        text += (i > 0 ? ", " : "") + std::to_string(flipped[i]);
    return flipped.size() > most_named ? text + " …" : text;
}

std::vector<std::string> list_defects(const TriangleMesh& mesh,
                                      const TriangleExamination& found,
                                      bool is_cut) {
    std::vector<std::string> defects;
    if (is_cut)
        defects.emplace_back("the text has a solid without endsolid: the rest of the file may be lost");
    constexpr std::size_t most_holes = 8;
    for (std::size_t i = 0; i < std::min(found.holes.size(), most_holes); ++i) {
        const MeshHole& hole = found.holes[i];
        defects.push_back(fmt::format("hole of {}, {:.4g} around, about ({:.4g}, {:.4g}, {:.4g})",
                                      count_things(hole.edges, "open edge"),
                                      hole.length,
                                      hole.middle[0],
                                      hole.middle[1],
                                      hole.middle[2]));
    }
    if (found.holes.size() > most_holes)
        defects.push_back(count_things(found.holes.size() - most_holes, "shorter hole"));
    if (found.crowded_edges > 0)
        defects.push_back(count_things(found.crowded_edges, "edge") + " with more than two facets");
    if (!found.flipped.empty()) defects.push_back(describe_flipped(found.flipped));
    if (mesh.repeated > 0) defects.push_back(count_things(mesh.repeated, "repeated facet") + ", left out");
    if (mesh.left_out > 0)
        defects.push_back(count_things(mesh.left_out, "facet") + " without area, left out");
    return defects;
}

void write_picture(const ObstacleArguments& arguments, const std::string& text) {
    if (!arguments.force && std::filesystem::exists(arguments.picture))
        throw FileError(arguments.picture, "exists", "--force replaces it");
    PageFile file(arguments.picture);
    file.out() << text;
    file.finish();
    say(stdout, "{}\n", arguments.picture);
}

int show_obstacle(const ObstacleArguments& arguments) {
    if (!std::filesystem::exists(arguments.file)) throw FileError(arguments.file, "does not exist");
    TriangleMesh mesh;
    bool is_cut = false;
    try {
        mesh = read_triangle_mesh(arguments.file, arguments.scale);
        is_cut = is_stl(arguments.file) && lacks_end_of_stl(read_mesh_file(arguments.file));
    } catch (const MeshError& error) {
        say(stderr, "gxrod: {}: {}\n", arguments.file, error.what());
        return exit_bad_input;
    }
    mesh.file = arguments.file;
    mesh.feature_angle = arguments.feature_angle;
    const TriangleExamination found = examine_triangles(mesh);
    say_text(stdout, describe_measures(mesh, found));
    const std::vector<std::string> defects = list_defects(mesh, found, is_cut);
    for (const std::string& defect : defects) say(stdout, "defect: {}\n", defect);
    if (defects.empty()) say(stdout, "no defects\n");
    if (!arguments.picture.empty()) write_picture(arguments, draw_mesh(mesh, found));
    return arguments.is_strict && !defects.empty() ? exit_bad_input : exit_done;
}

}  // namespace

void add_obstacle_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<ObstacleArguments>();
    CLI::App* verb = program.add_subcommand(
        "obstacle", "Print the size of a mesh for an obstacle and its defects, and draw it");
    verb->add_option("FILE", arguments->file, "Triangles: STL as text or bytes, or .msh of Gmsh")->required();
    verb->add_option("--scale", arguments->scale, "Factor on coordinates, as in the deck")
        ->check(CLI::PositiveNumber)
        ->default_val(1.0);
    verb->add_option(
            "--feature-angle", arguments->feature_angle, "Edges that turn by more are sharp, as in the deck")
        ->check(CLI::PositiveNumber)
        ->default_val(0.1);
    verb->add_option(
        "-o,--output", arguments->picture, "Picture to write, SVG: three views, open edges in red");
    verb->add_flag("--strict", arguments->is_strict, "Return 2 if there are defects");
    verb->add_flag("--force", arguments->force, "Replace an existing file");
    verb->callback([arguments, &exit_code] { exit_code = show_obstacle(*arguments); });
}

}  // namespace gxrod
