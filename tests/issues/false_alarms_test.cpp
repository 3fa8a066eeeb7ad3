#include <fmt/format.h>

#include "check/model_examination.hpp"
#include "check/motions/unconnected_points.hpp"
#include "check/summaries/item_list.hpp"
#include "check/summaries/model_summary.hpp"
#include "check/summaries/rod_lines.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"

// Right decks that were refused or warned of, and what must be all the same.

namespace gxrod::test {
namespace {

// So many rods in a row that are one node each where they meet, `step` from one end to the next, each turned
// by `bend` against the one before, in the plane.
std::string row_of_rods(int count, double step, double bend) {
    std::string text = rod_deck.substr(0, rod_deck.find("[rod.r]"));
    Vec3 from = Vec3::Zero();
    for (int i = 0; i < count; ++i) {
        const double angle = bend * i;
        const Vec3 to = from + step * Vec3(std::cos(angle), std::sin(angle), 0.0);
        text += fmt::format(
            "[rod.p{}]\nsection = \"s\"\nline = {{ from = [{}, {}, 0], to = [{}, {}, 0] }}\nelements = 1\n",
            i,
            from[0],
            from[1],
            to[0],
            to[1]);
        if (i > 0) text += fmt::format("[[connect]]\npoints = [\"p{}.end\", \"p{}.start\"]\n", i - 1, i);
        from = to;
    }
    return text + rod_deck.substr(rod_deck.find("[analysis]"));
}

std::string thick_rods_of(const std::string& deck) { return describe_thick_rods(read(deck).model); }

std::string with_inertia(const std::string& inertia) {
    return replaced(body_deck, "inertia = [1, 1, 1]", "inertia = " + inertia);
}

std::vector<std::string> warnings_of(const Problem& problem) {
    std::vector<std::string> warnings;
    for (const Finding& finding : examine_model(problem.model, problem.analysis())) {
        if (finding.severity == Severity::warning) warnings.push_back(finding.message);
    }
    return warnings;
}

// Supports of a beam from 0 to 10 along x at both ends.
std::string on_supports(const std::string& fixed) {
    return rod_deck + "[[support]]\nat = \"r.start\"\nfix = " + fixed +
           "\n[[support]]\nat = \"r.end\"\nfix = " + fixed + "\n";
}

std::string with_velocity(const std::string& components) {
    return "[[initial]]\non = \"r\"\nvelocity = [" + components + "]\n";
}

}  // namespace

TEST_CASE("Rods that continue into each other are judged as one", "[issues]") {
    // The radius of gyration of the section is √0.06; a rod of length 0.5 alone has a slenderness of 2.
    CHECK(thick_rods_of(row_of_rods(1, 0.5, 0.0)) ==
          "rod p0 is thicker than long; are all lengths in one unit?");
    CHECK(thick_rods_of(row_of_rods(40, 0.5, 0.0)).empty());
    CHECK(thick_rods_of(row_of_rods(40, 0.5, 0.3)).empty());
    // Around a corner they do not continue.
    CHECK(thick_rods_of(row_of_rods(6, 0.5, M_PI / 2.0)) ==
          "rods p0, p1, p2, p3 and 2 more are thicker than long; are all lengths in one unit?");
    // The row may be too short, too: in millimetres, with a section in metres.
    CHECK(thick_rods_of(row_of_rods(3, 0.05, 0.0)) ==
          "rods p0, p1, p2 are thicker than long; are all lengths in one unit?");
}

TEST_CASE("A stub on a slender rod of its section is not a sign of mixed units", "[issues]") {
    const std::string stub =
        "[rod.stub]\nsection = \"s\"\nline = { from = [10, 0, 0], to = [10, 0, 0.1] }\nelements = 1\n";
    const std::string joined = "[[connect]]\npoints = [\"r.end\", \"stub.start\"]\n";
    CHECK(thick_rods_of(rod_deck + stub + joined).empty());
    CHECK(thick_rods_of(rod_deck + stub) == "rod stub is thicker than long; are all lengths in one unit?");
}

TEST_CASE("Of several rods at a node the straightest continues", "[issues]") {
    const std::string branches =
        "[rod.a]\nsection = \"s\"\nline = { from = [10, 0, 0], to = [14, 1, 0] }\nelements = 1\n"
        "[rod.b]\nsection = \"s\"\nline = { from = [10, 0, 0], to = [13, -2, 0] }\nelements = 1\n"
        "[[connect]]\npoints = [\"r.end\", \"a.start\", \"b.start\"]\n";
    const std::vector<double> lengths = measure_lines(read(rod_deck + branches).model);
    CHECK(lengths[0] == Approx(10.0 + std::sqrt(17.0)));
    CHECK(lengths[1] == lengths[0]);
    CHECK(lengths[2] == Approx(std::sqrt(13.0)));
}

TEST_CASE("What repeats in a model is summed up", "[issues]") {
    const Model model = read(row_of_rods(384, 0.5, 0.0)).model;
    long all = 0;
    long shortened = 0;
    std::string text;
    for (const ItemList& list : list_model(model)) {
        all += count_lines(describe(list, Detail::all));
        text += describe(list, Detail::shortened);
    }
    shortened = count_lines(text);
    CHECK(all > 384 * 5);
    CHECK(shortened < 30);
    CHECK_THAT(text, Catch::Contains("and 382 more rods; all 384: length 0.5 to 0.5, together 192\n"));
    CHECK_THAT(text, Catch::Contains("and 381 more connections\n"));
    // A few more are shown as well as counted.
    CHECK(describe({"things", {"a\n", "b\n", "c\n", "d\n"}}, Detail::shortened) == "a\nb\nc\nd\n");
    CHECK(describe({"things", {"a\n", "b\n", "c\n", "d\n", "e\n"}}, Detail::shortened) ==
          "a\nb\nand 3 more things\n");
}

TEST_CASE("Sentences that differ in names and numbers alone are summed up", "[issues]") {
    using Sentences = std::vector<std::string>;
    CHECK(sum_up_repeats({"note: rod.a1.y_axis: from [0, 1, 0]",
                          "note: rod.b.y_axis: from [0, -1.5e-3, 0]",
                          "note: nothing loads it",
                          "note: rod.c7.y_axis: from [1, 0, 0]"}) ==
          Sentences{"note: rod.a1.y_axis: from [0, 1, 0] (and 2 more like this)", "note: nothing loads it"});
    // Other words are another sentence, and the end of one is no name.
    CHECK(sum_up_repeats({"a stays.", "b stays."}) == Sentences{"a stays.", "b stays."});
}

TEST_CASE("An initial velocity that is round-off at a support is 0 there", "[issues]") {
    // sin(π) is 1.2e-16.
    const Problem problem = read(on_supports("\"position\"") + with_velocity("0, \"1e-3*sin(pi*s/10)\", 0"));
    CHECK(problem.model.nodes.back().velocity.isZero(0.0));
    // Of another rate than the rest it is a mistake as before.
    CHECK_THAT(faults_of(on_supports("\"position\"") + with_velocity("0, \"1e-3*sin(pi*s/10) + 1e-9\", 0")),
               Catch::Contains("a [[support]] fixes y at r.start; expected 0 along it, found 1e-09"));
    // Turns, with supports in axes of their own.
    CHECK(faults_of(
              on_supports("[\"x\", \"y\", \"z\", \"ry\", \"rx\"]\naxes = [[\"cos(1)\", \"sin(1)\", 0], "
                          "[\"-sin(1)\", \"cos(1)\", 0], [0, 0, 1]]") +
              "[[initial]]\non = \"r\"\nangular_velocity = [\"sin(pi*s/10)\", 0, \"cos(pi*s/10)\"]\n") == "");
}

TEST_CASE("Rods that meet agree on a velocity to round-off of the larger one", "[issues]") {
    const std::string second =
        "[rod.q]\nsection = \"s\"\nline = { from = [10, 0, 0], to = [20, 0, 0] }\nelements = 2\n"
        "[[connect]]\npoints = [\"r.end\", \"q.start\"]\n";
    const std::string rest = "[[initial]]\non = \"q\"\nvelocity = [0, 0, 0]\n";
    const std::string swinging = with_velocity("0, 0, \"sin(pi*s/10)\"");
    CHECK(faults_of(rod_deck + second + swinging + rest) == "");
    CHECK(faults_of(rod_deck + second + rest + swinging) == "");
    CHECK_THAT(faults_of(rod_deck + second + with_velocity("0, 0, \"sin(pi*s/9)\"") + rest),
               Catch::Contains("a node has one velocity"));
}

TEST_CASE("A move that begins with round-off begins with 0", "[issues]") {
    const auto moved = [](const std::string& move) {
        return rod_deck + "[[support]]\nat = \"r.start\"\nmove = { " + move + " }\n";
    };
    // A circle in a plane that is turned by a quarter: what is left along z is round-off.
    CHECK(faults_of(moved("x = \"sin(t)\", y = \"cos(t) - 1\", z = \"1e-3*cos(pi/2)\"")) == "");
    CHECK(faults_of(moved("x = 0, y = 0, z = 0, rx = \"cos(pi/2)\", ry = 0, rz = \"t\"")) == "");
    CHECK_THAT(faults_of(moved("x = \"1e-9 + 0*t\"")),
               Catch::Contains("is 1e-09 at t = 0; expected 0 there"));
}

TEST_CASE("Moments of inertia that rounding explains are taken with a warning", "[issues]") {
    const Problem problem = read(with_inertia("[1e-5, 1e-7, 9.5e-6]"));
    CHECK(problem.model.bodies[0].inertia(0, 0) == 1e-5);
    CHECK(warnings_of(problem).at(0) ==
          "body top has the principal moments 1e-07, 9.5e-06, 1e-05, the largest above the sum of the "
          "others: no "
          "body of mass has them, and it is moved as they say; 9.6e-06 would be the most");
    // A disc whose moments are printed with two digits, in any unit; as a matrix, too.
    for (const double unit : {1e-12, 1.0, 1e12}) {
        CHECK(warnings_of(
                  read(with_inertia(fmt::format("[{}, {}, {}]", 0.26 * unit, 0.26 * unit, 0.53 * unit))))
                  .size() == 2);
    }
    CHECK(faults_of(with_inertia("[[0.26, 0, 0], [0, 0.53, 0], [0, 0, 0.26]]")) == "");
    // Exact sums, such as a disc's, are no reason to warn.
    CHECK(warnings_of(read(with_inertia("[0.1, 0.2, \"0.1 + 0.2\"]"))).size() == 1);
    CHECK(faults_of(with_inertia("[3, 5, 9]")) ==
          "x.toml:3:11: body.top.inertia: no body has the principal moments 3, 5, 9: the largest cannot be "
          "above "
          "the sum of the others; expected 8 at most, or greater values of the others");
    CHECK_THAT(faults_of(with_inertia("[0, 0, 1e-20]")),
               Catch::Contains("expected a positive definite inertia"));
}

TEST_CASE("Points are near to each other as their own rods measure it", "[issues]") {
    const auto found = [](const std::string& rest) {
        return find_unconnected_points(read(replaced(rod_deck, "10, 0, 0", "1000, 0, 0") + rest).model);
    };
    const auto sensor = [](const std::string& from, const std::string& to) {
        return "[rod.q]\nsection = \"s\"\nline = { from = " + from + ", to = " + to + " }\nelements = 4\n";
    };
    const std::string joined = "[[connect]]\npoints = [\"r.end\", \"q.start\"]\n";
    // A millimetre on a kilometre.
    CHECK(found(sensor("[1000, 0, 0]", "[1000, 0, 0.001]") + joined).empty());
    // Its neighbour of the same size, half a millimetre away.
    CHECK(found(sensor("[1000, 0, 0.0005]", "[1000, 0, 0.0015]")).empty());
    // Forgotten to be connected, it is at one place with the cable's end, round-off included.
    CHECK(found(sensor("[1000, 0, 1e-13]", "[1000, 0, 0.001]")).size() == 1);
    // Two cables that miss each other by half a millimetre.
    CHECK(found(sensor("[1000, 0, 0.0005]", "[1000, 900, 0]")).size() == 1);
    // 2e5 elements of one rod, two neighbours of which are nearer than a millionth of it.
    CHECK(find_unconnected_points(read(replaced(rod_deck, "elements = 10", "elements = 10") +
                                       "[rod.arc]\nsection = \"s\"\npolyline = [[0, 5, 0], [5e-7, 5, 0], "
                                       "[10, 5, 0]]\nelements = 2\n")
                                      .model)
              .empty());
}

}  // namespace gxrod::test
