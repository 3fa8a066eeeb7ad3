#include <limits>

#include "tools/catch.hpp"
#include "verification/made_studies.hpp"

using namespace gxrod;
using namespace gxrod::test;

TEST_CASE("what must not be is called a fault", "[study]") {
    DeckStudy study = make_study({make_report("tip", 1e-3, 1e-3)});
    study.series[0].turned_difference = 0.01;
    CHECK_FALSE(study.is_sound());
    CHECK(says(study, "The motion depends on the model's orientation in space"));
    study.series[0].turned_difference = 1e-7;
    CHECK(study.is_sound());
    for (const VariantKind kind : {VariantKind::resumed, VariantKind::two_threads}) {
        DeckStudy unequal = make_study({make_report("tip", 1e-3, 1e-3)});
        for (VariantRun& run : unequal.runs) {
            if (run.variant.kind == kind) run.failure = "tip position differs at t = 0.5";
        }
        CHECK_FALSE(unequal.is_sound());
        CHECK(says(unequal, "is not the same as the deck as it is: tip position differs at t = 0.5"));
    }
}

TEST_CASE("a turned model can differ by the error, and by anything if its steps are cut elsewhere",
          "[study]") {
    DeckStudy study = make_study({make_report("tip", 1e-3, 1e-3)});
    study.series[0].turned_difference = 0.9 * study.series[0].error;
    CHECK(study.is_sound());
    study.series[0].turned_difference = 1.1 * study.series[0].error;
    CHECK_FALSE(study.is_sound());
    CHECK(says(study,
               "The motion depends on the model's orientation in space, by more than its errors. If no "
               "expression of the "
               "deck hides a direction, and a smaller newton.tolerance does not mend it, please report it."));
    study.runs[0].steps = 90;
    study.runs[1].steps = 180;
    study.runs[2].steps = 91;
    study.runs[2].rejected_steps = 1;
    study.runs[2].is_cut_alike = false;
    CHECK(study.is_sound());
    CHECK(says(study,
               "Turned in space, other steps were taken, which round-off can decide (steps and cuts: 90 and "
               "0 as it is, 91 and 1 turned in space): that the motion then differs by 0.22 % says nothing "
               "of its orientation."));
    CHECK_THAT(describe_properties(study), Catch::Contains("by 0 rad: differs by 2.2e-03\n"));
}

TEST_CASE("nothing is said of the orientation of a model that hardly moves", "[study]") {
    DeckStudy study = make_study({make_report("tip", 1e-3, 1e-3)});
    study.series[0].turned_difference = 1.1 * study.series[0].error;
    study.motion = 1.1e-12;
    CHECK_FALSE(study.is_sound());
    CHECK_FALSE(says(study, "hardly moves"));
    study.motion = 2e-13;
    CHECK(study.is_sound());
    CHECK(says(study,
               "The model hardly moves, by 2e-13 of its size: velocities, accelerations and what they "
               "add to forces are those of round-off, and nothing is said of its orientation."));
    CHECK(to_json(study, false)["motion"] == 2e-13);
    study.runs[2].failure = "the step from t = 0 failed";
    CHECK(study.is_sound());
}

TEST_CASE("where steps are cut in a part of the run alone, finer ones must be more there, too", "[study]") {
    DeckStudy study = make_study({make_report("tip", 1e-9, 1e-3)});
    for (int i = 0; i <= 100; ++i) study.times.push_back(0.1 * i);
    VariantRun& base = study.runs[0];
    VariantRun& finer = study.runs[1];
    const auto count = [&](VariantRun& run, long a_sample, long a_cut_sample) {
        run.steps_at = {0};
        for (int i = 1; i <= 100; ++i)
            run.steps_at.push_back(run.steps_at.back() + (i > 40 && i <= 60 ? a_cut_sample : a_sample));
        run.steps = run.steps_at.back();
    };
    count(base, 1, 8);
    count(finer, 2, 16);
    CHECK(study.has_finer_steps());
    count(finer, 2, 9);
    const std::optional<UnrefinedPart> part = study.find_unrefined_part();
    REQUIRE(part);
    CHECK(part->from == Approx(4.0));
    CHECK(part->until == Approx(4.1));
    CHECK(part->coarse_steps == 8);
    CHECK(part->fine_steps == 9);
    CHECK_FALSE(study.knows_errors());
    study.series[0].error = std::numeric_limits<double>::infinity();
    CHECK(
        says(study,
             "finer ones came to nearly the same (between t = 4 and 4.1, 8, 9 with finer ones): what the "
             "step adds "
             "cannot be determined, nor how right the series are. Take shorter steps before anything else."));
    // One cut among many steps is no matter.
    count(base, 1, 1);
    count(finer, 2, 2);
    for (std::size_t i = 50; i <= 100; ++i) ++base.steps_at[i];
    CHECK(study.has_finer_steps());
}

TEST_CASE("nothing is called sound, accurate or a fault before it was run", "[study]") {
    DeckStudy study;
    study.is_interrupted = true;
    CHECK_FALSE(study.is_accurate());
    CHECK(to_json(study, false)["sound"].is_null());
    // Stopped between the two turned runs.
    study = make_study({make_report("tip", 1e-3, 1e-3)});
    study.series[0].turned_difference = 0.1;
    CHECK(study.depends_on_orientation());
    study.is_interrupted = true;
    CHECK_FALSE(study.depends_on_orientation());
    CHECK(to_json(study, false)["orientation_judged"] == false);
    CHECK(to_json(study, false)["sound"].is_null());
}

TEST_CASE("turned runs that fail are a fault unless round-off can decide it", "[study]") {
    DeckStudy study = make_study({make_report("tip", 1e-3, 1e-3)});
    study.runs[2].failure = "the step from t = 0 failed";
    // It may grow: without another such run that is not known.
    CHECK_FALSE(study.is_orientation_judged());
    CHECK(study.is_sound());
    VariantRun more;
    more.variant = {VariantKind::turned_more, 0, "turned by 1e-6 rad more"};
    more.untried = "the turned run failed";
    study.runs.push_back(more);
    CHECK(study.is_sound());
    CHECK(says(study,
               "A run that was turned in space failed, which round-off can decide where it grows or where "
               "steps are cut: nothing is said of the orientation."));
    CHECK_THAT(describe_properties(study), Catch::Contains("round-off: not known: the turned run failed\n"));
    CHECK_FALSE(study.knows_round_off());
    CHECK(to_json(study, false)["series"][0]["round_off"].is_null());
    study.runs.back().failure = "the step from t = 0 failed";
    CHECK_FALSE(study.is_sound());
    CHECK(says(study, "The motion depends on the model's orientation in space"));
    // Where steps are cut, or round-off has grown, or the two fail otherwise, it may be round-off.
    study.runs[0].rejected_steps = 1;
    CHECK(study.is_sound());
    study.runs[0].rejected_steps = 0;
    study.series[0].round_off = 3e-6;
    CHECK(study.is_sound());
    study.series[0].round_off = 1e-6;
    CHECK_FALSE(study.is_sound());
    study.runs.back().is_cut_alike = false;
    CHECK(study.is_sound());
    CHECK(says(study, "A run that was turned in space failed"));
    CHECK_FALSE(says(study, "other steps were taken"));
    study.runs.back().is_cut_alike = true;
    study.series[0].round_off = 0.0;
    study.runs[2].failure = study.runs.back().failure = study.runs.back().untried = "";
    CHECK(study.knows_round_off());
    CHECK(to_json(study, false)["series"][0]["round_off"] == 0.0);
    CHECK_THAT(describe_properties(study), Catch::Contains("round-off: differs by 0.0e+00\n"));
}
