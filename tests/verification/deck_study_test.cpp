#include "verification/deck_study.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "model/temporary_folder.hpp"
#include "verification/deck_study_text.hpp"

using namespace gxrod;

namespace {

// Everything that turning a model must turn: loads of each frame, functions of time and place, supports with
// axes of their own that move, gravity that changes, bodies with offsets, velocities, every quantity of a
// history.
const std::string everything = R"deck(title = "Everything"
gravity = [0.3, "-9.81*cos(t)", 0.1]
[section.s]
stiffness = { EA = 1e4, GAy = 6e3, GAz = 5e3, GJ = 80, EIy = 100, EIz = 140 }
inertia = { rhoA = 1, rhoIy = 0.01, rhoIz = 0.02 }
damping = { kelvin_voigt = 1e-3, mass_proportional = 0.1 }
[rod.arm]
section = "s"
spline = [[0, 0, 0], [1, 0.5, 0.2], [2, 0, 0.7]]
elements = 4
order = 2
[rod.leg]
section = "s"
line = { from = [2, 0, 0.7], to = [3, 0, 0] }
elements = 2
[[connect]]
points = ["arm.end", "leg.start"]
[body.tool]
mass = 0.5
inertia = [0.1, 0.2, 0.25]
at = "leg.end"
centre_of_mass = [0.1, 0.05, -0.1]
rotation_vector = [0.2, -0.3, 0.4]
[body.lone]
mass = 1.5
inertia = [0.3, 0.2, 0.25]
at = [5, 5, 5]
velocity = [0.1, 0.2, -0.3]
angular_velocity = [1, 2, 3]
[[support]]
at = "arm.start"
fix = ["x", "y", "rx", "ry"]
move = { z = "0.05*sin(3*t)", rz = "0.4*t*t" }
axes = [[0.36, 0.48, -0.8], [-0.8, 0.6, 0], [0.48, 0.64, 0.6]]
[[load]]
at = "leg.end"
force = [1, "2*sin(5*t)", 0]
moment = [0, 0.2, "0.3*t"]
[[load]]
at = "arm.end"
force = [0, "3*t", 1]
moment = [0.1, 0, 0]
frame = "follower"
[[load]]
at = "arm@0.5"
force = [0, 2, "t"]
moment = [0.3, 0.1, 0]
frame = "body"
[[load]]
on = "arm"
force_per_length = ["0.5*s", 0, "-t"]
moment_per_length = [0, 0.1, 0]
[[load]]
on = "leg"
force_per_length = [0, 0.4, 0.2]
frame = "follower"
[[load]]
on = "leg"
force_per_length = [0.1, "s*t", 0.2]
frame = "body"
[analysis]
kind = "dynamic"
end_time = 0.5
steps = 25
[[history]]
name = "tip"
at = "leg.end"
quantities = ["position", "displacement", "rotation_vector", "orientation", "velocity", "angular_velocity",
  "angular_velocity_material", "acceleration", "force", "moment", "force_spatial", "moment_spatial", "strain", "curvature"]
[[history]]
name = "root"
at = "arm.start"
quantities = ["reaction_force", "reaction_moment"]
[[history]]
name = "body"
at = "lone"
quantities = ["position", "quaternion", "orientation", "rotation_vector", "centre_of_mass", "velocity"]
[[history]]
name = "seen"
at = "leg.end"
relative_to = "arm.end"
quantities = ["position", "displacement", "velocity", "acceleration", "rotation_vector", "quaternion", "orientation"]
)deck";

class DeckFile {
  public:
    explicit DeckFile(const std::string& text) : path_(folder_.path() / "deck.toml") {
        std::ofstream(path_) << text;
    }
    DeckTemplate read() const { return DeckTemplate(path_); }

  private:
    TemporaryFolder folder_{"test"};
    std::filesystem::path path_;
};

