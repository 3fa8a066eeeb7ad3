#include <catch2/catch.hpp>
#include <limits>

#include "verification/deck_study_text.hpp"

using namespace gxrod;

namespace {

ErrorEstimate make_estimate(double size, double order, double expected = 2.0) {
    const double fall = std::exp2(-order);
    const double first = size * (1.0 - fall);
    return estimate_error({{0.0, first}, {0.0, first * fall}}, expected, 1e-12);
}

SeriesReport make_report(const std::string& point, double step, double mesh) {
    SeriesReport report;
    report.series = {point, "position", 0, Quantity::position, Turning::vector};
    report.scale = 2.0;
    report.steps = make_estimate(2.0 * step, 2.0);
    report.mesh = make_estimate(2.0 * mesh, 2.0);
    report.error = 2.0 * (step + mesh);
    report.trusted_until = report.error <= 0.02 ? 1.0 : 0.25;
    return report;
}

DeckStudy make_study(const std::vector<SeriesReport>& series) {
    DeckStudy study;
    for (const DeckVariant& variant : {DeckVariant{VariantKind::as_it_is, 0, "as it is"},
                                       DeckVariant{VariantKind::finer_steps, 1, "half the step"},
                                       DeckVariant{VariantKind::turned, 0, "turned in space"},
                                       DeckVariant{VariantKind::resumed, 0, "stopped midway and resumed"},
                                       DeckVariant{VariantKind::two_threads, 0, "two threads"}}) {
        VariantRun run;
        run.variant = variant;
        run.books.largest_energy = 10.0;
        run.books.largest_energy_error = 0.01;
        study.runs.push_back(run);
    }
    study.series = series;
    return study;
}

bool says(const DeckStudy& study, const std::string& part) {
    for (const std::string& sentence : judge(study)) {
        if (sentence.find(part) != std::string::npos) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("what is right is said to be, and then nothing is asked for", "[verification]") {
    const DeckStudy study = make_study({make_report("tip", 1e-3, 8e-3)});
    CHECK(judge(study) == std::vector<std::string>{"All series are right to 1 % of their largest change."});
    CHECK(study.is_sound());
    CHECK(study.is_accurate());
}

TEST_CASE("what is not is named, with its error, until when it is, and what to refine", "[verification]") {
    const DeckStudy study = make_study({make_report("root", 1e-4, 1e-4), make_report("tip", 0.002, 0.08)});
    CHECK_FALSE(study.is_accurate());
    CHECK(says(study, "Right to 1 % of their largest change: root position."));
    CHECK(says(study, "Not right to 1 %: tip position (8.2 %, right up to t = 0.25)."));
    // 0.08 / 4² = 0.005, half of the tolerance.
    CHECK(says(study,
               "The mesh adds 8 % to tip position. 4 times as many elements would bring that to 0.5 %."));
    CHECK_FALSE(says(study, "The step adds"));
    DeckStudy other = make_study({make_report("tip", 0.03, 0.0)});
    CHECK(says(other,
               "The step adds 3 % to tip position. A step 3 times as short would bring that to 0.33 %."));
    other.is_adaptive = true;
    CHECK(says(other,
               "Steps 3 times as short, with 1/81 of the tolerance and 1/3 of min_step, max_step and the "
               "first step, would bring that to 0.33 %."));
    other.series[0].order_difference = 0.06;
    CHECK_FALSE(says(other, "next order"));
    other = make_study({make_report("tip", 0.0, 0.05)});
    other.series[0].order_difference = 0.06;
    CHECK(says(other, "Elements of the next order change tip position by 3 %."));
}

TEST_CASE("of errors that are out of reach no refinement is named", "[verification]") {
    CHECK(
        says(make_study({make_report("tip", 43.4, 0.0)}),
             "The step adds 4300 % to tip position. It falls too slowly to say what would mend that: refine "
             "the step and ask again."));
    for (const double share : {0.9951, 1.0})
        CHECK(says(make_study({make_report("tip", share, 0.0)}), "The step adds 100 % to tip position."));
    CHECK(says(make_study({make_report("tip", 0.9949, 0.0)}), "The step adds 99 % to tip position."));
    CHECK(says(make_study({make_report("tip", 1234.5, 0.0)}),
               "The step adds more than 100000 % to tip position."));
}

TEST_CASE("errors that do not fall, or too slowly, are told", "[verification]") {
    DeckStudy study = make_study({make_report("tip", 0.3, 0.0)});
    study.series[0].steps = estimate_error({{0.1}, {0.1}}, 2.0, 1e-12);
    CHECK(says(study, "Errors do not fall with the step (tip position: 0.1, 0.1)"));
    study.series[0].steps = make_estimate(0.1, 1.0);
    CHECK(says(study, "Errors fall with the step with order 1.0, less than the scheme's 2 (tip position)"));
    study = make_study({make_report("tip", 0.0, 0.3)});
    study.series[0].mesh = estimate_error({{0.1}, {0.1}}, 2.0, 1e-12);
    CHECK(says(study, "Errors do not fall with the mesh (tip position: 0.1, 0.1)"));
}

TEST_CASE("what must not be is called a fault", "[verification]") {
    DeckStudy study = make_study({make_report("tip", 1e-3, 1e-3)});
    study.series[0].turned_difference = 0.01;
    CHECK_FALSE(study.is_sound());
    CHECK(says(study, "The motion depends on how the model stands in space"));
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

TEST_CASE("where finer steps are no finer, nothing is said of errors", "[verification]") {
    DeckStudy study = make_study({make_report("tip", 1e-9, 1e-3)});
    CHECK(study.is_accurate());
    study.runs[0].steps = 90;
    study.runs[0].rejected_steps = 5;
    study.runs[1].steps = 120;
    CHECK(study.has_finer_steps());
    study.runs[1].steps = 110;
    CHECK_FALSE(study.has_finer_steps());
    study.series[0].steps = {};
    study.series[0].error = std::numeric_limits<double>::infinity();
    CHECK_FALSE(study.is_accurate());
    CHECK(study.is_sound());
    CHECK(says(
        study,
        "Steps that did not converge were cut, and finer ones came to nearly the same (90, 110 with finer "
        "ones): what the step adds cannot be told, nor how right the series are. Take more than 90 "
        "steps before anything else."));
    CHECK(says(study,
               "Steps were cut, and the error of that is not known: nor is whether turning the model in "
               "space changes its motion by more."));
    CHECK_THAT(describe_properties(study), Catch::Contains("turned in space by 0 rad: differs by 0.0e+00\n"));
    CHECK_FALSE(says(study, "ight to 1 %"));
    CHECK_THAT(describe_errors(study),
               Catch::Contains("          -      -    1.0e-03   2.00          ?         ?\n"));
    CHECK(to_json(study, false)["series"][0]["relative_error"].dump() == "null");
    // What turning may change is then not known; where no step was cut, the mesh alone tells.
    study.series[0].turned_difference = 3e-3;
    CHECK(study.is_sound());
    study.runs[0].rejected_steps = 0;
    CHECK_FALSE(study.is_sound());
    study.series[0].turned_difference = 1e-3;
    CHECK(study.is_sound());
    study.is_adaptive = true;
    CHECK(says(
        study,
        "Something else than the tolerance sets the steps, such as what Newton's method needs (90, 110 with "
        "finer ones): what they add cannot be told, nor how right the series are. Choose a smaller "
        "tolerance before anything else."));
    study.depends_on_steps = false;
    CHECK(study.has_finer_steps());
    study.depends_on_steps = true;
    // Of runs that failed nothing is counted.
    VariantRun failed;
    failed.variant = {VariantKind::finer_steps, 2, "a quarter of the step"};
    failed.failure = "the step from t = 0.5 failed";
    study.runs.push_back(failed);
    CHECK(says(study, "(90, 110 with finer ones): what they add"));
    study.runs.pop_back();
    study.runs[1].failure = "the step from t = 0 failed";
    CHECK(study.has_finer_steps());
    // A quarter of the step must then show both levels' growth.
    VariantRun quarter;
    quarter.variant = {VariantKind::finer_steps, 2, "a quarter of the step"};
    quarter.steps = 140;
    study.runs.push_back(quarter);
    CHECK_FALSE(study.has_finer_steps());
    study.runs.back().steps = 141;
    CHECK(study.has_finer_steps());
}

TEST_CASE("where no finer run reached its end, errors are not known", "[verification]") {
    DeckStudy study = make_study({make_report("tip", 0.0, 0.03)});
    for (const VariantRun& run : study.runs) study.variants.push_back(run.variant);
    CHECK(study.knows_errors());
    study.runs[1].failure = "the step from t = 0 failed";
    CHECK(study.lacks(VariantKind::finer_steps));
    CHECK_FALSE(study.lacks(VariantKind::finer_mesh));
    CHECK_FALSE(study.knows_errors());
    study.series[0].steps = {};
    study.series[0].error = std::numeric_limits<double>::infinity();
    CHECK_FALSE(study.is_accurate());
    CHECK(says(study,
               "How right the series are is not known, as no such run has reached its end: half the step."));
    CHECK_FALSE(says(study, "ight to 1 %"));
    CHECK(says(study, "The mesh adds 3 % to tip position."));
    CHECK_THAT(describe_errors(study),
               Catch::Contains("          -      -    3.0e-02   2.00          ?         ?\n"));
    // Turning may change as much as is known of errors, and nothing is known of those of cuts.
    study.series[0].turned_difference = 0.05;
    CHECK(study.is_sound());
    study.series[0].turned_difference = 0.07;
    CHECK_FALSE(study.is_sound());
    study.runs[0].rejected_steps = 1;
    CHECK(study.is_error_of_cuts_unknown());
    CHECK(study.is_sound());
    // Nor if the user ended the study before.
    study.runs.resize(1);
    study.is_interrupted = true;
    CHECK_FALSE(study.knows_errors());
    CHECK_FALSE(study.is_accurate());
}

TEST_CASE("a turned model may differ by the error, and where its steps are cut elsewhere by anything",
          "[verification]") {
    DeckStudy study = make_study({make_report("tip", 1e-3, 1e-3)});
    study.series[0].turned_difference = 0.9 * study.series[0].error;
    CHECK(study.is_sound());
    study.series[0].turned_difference = 1.1 * study.series[0].error;
    CHECK_FALSE(study.is_sound());
    CHECK(says(study,
               "The motion depends on how the model stands in space, by more than its errors. If no "
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

TEST_CASE("of a model that hardly moves, nothing is said of its orientation", "[verification]") {
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

TEST_CASE("round-off is told, and no refinement against it", "[verification]") {
    DeckStudy study = make_study({make_report("root", 1e-3, 1e-3), make_report("tip", 1e-3, 1e-3)});
    SeriesReport& tip = study.series[1];
    tip.round_off = 0.02;
    CHECK(says(study,
               "Round-off alone changes tip position by 1 %: the model lets it have no more digits, whatever "
               "the step "
               "and mesh."));
    tip.round_off = 0.0099;
    CHECK_FALSE(says(study, "Round-off"));
    // Within round-off, step and mesh have no order, and nothing is asked of them.
    tip.round_off = 0.5;
    tip.error = 0.5;
    tip.steps = estimate_error({{0.1}, {0.2}}, 2.0, 5.0);
    tip.mesh = estimate_error({{0.4}, {0.1}}, 2.0, 5.0);
    CHECK(tip.steps.is_round_off);
    CHECK_FALSE(says(study, "Errors do not fall"));
    CHECK_FALSE(says(study, "adds"));
    CHECK(says(study, "Not right to 1 %: tip position (25 %, right up to t = 1)."));
    // Nor is the orientation to blame, up to a hundred times what was seen.
    tip.turned_difference = 49.0;
    CHECK(study.is_sound());
    tip.turned_difference = 51.0;
    CHECK_FALSE(study.is_sound());
}

TEST_CASE("where nothing changes there is nothing to judge by", "[verification]") {
    DeckStudy study = make_study({make_report("tip", 1e-3, 1e-3), make_report("root", 1e-3, 1e-3)});
    SeriesReport& root = study.series[1];
    root.scale = 0.0;
    root.is_still = true;
    root.round_off = 1e-17;
    root.error = 1e-16;
    CHECK_FALSE(study.is_accurate());
    CHECK(judge(study) ==
          std::vector<std::string>{
              "Right to 1 % of their largest change: tip position.",
              "Not to be judged, as nothing of the kind changes but by round-off: root position."});
    CHECK_THAT(describe_errors(study), Catch::Contains("root position             0          ?   2.00"));
    CHECK(to_json(study, false)["series"][1]["relative_error"].dump() == "null");
    root.error = 0.0;
    CHECK(study.is_accurate());
    root.error = 1e-3;
    CHECK(says(study, "Not right to 1 %: root position (it changes in finer runs alone)."));
}

TEST_CASE("where steps are cut in a part of the run alone, finer ones must be more there, too",
          "[verification]") {
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
    CHECK(says(study,
               "finer ones came to nearly the same (between t = 4 and 4.1, 8, 9 with finer ones): what the "
               "step adds "
               "cannot be told, nor how right the series are. Take shorter steps before anything else."));
    // One cut among many steps is no matter.
    count(base, 1, 1);
    count(finer, 2, 2);
    for (std::size_t i = 50; i <= 100; ++i) ++base.steps_at[i];
    CHECK(study.has_finer_steps());
}

TEST_CASE("what finer runs do not tell is not called right", "[verification]") {
    DeckStudy study = make_study({make_report("tip", 1e-3, 1e-3), make_report("root", 1e-3, 1e-3)});
    study.series[1].error = std::numeric_limits<double>::infinity();
    CHECK_FALSE(study.is_accurate());
    CHECK(judge(study).at(1) ==
          "Not known, as the finer runs do not come nearer to each other, or elements of the next order show "
          "what "
          "they miss: root position.");
    CHECK_THAT(describe_errors(study), Catch::Contains("          ?         ?\nchange"));
    study.unrefined_rods = {"cable"};
    CHECK_FALSE(study.knows_errors());
    CHECK(says(study, "not known, as the elements of rods from mesh files (cable) cannot be refined here"));
}

TEST_CASE("small errors ask for nothing, however they fall", "[verification]") {
    DeckStudy study = make_study({make_report("tip", 0.0, 0.3)});
    study.series[0].steps = estimate_error({{2e-4}, {2e-4}}, 2.0, 1e-12);
    CHECK_FALSE(says(study, "Errors do not fall"));
    study.series[0].steps = estimate_error({{2e-2}, {2e-2}}, 2.0, 1e-12);
    CHECK(says(study, "Errors do not fall with the step"));
}

TEST_CASE("nothing is called sound, accurate or a fault before it was run", "[verification]") {
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

TEST_CASE("turned runs that fail are a fault unless round-off can decide it", "[verification]") {
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
    CHECK_THAT(describe_properties(study), Catch::Contains("round-off: not told: the turned run failed\n"));
    CHECK_FALSE(study.knows_round_off());
    CHECK(to_json(study, false)["series"][0]["round_off"].is_null());
    study.runs.back().failure = "the step from t = 0 failed";
    CHECK_FALSE(study.is_sound());
    CHECK(says(study, "The motion depends on how the model stands in space"));
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

TEST_CASE("statics: the load steps must not matter", "[verification]") {
    DeckStudy study = make_study({make_report("tip", 0.05, 0.0)});
    study.is_static = true;
    CHECK(says(study, "The state depends on the load steps by 5 % (tip position)."));
    CHECK(says(study, "(5 %, right up to load factor 0.25)"));
    CHECK_FALSE(says(study, "The step adds"));
    study.series[0].steps = estimate_error({{0.0}, {0.0}}, 1.0, 1e-12);
    CHECK_FALSE(says(study, "The state depends"));
}

TEST_CASE("energy out of balance, and runs that failed, are told", "[verification]") {
    DeckStudy study = make_study({make_report("tip", 1e-3, 1e-3)});
    study.runs[0].books.largest_energy_error = 0.5;
    CHECK(
        says(study, "Energy is out of balance by 5 % of its largest value; halve the step until it is not."));
    study.runs[1].books.largest_energy_error = 0.6;
    CHECK(says(study,
               "Energy is out of balance by 5 % of its largest value; half the step does not mend that."));
    study.runs[1].books.largest_energy_error = 0.1;
    study.is_adaptive = true;
    CHECK(says(study, "of its largest value; take a smaller tolerance until it is not."));
    study.is_static = true;
    CHECK_FALSE(says(study, "Energy"));
    study.is_static = false;
    study.runs[1].failure = "the step from t = 0 failed";
    CHECK(says(study,
               "The run \"half the step\" failed, so that estimates lack it: the step from t = 0 failed."));
    CHECK(says(study, "Energy is out of balance by 5 % of its largest value."));
}

TEST_CASE("tables and JSON have what the study has", "[verification]") {
    DeckStudy study = make_study({make_report("tip", 1e-3, 8e-3)});
    study.times = {0.0, 1.0};
    study.base_rows = {{{0, 0, 0, 0}, {2, 0, 0, 0}}};
    const std::string errors = describe_errors(study);
    CHECK_THAT(errors, Catch::Contains("tip position"));
    CHECK_THAT(errors, Catch::Contains("1.0e-03   2.00    8.0e-03   2.00    9.0e-03       all"));
    const std::string properties = describe_properties(study);
    CHECK_THAT(properties,
               Catch::Contains("imbalance by the largest energy: 1.0e-03 (with half the step 1.0e-03)"));
    CHECK_THAT(properties, Catch::Contains("two threads: the same to the last bit\n"));
    CHECK_THAT(properties, Catch::Contains("turned in space by 0 rad: the same, turned, to 0.0e+00\n"));
    const nlohmann::ordered_json json = to_json(study, false);
    CHECK(json["series"][0]["point"] == "tip");
    CHECK(json["series"][0]["relative_error"] == Approx(9e-3));
    CHECK(json["series"][0]["steps"]["order"] == Approx(2.0));
    CHECK(json["runs"].size() == 5);
    CHECK(json["runs"][0]["failure"].is_null());
    CHECK(json["sound"] == true);
    CHECK_FALSE(json.contains("times"));
    const nlohmann::ordered_json curves = to_json(study, true);
    CHECK(curves["times"].size() == 2);
    CHECK(curves["series"][0]["values"][1][0] == 2.0);
    CHECK(curves["series"][0]["mesh"]["errors"].size() == 2);
    study.runs[3].untried = "no step is left to resume with";
    CHECK_THAT(describe_properties(study),
               Catch::Contains("stopped midway and resumed: not tried: no step is left to resume with\n"));
    CHECK(to_json(study, false)["runs"][3]["untried"] == "no step is left to resume with");
    study.runs[3].untried = "";
    study.runs[3].failure = "it differs";
    CHECK_THAT(describe_properties(study),
               Catch::Contains("stopped midway and resumed: NOT the same: it differs\n"));
}
