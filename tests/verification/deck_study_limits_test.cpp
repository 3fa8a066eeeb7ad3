// What a study reports if runs cannot be made, fail, are cut or end early, or show nothing.
#include <cmath>

#include "study/deck_study_text.hpp"
#include "tools/catch.hpp"
#include "verification/studied_decks.hpp"

using namespace gxrod;
using namespace gxrod::test;

TEST_CASE("steps that are cut wherever they begin say nothing about errors", "[verification]") {
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

TEST_CASE("a run of one step cannot be stopped midway", "[verification]") {
    const DeckStudy single = study(swing, {VariantKind::resumed}, {"analysis.steps=1"});
    REQUIRE(single.runs.size() == 2);
    CHECK(single.runs[1].is_whole());
    CHECK(single.runs[1].untried == "no step is left to resume with");
    CHECK(single.runs[1].steps == 1);
    CHECK(single.is_sound());
}

TEST_CASE("round-off is recognized where there is nothing else", "[verification]") {
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

TEST_CASE("how far a model moves is reported", "[verification]") {
    const DeckStudy swinging = study(swing, {});
    CHECK(swinging.motion > 0.1);
    CHECK_FALSE(swinging.hardly_moves());
    const DeckStudy resting = study(swing, {VariantKind::turned}, {"load=[]"});
    CHECK(resting.motion < 1e-12);
    CHECK(resting.hardly_moves());
    CHECK(resting.is_sound());
}

TEST_CASE("a run that cannot be made is reported, and the others are kept", "[verification]") {
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

TEST_CASE("an interrupted study reports what it has", "[verification]") {
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
