#include <limits>

#include "tools/catch.hpp"
#include "verification/made_studies.hpp"

using namespace gxrod;
using namespace gxrod::test;

TEST_CASE("what is right is said to be, and then nothing is asked for", "[study]") {
    const DeckStudy study = make_study({make_report("tip", 1e-3, 8e-3)});
    CHECK(judge(study) == std::vector<std::string>{"All series are right to 1 % of their largest change."});
    CHECK(study.is_sound());
    CHECK(study.is_accurate());
}

TEST_CASE("if finer steps are not finer, nothing is said of errors", "[study]") {
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
        "ones): what the step adds cannot be determined, nor how right the series are. Take more than 90 "
        "steps before anything else."));
    CHECK(says(study,
               "Steps were cut, and the error of that is not known: nor is whether turning the model in "
               "space changes its motion by more."));
    CHECK_THAT(describe_properties(study), Catch::Contains("turned in space by 0 rad: differs by 0.0e+00\n"));
    CHECK_FALSE(says(study, "ight to 1 %"));
    CHECK_THAT(describe_errors(study),
               Catch::Contains("          -      -    1.0e-03   2.00          ?         ?\n"));
    CHECK(to_json(study, false)["series"][0]["relative_error"].dump() == "null");
    // What turning can change is then not known; if no step was cut, the mesh alone shows it.
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
        "finer ones): what they add cannot be determined, nor how right the series are. Choose a smaller "
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

TEST_CASE("where no finer run reached its end, errors are not known", "[study]") {
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

TEST_CASE("round-off is reported, and no refinement against it", "[study]") {
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

TEST_CASE("if nothing changes, there is no scale to judge by", "[study]") {
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

TEST_CASE("what finer runs do not show is not called right", "[study]") {
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

TEST_CASE("energy out of balance and failed runs are reported", "[study]") {
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

TEST_CASE("tables and JSON have what the study has", "[study]") {
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