DeckStudy study(const std::string& text,
                const std::vector<VariantKind>& kinds,
                const std::vector<std::string>& overrides = {},
                const DeckStudyOptions& options = {}) {
    const DeckFile file(text);
    const DeckTemplate deck = file.read();
    std::vector<DeckVariant> variants;
    for (const DeckVariant& variant : list_variants(deck.build(overrides), 2)) {
        const bool is_wanted = variant.kind == VariantKind::as_it_is ||
                               std::find(kinds.begin(), kinds.end(), variant.kind) != kinds.end();
        if (is_wanted) variants.push_back(variant);
    }
    return study_deck(deck, overrides, variants, options);
}

// A cantilever that swings, in few steps.
const std::string swing = R"deck([section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 100, EIy = 100, EIz = 100 }
inertia = { rhoA = 1, rhoIy = 0.01, rhoIz = 0.01 }
[rod.beam]
section = "s"
line = { from = [0, 0, 0], to = [4, 0, 0] }
elements = 4
[[support]]
at = "beam.start"
fix = "all"
[[load]]
at = "beam.end"
force = [0, "3*sin(t)^2", "sin(t)^2"]
[analysis]
kind = "dynamic"
end_time = 2.0
time_step = 0.02
)deck";

// The same of a mesh of two elements, beam.msh.
std::string mesh_swing() {
    std::string text = swing;
    const std::size_t line = text.find("line = ");
    return text.replace(line, text.find("[[support]]") - line, "mesh = { file = \"beam.msh\", group = 7 }\n");
}

const SeriesReport& find(const DeckStudy& study, const std::string& title) {
    for (const SeriesReport& report : study.series) {
        if (report.series.title() == title) return report;
    }
    FAIL("no series " << title);
    return study.series.front();
}

}  // namespace

TEST_CASE("a turned model has the turned motion", "[verification]") {
    for (const char* integrator : {"newmark-simplified", "sdirk-4"}) {
        INFO(integrator);
        const DeckStudy turned =
            study(everything,
                  {VariantKind::turned},
                  {std::string("analysis.integrator=") + integrator, "analysis.newton.tolerance=1e-12"});
        REQUIRE(turned.runs.size() == 2);
        REQUIRE(turned.runs[1].is_whole());
        // Of a rotation's two forms one is followed.
        CHECK(turned.series.size() == 14 + 2 + 5 + 6);
        for (const SeriesReport& report : turned.series) {
            INFO(report.series.title());
            CHECK(report.scale > 0.0);
            CHECK(report.relative(report.turned_difference) < 1e-9);
        }
        CHECK(turned.is_sound());
        CHECK(turned.rotation.norm() > 0.5);
    }
}

TEST_CASE("statics turn as dynamics do", "[verification]") {
    std::string text = everything;
    text.replace(
        text.find("kind = \"dynamic\"\nend_time = 0.5\nsteps = 25"), 42, "kind = \"static\"\nsteps = 4");
    // What moves freely has no place in statics.
    const std::size_t lone = text.find("[body.lone]");
    text.erase(lone, text.find("[[support]]") - lone);
    const std::size_t history = text.find("[[history]]\nname = \"body\"");
    text.erase(history, text.find("[[history]]\nname = \"seen\"") - history);
    const DeckStudy turned = study(text, {VariantKind::turned}, {"analysis.newton.tolerance=1e-12"});
    REQUIRE(turned.runs.size() == 2);
    INFO(turned.runs[0].failure);
    REQUIRE(turned.runs[1].is_whole());
    for (const SeriesReport& report : turned.series) {
        INFO(report.series.title());
        CHECK(report.relative(report.turned_difference) < 1e-9);
    }
}

