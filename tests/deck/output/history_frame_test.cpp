#include <cmath>

#include "deck/decks.hpp"
#include "deck/round_trips.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// A rod with a twist of 0.3 at its start and of 0.8 at its end.
std::string twisted_rod() {
    return replaced(rod_deck, "elements = 10", "elements = 10\ntwist = [[0, 0.3], [1, 0.8]]");
}

std::string with_history(const std::string& deck, const std::string& lines) {
    return deck + "[[history]]\nname = \"h\"\nat = \"r.end\"\n" + lines;
}

const std::string relative = "quantities = \"displacement\"\nrelative_to = \"r.start\"\n";
const std::string supported = "[[support]]\nat = \"r.end\"\nfix = \"all\"\n";

}  // namespace

std::vector<RoundTrip> history_frame_trips() {
    const auto first = [](const Problem& p) { return p.output.histories.at(0); };
    return {{"history.axes",
             with_history(twisted_rod(), relative + "axes = \"untwisted\"\n"),
             [=](const Problem& p) { return first(p).relative_axes.isApprox(Quat::Identity(), 1e-14); }},
            {"history.about",
             with_history(rod_deck + supported, "quantities = \"reaction_moment\"\nabout = [1, 2, 3]\n"),
             [=](const Problem& p) { return first(p).about == Vec3(1, 2, 3); }}};
}

TEST_CASE("a history can be in section axes without their twist", "[deck]") {
    const auto axes_at = [](const std::string& point, const std::string& lines) {
        const std::string deck = with_history(twisted_rod(), replaced(relative, "r.start", point) + lines);
        const Quat axes = read(deck).output.histories.at(0).relative_axes;
        return Vec3(axes * Vec3::UnitY());
    };
    CHECK(axes_at("r.start", "").isApprox(Vec3(0.0, std::cos(0.3), std::sin(0.3)), 1e-14));
    CHECK(axes_at("r.start", "axes = \"untwisted\"\n").isApprox(Vec3::UnitY(), 1e-14));
    CHECK(axes_at("r@0.5", "").isApprox(Vec3(0.0, std::cos(0.55), std::sin(0.55)), 1e-14));
    CHECK(axes_at("r@0.5", "axes = \"untwisted\"\n").isApprox(Vec3::UnitY(), 1e-14));
    CHECK(axes_at("r.end", "axes = \"untwisted\"\n").isApprox(Vec3::UnitY(), 1e-14));
}

TEST_CASE("what a history cannot be relative to or about is said", "[deck]") {
    CHECK_THROWS_WITH(
        read(with_history(rod_deck + supported, "quantities = \"reaction_force\"\nabout = [1, 2, 3]\n")),
        Contains("history[0].about: goes with reaction_moment"));
    CHECK_THROWS_WITH(read(with_history(rod_deck + "[body.b]\nmass = 1\ninertia = [1, 1, 1]\n",
                                        replaced(relative, "r.start", "b") + "axes = \"untwisted\"\n")),
                      Contains("history[0].axes: only sections of rods have a twist"));
}

}  // namespace gxrod::test
