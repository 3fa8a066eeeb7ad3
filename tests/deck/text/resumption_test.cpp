#include "deck/text/resumption.hpp"

#include "deck/decks.hpp"
#include "machine/file_error.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string run_deck = rod_deck + R"([[load]]
at = "r.end"
force = [1, 0, "2*t"]
[[history]]
name = "tip"
at = "r.end"
quantities = ["position"]
)";

DeckRecord record_of(const std::string& deck) { return read(deck).record; }

// Faults of a deck that is to resume where the run of `before` stopped.
std::string faults_against(const std::string& before, const std::string& now) {
    const ScratchFile file("x.toml", now);
    try {
        read_resumption(record_of(before), file.path(), {});
    } catch (const DeckError& error) {
        std::string text;
        for (const DeckFault& fault : error.faults) {
            text += std::to_string(fault.line) + ":" + std::to_string(fault.column) + ": " + fault.key +
                    ": " + fault.message + "\n";
        }
        return text;
    }
    return "";
}

std::string faults_of_change(const std::string& old_text, const std::string& new_text) {
    return faults_against(run_deck, replaced(run_deck, old_text, new_text));
}

}  // namespace

TEST_CASE("A run can be resumed with another end, other steps and other output", "[deck][resume]") {
    CHECK(faults_of_change("end_time = 1.0", "end_time = 2") == "");
    CHECK(faults_of_change("steps = 10", "time_step = 0.05") == "");
    CHECK(faults_of_change("steps = 10",
                           "steps = 10\nnewton = { tolerance = 1e-10 }\nlinear_solver = \"umfpack\"") == "");
    CHECK(faults_of_change("steps = 10", "steps = 10\nintegrator = \"newmark-simplified\"") != "");
    CHECK(faults_against(run_deck, "title = \"T\"\nunits = \"m\"\n" + run_deck + "[output]\nevery = 3\n") ==
          "");
    CHECK(faults_of_change("[\"position\"]", "[\"velocity\"]") == "");
    CHECK(faults_of_change("name = \"tip\"", "name = \"top\"") == "");
    CHECK(faults_of_change("EA = 1e4", "EA = 10000") == "");
    CHECK(faults_of_change("[[history]]", "# words\n[[history]]") == "");
}

TEST_CASE("Every other difference is named with its place", "[deck][resume]") {
    CHECK(faults_of_change("EA = 1e4", "EA = 2e4") ==
          "2:20: section.s.stiffness.EA: the run to be resumed has 10000.0\n");
    CHECK(faults_of_change("elements = 10", "elements = 11") ==
          "7:12: rod.r.elements: the run to be resumed has 10\n");
    CHECK(faults_of_change("\"2*t\"", "\"3*t\"") ==
          "15:16: load[0].force[2]: the run to be resumed has \"2*t\"\n");
    CHECK(faults_of_change("steps = 10", "steps = 10\nbeta = 0.3") ==
          "13:1: analysis.beta: the run to be resumed has none\n");
    CHECK(faults_of_change("element = \"simo\"\n", "") ==
          "4:1: rod.r.element: missing; the run to be resumed has \"simo\"\n");
    CHECK(faults_against(run_deck, run_deck + "[[load]]\nat = \"r.end\"\nforce = [0, 0, 1]\n")
              .find("load: the run to be resumed has another one\n") != std::string::npos);
    CHECK(faults_of_change("at = \"r.end\"\nq", "at = \"r.start\"\nq") ==
          "18:6: history[0].at: the run to be resumed has \"r.end\"\n");
    CHECK(
        faults_of_change("{ from = [0, 0, 0], to = [10, 0, 0] }", "{ from = [0, 0, 0], to = [10, 0, 1] }") ==
        "6:41: rod.r.line.to[2]: the run to be resumed has 0\n");
}