TEST_CASE("errors of step and mesh are estimated, and are those that are there", "[verification]") {
    const DeckStudy coarse = study(swing, {VariantKind::finer_steps, VariantKind::finer_mesh});
    CHECK_FALSE(coarse.has_own_histories);
    REQUIRE(coarse.series.size() == 4);
    const SeriesReport& tip = find(coarse, "beam.end position");
    CHECK(*tip.steps.order == Approx(2.0).margin(0.1));
    CHECK(*tip.mesh.order == Approx(2.0).margin(0.1));
    CHECK(tip.steps.is_supported);
    CHECK(coarse.find(VariantKind::finer_steps, 2)->steps == 400);
    CHECK(coarse.find(VariantKind::finer_mesh, 2)->elements == 16);
    // The clamp stays.
    CHECK(find(coarse, "beam.start position").is_still);
    // Against a run on a mesh and with steps so fine that its own errors do not matter.
    const std::vector<std::string> finest{
        "rod.beam.elements=16", "rod.beam.order=3", "analysis.time_step=0.002"};
    const DeckStudy fine = study(swing, {}, finest);
    const auto last = [](const DeckStudy& study) {
        const HistoryPoint::Row& row = study.base_rows[2].back();
        return Vec3(row[0], row[1], row[2]);
    };
    REQUIRE(fine.series[2].series.title() == "beam.end position");
    const double error = (last(coarse) - last(fine)).norm();
    const double estimated = tip.steps.errors.back() + tip.mesh.errors.back();
    CHECK(error > 0.01);
    // Both parts may have either sign.
    CHECK(estimated > 0.95 * error);
    CHECK(estimated < 2.0 * error);
}

TEST_CASE("without histories, the ends of rods and the bodies are followed", "[verification]") {
    const DeckStudy bodies = study(
        "[body.top]\nmass = 2\ninertia = [1, 2, 3]\nat = [1, 0, 0]\n"
        "velocity = [0.5, 0, 0]\nangular_velocity = [0.1, 2, 0.1]\n"
        "[analysis]\nkind = \"dynamic\"\nend_time = 1\nsteps = 50\n",
        {VariantKind::finer_steps, VariantKind::turned});
    CHECK_FALSE(bodies.has_own_histories);
    REQUIRE(bodies.series.size() == 2);
    CHECK(find(bodies, "top position").relative(find(bodies, "top position").turned_difference) < 1e-12);
    CHECK(*find(bodies, "top orientation").steps.order == Approx(2.0).margin(0.1));
    // Half a metre a second along x.
    const HistoryPoint::Row& place = bodies.base_rows[0].back();
    CHECK(place[0] == Approx(1.5).epsilon(1e-13));
    CHECK(bodies.is_sound());
}

TEST_CASE("stopping and threads change nothing", "[verification]") {
    const DeckStudy study_of = study(swing, {VariantKind::resumed, VariantKind::two_threads});
    REQUIRE(study_of.runs.size() == 3);
    for (const VariantRun& run : study_of.runs) {
        INFO(run.variant.title << ": " << run.failure);
        CHECK(run.is_whole());
        CHECK(run.steps == 100);
    }
    CHECK(study_of.is_sound());
}

TEST_CASE("what the user sets gives way to what a variant sets", "[verification]") {
    const DeckStudy coarser = study(swing, {VariantKind::finer_steps}, {"analysis.time_step=0.04"});
    REQUIRE(coarser.runs.size() == 3);
    CHECK(coarser.runs[0].steps == 50);
    CHECK(coarser.runs[1].steps == 100);
    CHECK(coarser.has_finer_steps());
}

TEST_CASE("steps that are cut wherever they begin tell nothing of errors", "[verification]") {
    const DeckStudy cut = study(swing,
                                {VariantKind::finer_steps, VariantKind::turned},
                                {"analysis.time_step=1", "load[0].force=[0,\"300*sin(t)^2\",0]"});
    REQUIRE(cut.runs.size() == 4);
    CHECK(cut.runs[0].rejected_steps > 0);
    // From two steps or four, the same ones come of it, with the same motion.
    CHECK(cut.runs[1].steps == cut.runs[0].steps);
    CHECK(cut.base_rows.size() == cut.series.size());
    CHECK_FALSE(cut.has_finer_steps());
    CHECK(cut.is_turned_cut_alike());
    CHECK(cut.is_sound());
    CHECK_FALSE(cut.is_accurate());
    for (const SeriesReport& report : cut.series) {
        CHECK_FALSE(report.steps.is_known());
        CHECK(std::isinf(report.error));
        CHECK(report.trusted_until == 0.0);
    }
}

