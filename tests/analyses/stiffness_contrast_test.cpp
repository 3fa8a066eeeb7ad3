#include "analyses/stiffness_contrast.hpp"

#include <catch2/catch.hpp>

#include "deck/decks.hpp"

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

TEST_CASE("A rod whose forces have round-off as large as what bends its neighbour is told of", "[analyses]") {
    CHECK(find(make_deck("1")).empty());
    CHECK(find(make_deck("1e8")).empty());
    // Round-off of 2.2e-16 of 2 along 0.5, times EA = 1e16, beside EI/L² = 1.
    const std::vector<std::string> found = find(make_deck("1e12"));
    REQUIRE(found.size() == 1);
    CHECK(
        found[0] ==
        "rod stiff is too stiff beside what bends rod soft for numbers of 16 digits: round-off of its forces "
        "is about 8.9, a force that bends rod soft about 1; expected EA, GAy and GAz up to 0.0003 of what "
        "they "
        "are, or longer elements");
    // A rod alone: stretching beside its own bending.
    const std::string alone = test::replaced(test::static_rod_deck, "EA = 1e4", "EA = 1e18");
    REQUIRE(find(alone).size() == 1);
    CHECK_THAT(find(alone)[0], Catch::StartsWith("rod r is too stiff beside what bends it for"));
    CHECK(find(test::static_rod_deck).empty());
}

TEST_CASE("Rods that nothing connects do not disturb each other", "[analyses]") {
    const std::string apart =
        test::replaced(make_deck("1e12"), "[[connect]]\npoints = [\"soft.end\", \"stiff.start\"]\n", "");
    CHECK(find(apart).empty());
}

TEST_CASE("A rod without bending stiffness is not soft beside round-off", "[analyses]") {
    Model model = test::read(make_deck("1")).model;
    for (Section& section : model.sections) section.stiffness(4, 4) = section.stiffness(5, 5) = 0.0;
    CHECK(find_stiffness_contrasts(model, find_parts(model)).empty());
}

TEST_CASE("A contrast is found at the nodes of its part", "[analyses]") {
    const std::string other =
        "[rod.apart]\nsection = \"a\"\nline = { from = [0, 5, 0], to = [1, 5, 0] }\nelements = 1\n";
    const Model model = test::read(make_deck("1e12") + other).model;
    const auto node_of = [&](std::size_t rod) { return std::vector<std::int64_t>{model.rods[rod].nodes[0]}; };
    for (std::size_t rod = 0; rod < 3; ++rod) {
        CHECK(find_contrast_at(model, node_of(rod)).has_value() == (model.rods[rod].name != "apart"));
    }
    CHECK(find_contrast_at(model, {}).has_value());
    // What has no stiffness at all resists nothing, and is to be told of instead.
    Model loose = model;
    for (Section& section : loose.sections) section.stiffness(3, 3) = 0.0;
    CHECK_FALSE(find_contrast_at(loose, {}).has_value());
}
