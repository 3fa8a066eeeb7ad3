#include "check/motions/unconnected_points.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

std::string rod(const std::string& name, const std::string& from, const std::string& to) {
    return "[rod." + name + "]\nsection = \"s\"\nline = { from = " + from + ", to = " + to +
           " }\nelements = 4\nelement = \"simo\"\n";
}

std::vector<std::string> found(const std::string& rest) {
    return find_unconnected_points(read(rod_deck + rest).model);
}

using Sentences = std::vector<std::string>;

}  // namespace

TEST_CASE("Ends of rods at one place are reported", "[check]") {
    const std::string corner = rod("q", "[10, 0, 0]", "[10, 5, 0]");
    CHECK(found("").empty());
    CHECK(found(corner) == Sentences{"r.end and q.start are at one place and not connected; to connect them "
                                     "write [[connect]] points = [\"r.end\", \"q.start\"]"});
    CHECK(found(corner + "[[connect]]\npoints = [\"r.end\", \"q.start\"]\n").empty());
    CHECK(found(corner + rod("p", "[3, 4, 5]", "[10, 0, 0]")) ==
          Sentences{"r.end and q.start and p.end are at one place and not connected; to connect them write "
                    "[[connect]] points = [\"r.end\", \"q.start\", \"p.end\"]"});
    CHECK(found(corner + rod("p", "[3, 4, 5]", "[10, 0, 0]") +
                "[[connect]]\npoints = [\"r.end\", \"q.start\"]\n") ==
          Sentences{"r.end and p.end are at one place and not connected; to connect them write [[connect]] "
                    "points = [\"r.end\", \"p.end\"]"});
}

TEST_CASE("An end of a rod inside another one, or where a body is, is reported", "[check]") {
    CHECK(found(rod("q", "[3, 0, 0]", "[3, 5, 0]")) ==
          Sentences{"r@0.3 and q.start are at one place and not connected; to connect them write [[connect]] "
                    "points = [\"r@0.3\", \"q.start\"]"});
    CHECK(found("[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = [10, 0, 0]\n") ==
          Sentences{
              "r.end and b are at one place and not connected; to fix body.b there write at = \"r.end\""});
    CHECK(found("[body.b]\nmass = 1\ninertia = [1, 1, 1]\nat = \"r.end\"\n").empty());
    // Nodes inside two rods may lie on each other.
    CHECK(found(rod("q", "[2, -2, 0]", "[2, 2, 0]")).empty());
}

TEST_CASE("Ends that nearly meet are reported", "[check]") {
    CHECK(
        found(rod("q", "[10, 1e-6, 0]", "[10, 5, 0]")) ==
        Sentences{"r.end and q.start are only 1e-06 apart and not connected; points that are to be one must "
                  "agree better"});
    CHECK(found(rod("q", "[10, 1e-4, 0]", "[10, 5, 0]")).empty());
}

TEST_CASE("Ends that a gear ties are not a finding", "[check]") {
    const std::string corner = rod("q", "[10, 0, 0]", "[10, 5, 0]");
    const std::string hinges =
        "[joint.one]\ntype = \"hinge\"\nbetween = [\"ground\", \"r.end\"]\naxis = [0, 0, 1]\n"
        "[joint.two]\ntype = \"hinge\"\nbetween = [\"ground\", \"q.start\"]\naxis = [0, 0, 1]\n";
    CHECK(found(corner + hinges).size() == 1);
    CHECK(found(corner + hinges + "[gear.g]\njoints = [\"one\", \"two\"]\nratio = 2\n").empty());
}

TEST_CASE("Clamps at one place are not a finding", "[check]") {
    const std::string corner = rod("q", "[0, 0, 0]", "[0, 5, 0]");
    const std::string clamps =
        "[[support]]\nat = \"r.start\"\nfix = \"all\"\n[[support]]\nat = \"q.start\"\nfix = ";
    CHECK(found(corner + clamps + "\"position\"\n").size() == 1);
    CHECK(found(corner + clamps + "\"all\"\n").empty());
}

}  // namespace gxrod::test
