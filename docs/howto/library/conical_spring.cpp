// Prints the stiffness of conical coil springs, each built from points that are computed here, next to the
// value that handbooks give.
#include <cmath>
#include <cstdio>
#include <gxrod/face/gxrod.hpp>
#include <numbers>

namespace {

constexpr int turns = 6;
constexpr double pitch = 2e-3, wire = 1e-3, E = 206e9, nu = 0.3, force = 1e-3;

const char* const deck_text = R"(
[section.wire]
shape    = { circle = {} }
material = {}
[rod.coil]
section  = "wire"
elements = 120
order    = 3
[[support]]
at  = "coil.start"
fix = "all"
[[support]]
at  = "coil.end"
fix = ["x", "y", "rotation"]
[[load]]
at = "coil.end"
[analysis]
kind  = "static"
steps = 1
[[history]]
name       = "end"
at         = "coil.end"
quantities = ["displacement"]
)";

// Points of a coil whose radius shrinks evenly from one turn to the next.
std::vector<gxrod::Vec3> list_points(double radius, double last_radius) {
    std::vector<gxrod::Vec3> points;
    constexpr int points_of_a_turn = 24;
    for (int i = 0; i <= turns * points_of_a_turn; ++i) {
        const double part = static_cast<double>(i) / (turns * points_of_a_turn);
        const double angle = 2.0 * std::numbers::pi * turns * part;
        const double r = radius + part * (last_radius - radius);
        points.emplace_back(r * std::cos(angle), r * std::sin(angle), pitch * turns * part);
    }
    return points;
}

}  // namespace

int main() try {
    gxrod::Deck deck = gxrod::Deck::from_text(deck_text, "conical_spring.toml");
    deck.set("section.wire.shape.circle.radius", 0.5 * wire)
        .set("section.wire.material.E", E)
        .set("section.wire.material.nu", nu)
        .set("load[0].force", {0.0, 0.0, force});
    for (const double last_radius : {0.02, 0.015, 0.01}) {
        constexpr double radius = 0.02;
        gxrod::Simulation run(deck.set("rod.coil.spline", list_points(radius, last_radius)).build());
        run.run();
        const double G = E / (2.0 * (1.0 + nu));
        const double expected =
            G * std::pow(wire, 4) /
            (16.0 * turns * (radius * radius + last_radius * last_radius) * (radius + last_radius));
        std::printf("from %g to %g: stiffness %.3f, of handbooks %.3f\n",
                    radius,
                    last_radius,
                    force / run["end"].displacement.z(),
                    expected);
    }
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