TEST_CASE("A deck that makes another mesh is refused", "[deck][resume]") {
    const std::string two = replaced(
        run_deck,
        "[analysis]",
        "[rod.a]\nsection = \"s\"\nline = { from = [0, 5, 0], to = [10, 5, 0] }\nelements = 10\n[analysis]");
    const std::string rod_a =
        "[rod.a]\nsection = \"s\"\nline = { from = [0, 5, 0], to = [10, 5, 0] }\nelements = 10\n";
    const std::string swapped = replaced(replaced(two, rod_a, ""), "[rod.r]", rod_a + "[rod.r]");
    CHECK(faults_against(two, two) == "");
    CHECK(faults_against(two, swapped).find("makes another mesh than the run's") != std::string::npos);
    const std::string seen = "relative_to = \"r@0.37\"\n";
    CHECK(faults_against(
              run_deck,
              run_deck + "[[history]]\nname = \"b\"\nat = \"r.end\"\nquantities = \"position\"\n" + seen)
              .find("makes another mesh") != std::string::npos);
    CHECK_THROWS_AS(
        read_resumption(
            record_of(run_deck),
            "",
            {R"(history=[{name = "b", at = "r.end", relative_to = "r@0.37", quantities = "position"}])"}),
        DeckError);
}

TEST_CASE("An override that differs is named as it was given", "[deck][resume]") {
    try {
        read_resumption(record_of(run_deck), "", {"section.s.stiffness.EA=3", "analysis.end_time=5"});
        FAIL("nothing thrown");
    } catch (const DeckError& error) {
        CHECK(std::string(error.what()) ==
              "--set section.s.stiffness.EA=3: the run to be resumed has 10000.0");
    }
    const Problem longer = read_resumption(record_of(run_deck), "", {"analysis.end_time=5"});
    CHECK(dynamic_of(longer).end_time == 5.0);
}

TEST_CASE("A run is not resumed with another mesh", "[deck][resume]") {
    const std::string line =
        "Point(1) = {0, 0, 0};\nPoint(2) = {10, 0, 0};\nLine(1) = {1, 2};\n"
        "Transfinite Curve {1} = 4;\nPhysical Curve(\"cable\") = {1};\n";
    const ScratchFile mesh("a.geo", line);
    const std::string deck =
        replaced(replaced(rod_deck,
                          "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                          "mesh = { file = \"" + mesh.path().string() + "\", group = \"cable\" }"),
                 "elements = 10\n",
                 "");
    DeckRecord before = record_of(deck);
    const ScratchFile file("x.toml", deck);
    CHECK(read_resumption(before, file.path(), {}).model.nodes.size() == 4);
    before.meshes[0].bytes += "\n";
    CHECK_THROWS_WITH(read_resumption(before, file.path(), {}),
                      Catch::Contains("a.geo is another one than the run's"));
}

TEST_CASE("Models whose ties differ do not have the same mesh", "[deck][resume]") {
    const Model model =
        read(rod_deck +
             "[joint.one]\ntype = \"hinge\"\nbetween = [\"ground\", \"r.start\"]\naxis = [0, 0, 1]\n"
             "[joint.two]\ntype = \"hinge\"\nbetween = [\"ground\", \"r.end\"]\naxis = [0, 0, 1]\n"
             "[gear.g]\njoints = [\"one\", \"two\"]\nratio = 2\n"
             "[spring.strut]\nbetween = [\"ground\", \"r.end\"]\nat_a = [10, 1, 0]\nstiffness = 1\n")
            .model;
    const auto is_same_after = [&](const auto& change) {
        Model other = model;
        change(other);
        return have_same_mesh(model, other);
    };
    CHECK(is_same_after([](Model&) {}));
    CHECK_FALSE(is_same_after([](Model& m) { std::swap(m.gears[0].sides[0], m.gears[0].sides[1]); }));
    CHECK_FALSE(is_same_after([](Model& m) { m.gears[0].name = "h"; }));
    CHECK_FALSE(is_same_after([](Model& m) { m.springs[0].ends[0].arm.x() += 1.0; }));
    CHECK_FALSE(is_same_after([](Model& m) { m.joints[1].a.axes = m.joints[1].a.axes * 2.0; }));
}

}  // namespace gxrod::test
