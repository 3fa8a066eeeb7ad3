#include <fmt/ranges.h>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "check/model_examination.hpp"
#include "deck/decks.hpp"
#include "results/file/hdf5_reader.hpp"
#include "run/run.hpp"
#include "run/summary_json.hpp"
#include "tools/catch.hpp"

// Whatever is to be known before results are trusted is in one list, of the run, its summary and its file.

namespace gxrod::test {
namespace {

using Catch::Contains;

struct Ran {
    RunSummary summary;
    std::string in_file;  // what the attribute `warnings` has
};

Ran run(const std::string& deck) {
    const Problem problem = read(deck);
    RunRequest request{problem};
    request.examined = examine_stages(problem.model, problem.stages);
    const ScratchFile file("run.vtkhdf", "");
    request.results = ResultsFileOptions{file.path(), Existing::replace};
    Ran ran{run_analysis(request), ""};
    ran.in_file = Hdf5Reader(file.path()).text_attribute("/", "warnings");
    return ran;
}

// The run warns of this, once, in all of its places.
void check_warns(const std::string& deck, const std::string& words) {
    const Ran ran = run(deck);
    INFO(ran.in_file);
    const std::vector<std::string>& warnings = ran.summary.warnings;
    CHECK(std::ranges::count_if(
              warnings, [&](const std::string& one) { return one.find(words) != std::string::npos; }) == 1);
    CHECK(ran.in_file == fmt::format("{}", fmt::join(warnings, "\n")));
    CHECK(describe_summary(ran.summary, "x.toml", "x.vtkhdf")["warnings"].get<std::vector<std::string>>() ==
          warnings);
}

// Between the steps, and the stages in them.
const std::string pulse = "t > 0.23 && t < 0.25 ? 1 : 0";
const std::string bump = "exp(-((t-0.24)/0.005)^2)";

std::string quasi(const std::string& deck) {
    return replaced(deck, "kind = \"dynamic\"", "kind = \"quasi-static\"");
}

const std::string clamp = "[[support]]\nat = \"r.start\"\nfix = \"all\"\n";

}  // namespace

TEST_CASE("What acts between steps only is a warning of the run", "[issues]") {
    const std::string load = "[[load]]\nat = \"r.end\"\nforce = [0, 0, \"" + pulse + "\"]\n";
    const std::string words =
        "load[0].force[2]: between t = 0 and 0.8 steps of 0.1 give it the integral 0 over time";
    check_warns(rod_deck + clamp + load, words);
    check_warns(quasi(rod_deck) + clamp + load, words);
    // Of a later stage, too.
    const std::string stages = replaced(rod_deck,
                                        "[analysis]\nkind",
                                        "[[stage]]\nname = \"first\"\nkind = \"static\"\n[[stage]]\nname = "
                                        "\"then\"\nkind");
    check_warns(stages + clamp + load, "stage then: " + words);
    // Relatives: what moves, and what strains.
    check_warns(
        rod_deck + "[[support]]\nat = \"r.start\"\nfix = [\"x\", \"y\", \"rotation\"]\nmove = { z = \"" +
            bump + "\" }\n",
        "the [[support]] at r.start moves z: between t = 0 and 0.8 steps of 0.1 give it the integral ");
    check_warns(
        quasi(rod_deck) +
            "[[support]]\nat = \"r.start\"\nfix = [\"x\", \"y\", \"rotation\"]\nmove = { z = \"" + bump +
            "\" }\n",
        "the [[support]] at r.start moves z: between t = 0 and 0.8 steps of 0.1 give it the integral ");
    check_warns(
        rod_deck + clamp + "[[actuation]]\non = \"r\"\ncurvature = [0, \"0.01*(" + pulse + ")\", 0]\n",
        "actuation[0].curvature[1]: between t = 0 and 0.8 steps of 0.1 give it the integral ");
    // Steps that meet it are not warned of.
    CHECK(run(replaced(rod_deck, "steps = 10", "steps = 1000") + clamp + load).summary.warnings.empty());
}

TEST_CASE("What energies and Newton's tolerance say is in the list of warnings", "[issues]") {
    // Spun so fast that a step turns it by 5 rad.
    const std::string top = body_deck + "integrator = \"newmark-simplified\"\n[[initial]]\non = \"top\"\n";
    const std::string whirl =
        "[spring.k]\nbetween = [\"top\", \"ground\"]\nat_b = [1, 0, 0]\nstiffness = 1e4\nlength = 0.5\n";
    check_warns(top + "velocity = [0, 3, 0]\n" + whirl, "the energy does not balance");
}

TEST_CASE("Mesh errors that check finds are warnings of the run", "[issues]") {
    const std::string bent =
        replaced(replaced(rod_deck,
                          "line = { from = [0, 0, 0], to = [10, 0, 0] }",
                          "arc = { from = [0, 0, 0], through = [5, 5, 0], to = [10, 0, 0] }"),
                 "elements = 10",
                 "elements = 2");
    check_warns(bent + clamp + "[[load]]\nat = \"r.end\"\nforce = [0, 0, 1e-3]\n", "rod r is bent by up to");
}

}  // namespace gxrod::test
