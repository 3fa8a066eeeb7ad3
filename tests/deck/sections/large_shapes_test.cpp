#include "deck/sections/large_shapes.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// A row of bars of 2 along x with a rectangle, which is cut into cells; its shape is in line 2.
std::string bars(const std::string& shape, int count = 1) {
    std::string text = "[section.s]\nshape = { " + shape + " }\nmaterial = { E = 2e11, nu = 0.3 }\n";
    for (int i = 0; i < count; ++i) {
        text += "[rod.r" + std::to_string(i) + "]\nsection = \"s\"\nline = { from = [" +
                std::to_string(2 * i) + ", 0, 0], to = [" + std::to_string(2 * i + 2) +
                ", 0, 0] }\nelements = 1\ny_axis = [0, 1, 0]\n";
        if (i > 0)
            text += "[[connect]]\npoints = [\"r" + std::to_string(i - 1) + ".end\", \"r" + std::to_string(i) +
                    ".start\"]\n";
    }
    return text + "[analysis]\nkind = \"static\"\n[output]\nstresses = \"von-mises\"\n";
}

std::string questions_of(const std::string& deck) {
    std::string all;
    for (const std::string& note : read(deck).notes) {
        if (note.find("one unit") != std::string::npos) all += note;
    }
    return all;
}

}  // namespace

TEST_CASE("A shape in another unit than its rods is asked about, with its place", "[deck]") {
    CHECK(questions_of(bars("rectangle = { width_y = 100, height_z = 50 }")) ==
          "x.toml:2:9: section.s.shape: is 100 across, and rod r0 is 2 long; are all lengths in one unit?");
    CHECK(questions_of(bars("rectangle = { width_y = 0.41, height_z = 0.05 }")) ==
          "x.toml:2:9: section.s.shape: is 0.41 across, and rod r0 is 2 long; are all lengths in one unit?");
    CHECK(questions_of(bars("rectangle = { width_y = 0.39, height_z = 0.05 }")).empty());
    // All rods of a part count.
    CHECK(questions_of(bars("rectangle = { width_y = 0.41, height_z = 0.05 }", 2)).empty());
    CHECK(questions_of(bars("rectangle = { width_y = 41, height_z = 0.05 }", 6)) ==
          "x.toml:2:9: section.s.shape: is 41 across, and rods r0, r1, r2, r3 and 2 more are 12 long "
          "together; are "
          "all lengths in one unit?");
}

}  // namespace gxrod::test
