#include "study/deck_study.hpp"

#include <cmath>

#include "study/deck_study_text.hpp"
#include "tools/catch.hpp"
#include "verification/studied_decks.hpp"

using namespace gxrod;
using namespace gxrod::test;

TEST_CASE("errors of step and mesh are estimated, and are those that are there", "[study]") {
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
        const HistoryRow& row = study.base_rows[2].back();
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

TEST_CASE("without histories, the ends of rods and the bodies are followed", "[study]") {
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
    const HistoryRow& place = bodies.base_rows[0].back();
    CHECK(place[0] == Approx(1.5).epsilon(1e-13));
    CHECK(bodies.is_sound());
}

TEST_CASE("stopping and threads change nothing", "[study]") {
    const DeckStudy study_of = study(swing, {VariantKind::resumed, VariantKind::two_threads});
    REQUIRE(study_of.runs.size() == 3);
    for (const VariantRun& run : study_of.runs) {
        INFO(run.variant.title << ": " << run.failure);
        CHECK(run.is_whole());
        CHECK(run.steps == 100);
    }
    CHECK(study_of.is_sound());
}

TEST_CASE("what the user sets gives way to what a variant sets", "[study]") {
    const DeckStudy coarser = study(swing, {VariantKind::finer_steps}, {"analysis.time_step=0.04"});
    REQUIRE(coarser.runs.size() == 3);
    CHECK(coarser.runs[0].steps == 50);
    CHECK(coarser.runs[1].steps == 100);
    CHECK(coarser.has_finer_steps());
}

TEST_CASE("rods of meshes keep their elements", "[study]") {
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

TEST_CASE("steps by their error are studied by their tolerance", "[study]") {
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
    // The error of a step, and so the next one's length, does not depend on the model's orientation.
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

TEST_CASE("the variants that make sense", "[study]") {
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

TEST_CASE("a stage is studied after the stages before it, which are refined with it", "[study]") {
    DeckStudyOptions options;
    options.stage = 2;
    const DeckStudy swings = study(bent_and_released,
                                   {VariantKind::finer_steps,
                                    VariantKind::finer_mesh,
                                    VariantKind::turned,
                                    VariantKind::turned_more,
                                    VariantKind::resumed,
                                    VariantKind::two_threads},
                                   {},
                                   options);
    CHECK(swings.stage == "swing");
    CHECK(swings.end_time == 1.0);
    const VariantRun* finest = swings.find(VariantKind::finer_steps, 2);
    REQUIRE(finest != nullptr);
    CHECK(finest->variant.overrides == std::vector<std::string>{"stage[0].steps=16", "stage[2].steps=200"});
    CHECK(finest->steps == 216);
    CHECK(finest->own_steps() == 200);
    for (const VariantRun& run : swings.runs) {
        INFO(run.variant.title << ": " << run.failure << run.untried);
        CHECK(run.is_whole());
        CHECK(run.untried.empty());
    }
    CHECK(swings.is_sound());
    CHECK(swings.is_orientation_judged());
    const SeriesReport& tip = find(swings, "beam.end position");
    CHECK(*tip.steps.order == Approx(2.0).margin(0.1));
    CHECK(*tip.mesh.order == Approx(2.0).margin(0.3));
    CHECK(tip.relative(tip.turned_difference) < 1e-8);
    // It begins bent.
    const HistoryRow& first = swings.base_rows[2].front();
    CHECK(Vec3(first[0] - 4.0, first[1], first[2]).norm() > 0.5);
    const std::vector<std::string> finest_mesh{
        "rod.beam.elements=16", "rod.beam.order=3", "stage[2].time_step=0.002"};
    const DeckStudy fine = study(bent_and_released, {}, finest_mesh, options);
    const HistoryRow& coarse_end = swings.base_rows[2].back();
    const HistoryRow& fine_end = fine.base_rows[2].back();
    const double error =
        Vec3(coarse_end[0] - fine_end[0], coarse_end[1] - fine_end[1], coarse_end[2] - fine_end[2]).norm();
    const double estimated = tip.steps.errors.back() + tip.mesh.errors.back();
    CHECK(error > 0.001);
    CHECK(estimated > 0.95 * error);
    CHECK(estimated < 2.0 * error);
}

TEST_CASE("statics after a motion depend on its steps", "[study]") {
    DeckStudyOptions options;
    options.stage = 3;
    const DeckStudy held = study(bent_and_released,
                                 {VariantKind::finer_steps, VariantKind::turned, VariantKind::resumed},
                                 {},
                                 options);
    CHECK(held.is_static);
    CHECK(held.depends_on_steps);
    CHECK(held.runs[0].own_steps() == 2);
    CHECK(held.runs[0].steps == 56);
    CHECK(held.is_sound());
    const SeriesReport& tip = find(held, "beam.end position");
    CHECK(tip.steps.differences[0] > 1e-5);
    CHECK(tip.steps.differences[1] < 0.5 * tip.steps.differences[0]);
    for (const std::string& sentence : judge(held))
        CHECK_THAT(sentence, !Catch::Contains("second equilibrium"));
    options.stage = 0;
    CHECK_FALSE(study(bent_and_released, {}, {}, options).depends_on_steps);
}

TEST_CASE("which stage is studied", "[study]") {
    const DeckFile file(bent_and_released);
    const Problem problem = file.read().build({});
    CHECK(find_studied_stage(problem, "") == 3);
    CHECK(find_studied_stage(problem, "swing") == 2);
    CHECK_THROWS_WITH(
        find_studied_stage(problem, "tones"),
        "stage tones finds modes; gxrod verify refines what moves. Take --stage bend or swing or "
        "hold, or compare runs with more elements");
    CHECK_THROWS_WITH(
        find_studied_stage(problem, "swin"),
        "there is no stage \"swin\"; did you mean \"swing\"?; there are bend, tones, swing, hold");
    const DeckFile single(swing);
    CHECK_THROWS_WITH(find_studied_stage(single.read().build({}), "swing"),
                      "has [analysis] and no stages: leave out --stage");
}
