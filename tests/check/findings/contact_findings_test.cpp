#include "check/findings/contact_findings.hpp"

#include <algorithm>

#include "check/mesh_frequencies.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

std::string wire(const std::string& name, const std::string& from, const std::string& to, int elements = 20) {
    return "[rod." + name + "]\nsection = \"s\"\nline = { from = " + from + ", to = " + to +
           " }\nelements = " + std::to_string(elements) + "\norder = 2\n";
}

Problem read_wires(const std::string& rest) {
    return read(
        "[section.s]\nshape = { circle = { radius = 0.01 } }\n"
        "material = { E = 1e9, nu = 0.3, density = 1000 }\n" +
        rest + "[analysis]\nkind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\n");
}

std::string findings(const std::string& rest, Severity severity = Severity::note) {
    const Problem problem = read_wires(rest);
    std::string text;
    for (const Finding& finding : examine_contact(problem.model, problem.analysis())) {
        if (finding.severity == severity) text += finding.message + "\n";
    }
    return text;
}

const std::string floor = "[obstacle.floor]\nplane = { point = [0, 0, 0], normal = [0, 0, 1] }\n";
const std::string level = wire("a", "[0, 0, 1]", "[1, 0, 1]");

}  // namespace

TEST_CASE("Check: rods that are clear of all call for no words", "[check][touch]") {
    CHECK(findings(floor + level).empty());
    CHECK(findings(level).empty());
}

TEST_CASE("Check: what overlaps is an error, the deepest named first", "[check][touch]") {
    const std::string heap = floor + "[contact]\n" + level + wire("b", "[0, 0.015, 1]", "[1, 0.016, 1]") +
                             wire("c", "[0, 5, 0.004]", "[1, 5, 0.008]") +
                             wire("d", "[0, 7, 0.003]", "[1, 7, 0.004]");
    const std::string errors = findings(heap, Severity::error);
    CHECK_THAT(
        errors,
        Contains("at the start d@0 is 0.007 deep in obstacle \"floor\"; expected a gap, as small as you "
                 "like; 2 more pairs overlap: c and floor by 0.006, a and b by 0.005\n"));
    CHECK(std::ranges::count(errors, '\n') == 1);
}

TEST_CASE("Check: a rod outside of a pipe that should hold it has no frequencies", "[check][touch]") {
    const std::string pipe =
        "[obstacle.pipe]\ntube = { arc = { from = [1, 0, 0], centre = [0, 0, 0], axis = [0, 0, 1], angle = "
        "-1 }, "
        "radius = 0.5, side = \"inside\" }\n[contact]\nskin = 0.5\n";
    const std::string rod = wire("a", "[0, 0, 0]", "[10, 0, 0]", 4);
    CHECK_THAT(findings(pipe + rod, Severity::error), Contains("deep in obstacle \"pipe\""));
    CHECK_FALSE(find_mesh_frequencies(read_wires(pipe + rod).model));
    CHECK(find_mesh_frequencies(read_wires(rod).model));
}

TEST_CASE("Check: what touches already at the start", "[check][touch]") {
    const std::string text = findings(floor + wire("a", "[0, 0, 0.01015]", "[1, 0, 0.01015]", 4));
    CHECK_THAT(text,
               Contains("within the skin at the start, so that they push each other: 9 places of rods and "
                        "obstacles; the least gap is 0.00015\n"));
}