TEST_CASE("rods of meshes keep their elements", "[verification]") {
    const DeckFile file(mesh_swing());
    const std::filesystem::path folder = std::filesystem::path(file.read().file()).parent_path();
    std::ofstream(folder / "beam.msh")
        << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n"
           "3 2 0 0\n$EndNodes\n$Elements\n2\n1 1 2 7 1 1 2\n2 1 2 7 1 2 3\n"
           "$EndElements\n";
    const DeckTemplate deck = file.read();
    const std::vector<DeckVariant> variants = list_variants(deck.build({}), 1);
    for (const DeckVariant& variant : variants) {
        CHECK(variant.kind != VariantKind::finer_mesh);
        CHECK(variant.kind != VariantKind::higher_order);
    }
    const DeckStudy whole = study_deck(deck, {}, variants, {});
    CHECK(whole.runs.size() == 7);
    CHECK(whole.is_sound());
    CHECK(whole.unrefined_rods == std::vector<std::string>{"beam"});
    CHECK(judge(whole).back() ==
          "How right the series are is not known, as the elements of rods from mesh files (beam) cannot be "
          "refined "
          "here; compare with a finer mesh.");
    CHECK_FALSE(whole.is_accurate());
    CHECK(study(swing, {}).unrefined_rods.empty());
}

TEST_CASE("a run of one step cannot be stopped midway", "[verification]") {
    const DeckStudy single = study(swing, {VariantKind::resumed}, {"analysis.steps=1"});
    REQUIRE(single.runs.size() == 2);
    CHECK(single.runs[1].is_whole());
    CHECK(single.runs[1].untried == "no step is left to resume with");
    CHECK(single.runs[1].steps == 1);
    CHECK(single.is_sound());
}

TEST_CASE("round-off is seen where it is all there is", "[verification]") {
    // Stiffnesses of 1e16 and a force of 1: of forces there are no digits, of places there are.
    const DeckStudy stiff =
        study(swing,
              {VariantKind::finer_steps, VariantKind::turned, VariantKind::turned_more},
              {"section.s.stiffness={ EA = 1e16, GAy = 1e16, GAz = 1e16, GJ = 1e14, EIy = 1e14, EIz = 1e14 }",
               "rod.beam.line={ from = [0.1, 0.2, 0.3], to = [4, 0, 0] }",
               "history=[{ name = 'root', at = 'beam@0.1', quantities = ['force', 'position'] }]"});
    REQUIRE(stiff.runs.size() == 5);
    const SeriesReport& force = find(stiff, "root force");
    INFO("round-off " << force.round_off << " of " << force.scale << ", turned " << force.turned_difference);
    CHECK(force.round_off > 0.05);
    CHECK(force.error >= force.round_off);
    CHECK(force.trusted_until < 2.0);
    CHECK(stiff.is_sound());
    CHECK_FALSE(stiff.is_accurate());
    CHECK(find(stiff, "root position").round_off < 1e-12);
    // And hardly any where there is none to speak of.
    const DeckStudy soft = study(swing, {VariantKind::turned, VariantKind::turned_more});
    for (const SeriesReport& report : soft.series) CHECK(report.relative(report.round_off) < 1e-9);
}

TEST_CASE("how far a model moves is told", "[verification]") {
    const DeckStudy swinging = study(swing, {});
    CHECK(swinging.motion > 0.1);
    CHECK_FALSE(swinging.hardly_moves());
    const DeckStudy resting = study(swing, {VariantKind::turned}, {"load=[]"});
    CHECK(resting.motion < 1e-12);
    CHECK(resting.hardly_moves());
    CHECK(resting.is_sound());
}

