#include "check/findings/stiffness_contrast.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// A soft cantilever, EA 1e4 and EI 1 along 0 … 1, and a rod on its end that is stiffer by a factor.
std::string make_deck(const std::string& factor) {
    return R"([parameters]
c = )" + factor +
           R"(
[section.a]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 1, EIy = 1, EIz = 1 }
[section.b]
stiffness = { EA = "1e4*c", GAy = "1e4*c", GAz = "1e4*c", GJ = "c", EIy = "c", EIz = "c" }
[rod.soft]
section = "a"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 3
[rod.stiff]
section = "b"
line = { from = [1, 0, 0], to = [2, 0, 0] }
elements = 2
[[connect]]
points = ["soft.end", "stiff.start"]
[analysis]
kind = "static"
)";
}

std::vector<std::string> find(const std::string& deck) {
    const Model model = test::read(deck).model;
    std::vector<std::string> sentences;
    for (const StiffnessContrast& contrast : find_stiffness_contrasts(model, find_parts(model))) {
        sentences.push_back(describe(contrast, model) + "; expected " + advise(contrast));
    }
    return sentences;
}

}  // namespace

TEST_CASE("A rod whose forces have round-off as large as what bends its neighbour is reported", "[check]") {
    CHECK(find(make_deck("1")).empty());
    CHECK(find(make_deck("1e8")).empty());
    // Round-off of 2.2e-16 of 2 along 0.5, times EA = 1e16, compared with EI/L² = 1.
    const std::vector<std::string> found = find(make_deck("1e12"));
    REQUIRE(found.size() == 1);
    CHECK(found[0] ==
          "rod stiff is too stiff compared with what bends rod soft for numbers of 16 digits: round-off of "
          "its forces "
          "is about 8.9, a force that bends rod soft about 1; expected EA, GAy and GAz up to 0.0003 of what "
          "they "
          "are, or longer elements");
    // A rod alone: stretching compared with its own bending.
    const std::string alone = test::replaced(test::static_rod_deck, "EA = 1e4", "EA = 1e18");
    REQUIRE(find(alone).size() == 1);
    CHECK_THAT(find(alone)[0], Catch::StartsWith("rod r is too stiff compared with what bends it for"));
    CHECK(find(test::static_rod_deck).empty());
}

TEST_CASE("Rods that nothing connects do not disturb each other", "[check]") {
    const std::string apart =
        test::replaced(make_deck("1e12"), "[[connect]]\npoints = [\"soft.end\", \"stiff.start\"]\n", "");
    CHECK(find(apart).empty());
}

TEST_CASE("A rod without bending stiffness is not soft compared with round-off", "[check]") {
    Model model = test::read(make_deck("1")).model;
    for (Section& section : model.sections) section.stiffness(4, 4) = section.stiffness(5, 5) = 0.0;
    CHECK(find_stiffness_contrasts(model, find_parts(model)).empty());
}

TEST_CASE("A contrast is found at the nodes of its part", "[check]") {
    const std::string other =
        "[rod.apart]\nsection = \"a\"\nline = { from = [0, 5, 0], to = [1, 5, 0] }\nelements = 1\n";
    const Model model = test::read(make_deck("1e12") + other).model;
    const auto node_of = [&](std::size_t rod) { return std::vector<std::int64_t>{model.rods[rod].nodes[0]}; };
    for (std::size_t rod = 0; rod < 3; ++rod) {
        CHECK(find_contrast_at(model, node_of(rod)).has_value() == (model.rods[rod].name != "apart"));
    }
    CHECK(find_contrast_at(model, {}).has_value());
    // What has no stiffness at all resists nothing, and is reported instead.
    Model loose = model;
    for (Section& section : loose.sections) section.stiffness(3, 3) = 0.0;
    CHECK_FALSE(find_contrast_at(loose, {}).has_value());
}

namespace {

std::string make_strip(const std::string& stiffness) {
    return "[section.s]\n" + stiffness + R"(
[rod.strip]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 10
[analysis]
kind = "static"
)";
}

}  // namespace

TEST_CASE("A bending or twisting stiffness whose round-off bends the rod is reported", "[check]") {
    const auto strip = [](const std::string& GJ, const std::string& EIz) {
        return find(make_strip("stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = " + GJ +
                               ", EIy = 1, EIz = " + EIz + " }"));
    };
    // 2.2e-16 along 0.1 times EIz, compared with EIy/L: some thousandths at 1e12, and Newton's method has 24
    // iterations for 18; at 1e14 it has 42, and 110 for a twist.
    CHECK(strip("1", "1e12").empty());
    REQUIRE(strip("1", "1e14").size() == 1);
    CHECK(strip("1", "1e14")[0] ==
          "rod strip is too stiff compared with what bends it for numbers of 16 digits: round-off of its "
          "moments is "
          "about 0.22, a moment that bends it about 1; expected the largest of GJ, EIy and EIz up to 0.01 of "
          "what it is, or longer elements");
    CHECK(strip("1e12", "1").empty());
    CHECK(strip("1e14", "1").size() == 1);
}

TEST_CASE("A stiffness that only a full matrix shows is reported", "[check]") {
    Model model =
        test::read(make_strip("stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 1e3, EIy = 1, EIz = 1 }"))
            .model;
    CHECK(find_stiffness_contrasts(model, find_parts(model)).empty());
    // Bending stiffnesses of 2e14 and 2 about axes half-way between y and z, so that no entry is small.
    model.sections[0].stiffness.bottomRightCorner<2, 2>() << 1e14 + 1.0, 1e14 - 1.0, 1e14 - 1.0, 1e14 + 1.0;
    const auto found = find_stiffness_contrasts(model, find_parts(model));
    REQUIRE(found.size() == 1);
    CHECK_THAT(describe(found[0], model), Catch::Contains("a moment that bends it about 2"));
}
