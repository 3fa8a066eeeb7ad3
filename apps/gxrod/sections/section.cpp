#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "check/summaries/rod_summary.hpp"
#include "cross_section/catalogue/profile_catalogue.hpp"
#include "cross_section/cross_section.hpp"
#include "exit_code.hpp"
#include "job.hpp"
#include "machine/file_error.hpp"
#include "mesh/sections/section_mesher.hpp"
#include "report/page_file.hpp"
#include "report/section/section_picture.hpp"
#include "say.hpp"
#include "section_results.hpp"
#include "summary.hpp"
#include "verbs.hpp"

namespace gxrod {
namespace {

struct SectionArguments {
    std::string source;
    std::vector<std::string> names, overrides;
    std::vector<double> resultants;
    std::string picture, table;
    double E = 1.0, nu = 0.3;
    bool force = false, json = false, estimates = false;
};

struct NamedSection {
    std::string name;
    Section section;
};

// A profile of the catalogue by itself, in the unit of its table.
NamedSection compute_profile(const CatalogueProfile& profile, const SectionArguments& arguments) {
    ElasticMaterial material;
    material.name = "material";
    material.stiffness = compute_isotropic_stiffness(arguments.E, arguments.nu);
    NamedSection named{profile.name, {.name = profile.name}};
    const Outline outline = draw_outline(profile.shape);
    named.section.shape =
        compute_cross_section(profile.name, mesh_outline(outline, profile.name), {std::move(material)});
    named.section.stiffness = named.section.shape->properties.stiffness;
    return named;
}

std::string list_words(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

// The sections of a deck that were computed from shapes, or those that were asked for.
std::vector<NamedSection> read_sections(const SectionArguments& arguments) {
    const Problem problem = read_job_problem(arguments.source, arguments.overrides);
    std::vector<NamedSection> found;
    std::vector<std::string> known;
    for (const Section& section : problem.model.sections) {
        known.push_back(section.name);
        const bool is_wanted = std::ranges::find(arguments.names, section.name) != arguments.names.end();
        if (is_wanted || (arguments.names.empty() && section.shape)) found.push_back({section.name, section});
    }
    for (const std::string& name : arguments.names) {
        if (std::ranges::find(known, name) == known.end())
            throw CLI::ValidationError(
                "section", fmt::format("no section \"{}\"; the deck has {}", name, list_words(known)));
    }
    if (found.empty())
        throw CLI::ValidationError(
            "section",
            "no section of the deck is cut into cells: each has its numbers, or a circle, tube or rectangle");
    return found;
}

// Gmsh's own files say what they are.
void refuse_mesh(const std::string& path) {
    constexpr std::string_view mark = "$MeshFormat";
    std::string start(mark.size(), ' ');
    std::ifstream(path, std::ios::binary).read(start.data(), static_cast<std::streamsize>(start.size()));
    if (start != mark) return;
    throw CLI::ValidationError(
        "section",
        fmt::format(
            "{} is a mesh without materials; give a deck that has it: [section.NAME] with shape = {{ mesh = "
            "{{ file = \"{}\", material = … }} }}",
            path,
            std::filesystem::path(path).filename().string()));
}

std::vector<NamedSection> find_sections(const SectionArguments& arguments) {
    if (std::filesystem::exists(arguments.source)) {
        refuse_mesh(arguments.source);
        return read_sections(arguments);
    }
    if (const CatalogueProfile* profile = find_profile(arguments.source))
        return {compute_profile(*profile, arguments)};
    const std::vector<std::string> nearest = find_nearest_profiles(arguments.source);
    throw CLI::ValidationError("section",
                               fmt::format("no file and no profile \"{}\"{}",
                                           arguments.source,
                                           nearest.empty() ? "; series are " + list_words(list_series())
                                                           : "; nearest are " + list_words(nearest)));
}

void write_file(const std::string& path, const std::string& text, const SectionArguments& arguments) {
    if (!arguments.force && std::filesystem::exists(path))
        throw FileError(path, "exists", "--force replaces it");
    PageFile file(path);
    file.out() << text;
    file.finish();
    if (!arguments.json) say(stdout, "{}\n", path);
}

// What a file can be written of: a section that is cut into cells.
const CrossSection& shape_to_write(const NamedSection& named) {
    if (named.section.shape) return *named.section.shape;
    throw CLI::ValidationError("section", fmt::format("section \"{}\" has no shape to draw", named.name));
}

void say_section(const Section& section, const std::optional<Vec6>& resultants, bool estimates) {
    say_text(stdout, describe_section(section));
    if (!section.shape) {
        if (resultants || estimates) say(stdout, "  not cut into cells: no stresses and no estimate\n");
        return;
    }
    if (resultants) say_text(stdout, describe_stress(*section.shape, *resultants));
    if (estimates) say_text(stdout, describe_estimate(*section.shape));
}

int show_sections(const SectionArguments& arguments) {
    std::optional<Vec6> resultants;
    if (!arguments.resultants.empty()) resultants = Eigen::Map<const Vec6>(arguments.resultants.data());
    if (!arguments.table.empty() && !resultants)
        throw CLI::ValidationError("--csv", "give --resultants too: their stresses are written");
    const std::vector<NamedSection> sections = find_sections(arguments);
    if (!(arguments.picture.empty() && arguments.table.empty()) && sections.size() > 1)
        throw CLI::ValidationError("section", "a file is of one section; name it after the deck");
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const NamedSection& named : sections) {
        if (arguments.json) {
            json.push_back(section_json(named.section, resultants));
        } else {
            say_section(named.section, resultants, arguments.estimates);
        }
        if (!arguments.picture.empty())
            write_file(arguments.picture,
                       draw_section(shape_to_write(named), {.resultants = resultants}),
                       arguments);
        if (!arguments.table.empty())
            write_file(arguments.table, write_stress_csv(shape_to_write(named), *resultants), arguments);
    }
    if (arguments.json) write_json("-", json);
    return exit_done;
}

}  // namespace

void add_section_verb(CLI::App& program, int& exit_code) {
    auto arguments = std::make_shared<SectionArguments>();
    CLI::App* verb =
        program.add_subcommand("section", "Print and draw cross-sections: of a deck, or a profile by name");
    verb->add_option("SOURCE", arguments->source, "Deck (TOML), or the name of a profile: \"IPE 200\"")
        ->required();
    verb->add_option(
        "NAME", arguments->names, "Sections of the deck; all that are cut into cells if left out");
    verb->add_option("--set", arguments->overrides, "KEY=VALUE: change a key of the deck")
        ->allow_extra_args(false);
    verb->add_option(
            "--resultants",
            arguments->resultants,
            "N Vy Vz T My Mz: print their largest stress and how near they are to failure, and colour the "
            "picture by stress")
        ->expected(6);
    verb->add_option("--E", arguments->E, "Young's modulus of a profile given by name")->default_val(1.0);
    verb->add_option("--nu", arguments->nu, "Poisson's ratio of a profile given by name")->default_val(0.3);
    verb->add_option("-o,--output", arguments->picture, "Picture to write, SVG");
    verb->add_option("--csv", arguments->table, "File for the stresses of the resultants at all points");
    verb->add_flag("--json", arguments->json, "Print JSON instead of text");
    verb->add_flag("--estimate",
                   arguments->estimates,
                   "Solve again with an order one higher, and print the change of each constant");
    verb->add_flag("--force", arguments->force, "Replace existing files");
    verb->callback([arguments, &exit_code] { exit_code = show_sections(*arguments); });
}

}  // namespace gxrod