TEST_CASE("steps by their error are studied by their tolerance", "[verification]") {
    const DeckStudy adaptive = study(swing,
                                     {VariantKind::finer_steps, VariantKind::resumed},
                                     {"analysis.integrator=sdirk-4", "analysis.adaptive={tolerance = 1e-4}"});
    REQUIRE(adaptive.runs.size() == 4);
    CHECK(adaptive.runs[1].variant.title == "1/16 of the tolerance");
    CHECK(adaptive.runs[1].steps > adaptive.runs[0].steps);
    INFO(adaptive.runs[3].failure);
    CHECK(adaptive.runs[3].is_whole());
    const SeriesReport& tip = find(adaptive, "beam.end position");
    CHECK(tip.steps.differences[1] < 0.2 * tip.steps.differences[0]);
    // The error of a step, and so the next one's length, does not depend on how the model stands.
    const DeckStudy turned = study(swing,
                                   {VariantKind::turned},
                                   {"analysis.integrator=sdirk-4", "analysis.adaptive={tolerance = 1e-3}"});
    CHECK(find(turned, "beam.end position").relative(find(turned, "beam.end position").turned_difference) <
          1e-8);
    // The bounds of steps are refined with them.
    const DeckStudy bound = study(swing,
                                  {VariantKind::finer_steps},
                                  {"analysis.integrator=sdirk-4",
                                   "analysis.adaptive={tolerance = 1, min_step = 0.02, max_step = 0.02}"});
    CHECK(bound.runs[0].steps == 100);
    CHECK(bound.runs[1].steps == 200);
    CHECK(bound.runs[2].steps == 400);
    CHECK(bound.knows_errors());
    // So few that growth sets them.
    const DeckStudy few = study(swing,
                                {VariantKind::finer_steps},
                                {"analysis.integrator=sdirk-4",
                                 "analysis.end_time=0.1",
                                 "analysis.time_step=1e-4",
                                 "analysis.adaptive={tolerance = 1}"});
    CHECK_FALSE(few.has_finer_steps());
    CHECK_THAT(judge(few).front(), Catch::StartsWith("Something else than the tolerance sets the steps"));
}

TEST_CASE("a run that cannot be made is told, and the others are kept", "[verification]") {
    // Half the step meets the singular time.
    const DeckStudy found = study(swing,
                                  {VariantKind::finer_steps, VariantKind::turned},
                                  {"load[0].force=[0, \"1e-3/(t-0.25)\", 0]", "analysis.time_step=0.1"});
    REQUIRE(found.runs.size() == 4);
    CHECK(found.runs[0].is_whole());
    CHECK_THAT(found.runs[1].failure, Catch::StartsWith("it could not be made: "));
    CHECK_THAT(found.runs[1].failure, Catch::Contains("\"1e-3/(t-0.25)\" is inf at t = 0.25"));
    CHECK(found.runs[3].is_whole());
    CHECK_FALSE(found.is_accurate());
    CHECK_THROWS_AS(study(swing, {VariantKind::finer_steps}, {"load[0].force=[0, \"1e-3/(t-0.1)\", 0]"}),
                    DeckError);
}

TEST_CASE("a load that only the finest run meets is not overlooked", "[verification]") {
    const DeckStudy found = study(swing,
                                  {VariantKind::finer_steps},
                                  {"load[0].force=[0, \"abs(t-0.275)<0.01 ? 500 : 0\", 0]",
                                   "analysis.time_step=0.1",
                                   "analysis.end_time=1"});
    CHECK_FALSE(found.is_accurate());
    CHECK(std::isinf(find(found, "beam.end position").error));
}