TEST_CASE("Check: what contact alone is to hold in statics", "[check][touch]") {
    const auto all = [&](const std::string& rest, const std::string& kind = "static") {
        const Problem problem = read(
            "[section.s]\nshape = { circle = { radius = 0.01 } }\n"
            "material = { E = 1e9, nu = 0.3, density = 1000 }\n" +
            rest + "[analysis]\nkind = \"" + kind + "\"\n" +
            (kind == "static" ? "" : "end_time = 1\ntime_step = 0.1\n"));
        std::string text;
        for (const Finding& finding : examine_model(problem.model, problem.analysis())) {
            if (finding.severity == Severity::warning) text += "warning: " + finding.message + "\n";
            if (finding.severity == Severity::error) text += "error: " + finding.message + "\n";
            if (finding.severity == Severity::note) text += finding.message + "\n";
        }
        return text;
    };
    const std::string advice =
        ": a static analysis has no stiffness for that until it touches; use kind = \"dynamic\", support it, "
        "or "
        "start within the skin\n";
    const std::string clamp = "[[support]]\nat = \"a.start\"\nfix = \"all\"\n";
    CHECK_THAT(
        all(floor + level),
        Contains("warning: rod a touches nothing at the start, and contact alone is to hold it" + advice));
    CHECK_THAT(all(floor + level, "dynamic"), !Contains("contact alone"));
    CHECK_THAT(all(floor + level + clamp), !Contains("contact alone"));
    const std::string near = wire("a", "[0, 0, 0.01015]", "[1, 0, 0.01015]", 4);
    CHECK_THAT(all(floor + near), Contains("contact alone holds rod a, from the first step on"));
    CHECK_THAT(all(floor + near), !Contains("warning: rod"));
    std::string heap = floor;
    for (int i = 0; i < 6; ++i) {
        const std::string y = std::to_string(i);
        heap += wire("w" + y, "[0, " + y + ", 1]", "[1, " + y + ", 1]", 2);
    }
    CHECK_THAT(
        all(heap),
        Contains("warning: rod w0, rod w1, rod w2, rod w3 and 2 more touch nothing at the start, and contact "
                 "alone is to hold them" +
                 advice));
    // What touches nothing at all is not to be held by it.
    CHECK_THAT(
        all(floor + level + wire("b", "[0, 1, 1]", "[1, 1, 1]") + "[contact]\nrods = \"b\"\n"),
        Contains("error: rod a can move and turn in every direction; a static analysis needs supports"));
}

TEST_CASE("Check: elements that are long for the bend of contact", "[check][touch]") {
    const std::string drum =
        "[obstacle.drum]\ncylinder = { from = [0, -1, 0], to = [0, 1, 0], radius = 0.1 }\n";
    CHECK(findings(drum + wire("a", "[-1, 0, 0.2]", "[1, 0, 0.2]", 40)).empty());
    // Two thirds of the kink of a circle, (L/R)³/16, are left by the higher terms.
    CHECK_THAT(
        findings(drum + wire("a", "[-1, 0, 0.2]", "[1, 0, 0.2]", 10)),
        Contains("elements of \"a\" are 20 radii long: bent to a radius of 0.11, as contact can bend them, "
                 "they meet at kinks of "));
    // A floor bends nothing, nor does a hollow.
    CHECK(findings(floor + wire("a", "[-1, 0, 0.2]", "[1, 0, 0.2]", 2)).empty());
    CHECK(findings("[obstacle.pipe]\ncylinder = { from = [0, 0, 0], to = [1, 0, 0], radius = 0.1, side = "
                   "\"inside\" }\n" +
                   wire("a", "[0, 0, 0]", "[1, 0, 0]", 2))
              .empty());
}

TEST_CASE("Check: speeds of several radii a step", "[check][touch]") {
    const std::string fast = floor + level + "[[initial]]\non = \"a\"\nvelocity = [0, 0, -0.4]\n";
    CHECK_THAT(findings(fast), Contains("moves by 4 radii in a step at the start"));
    CHECK_THAT(findings(fast), Contains("time_step = 0.01 moves it by 0.4"));
    CHECK(findings(floor + level + "[[initial]]\non = \"a\"\nvelocity = [0, 0, -0.04]\n").empty());
}

TEST_CASE("Check: rods that are connected do not touch there", "[check][touch]") {
    const std::string corner =
        level + wire("b", "[1, 0, 1]", "[1, 1, 1]") + "[[connect]]\npoints = [\"a.end\", \"b.start\"]\n";
    CHECK_THAT(
        findings("[contact]\n" + corner),
        Contains("where rods are connected they do not touch, within 0.0318 of the connection along them: 1 "
                 "pair of rods\n"));
    CHECK(findings(floor + corner).empty());
}

}  // namespace gxrod::test