TEST_CASE("a rod that flies unstrained has no strains, forces and moments to be judged", "[verification]") {
    const DeckStudy found = study(
        R"deck([section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 100, EIy = 100, EIz = 100 }
inertia = { rhoA = 1, rhoIy = 0.01, rhoIz = 0.01 }
[rod.beam]
section = "s"
line = { from = [0, 0, 0], to = [4, 0, 0] }
elements = 4
[[initial]]
on = "beam"
velocity = [1, 2, 3]
[analysis]
kind = "dynamic"
end_time = 1.0
time_step = 0.05
[[history]]
name = "tip"
at = "beam.end"
quantities = ["position", "strain", "force", "moment", "curvature"]
)deck",
        {VariantKind::finer_steps, VariantKind::finer_mesh, VariantKind::turned, VariantKind::turned_more});
    CHECK(found.is_accurate());
    for (const char* quantity : {"strain", "force", "moment", "curvature"})
        CHECK(find(found, std::string("tip ") + quantity).is_still);
}

TEST_CASE("a deck that does not converge ends its study", "[verification]") {
    const DeckStudy failed = study(swing,
                                   {VariantKind::finer_steps},
                                   {"load[0].force=[0, \"3e9*t\", 0]", "analysis.newton.max_iterations=3"});
    REQUIRE(failed.runs.size() == 1);
    CHECK_THAT(failed.runs[0].failure, Catch::Contains("failed"));
    CHECK_THAT(judge(failed).front(), Catch::StartsWith("The deck as it is does not reach its end"));
    CHECK_FALSE(failed.is_accurate());
}

TEST_CASE("a study that is interrupted tells what it has", "[verification]") {
    DeckStudyOptions options;
    int runs = 0;
    int most_runs = 2;
    options.report_run = [&](const VariantRun&) { ++runs; };
    options.is_interrupted = [&] { return runs == most_runs; };
    const DeckStudy ended = study(swing, {VariantKind::finer_steps}, {}, options);
    CHECK(ended.is_interrupted);
    CHECK(ended.runs.size() == 2);
    CHECK(find(ended, "beam.end position").steps.differences.size() == 1);
    CHECK(std::isfinite(ended.series.front().error));
    CHECK_THAT(judge(ended).front(), Catch::StartsWith("Interrupted"));
    runs = 0;
    most_runs = 1;
    const DeckStudy soon = study(swing, {VariantKind::finer_steps}, {}, options);
    CHECK(soon.runs.size() == 1);
    CHECK(std::isinf(soon.series.front().error));
    CHECK(soon.series.front().trusted_until == 0.0);
    CHECK_FALSE(soon.is_accurate());
}

TEST_CASE("the variants that make sense", "[verification]") {
    const auto titles = [](const std::string& text, const std::vector<std::string>& overrides) {
        const DeckFile file(text);
        std::vector<std::string> found;
        for (const DeckVariant& variant : list_variants(file.read().build(overrides), 1))
            found.push_back(variant.title);
        return found;
    };
    const std::vector<std::string> all{"as it is",
                                       "half the step",
                                       "twice the elements",
                                       "elements of the next order",
                                       "turned in space",
                                       "turned by 1e-6 rad more",
                                       "elements simo",
                                       "stopped midway and resumed",
                                       "two threads"};
    CHECK(titles(swing, {}) == all);
    const auto highest = titles(swing, {"rod.beam.order=4", "rod.beam.element=simo"});
    CHECK(highest == std::vector<std::string>{"as it is",
                                              "half the step",
                                              "twice the elements",
                                              "turned in space",
                                              "turned by 1e-6 rad more",
                                              "stopped midway and resumed",
                                              "two threads"});
    const DeckFile file(swing);
    const auto variants = list_variants(file.read().build({"rod.beam.elements=6"}), 2);
    CHECK(variants[2].overrides == std::vector<std::string>{"analysis.steps=400"});
    CHECK(variants[4].overrides == std::vector<std::string>{"rod.beam.elements=24"});
    CHECK(total_cost(variants) == Approx(20.5));
}
