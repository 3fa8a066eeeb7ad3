#pragma once

#include <string>

#include "deck/decks.hpp"

// Decks with water for tests to change.
namespace gxrod::test {

inline const std::string gravity_down = "gravity = [0, 0, -9.81]\n";

// rod_deck with a tube, lines of `fluid` in it and gravity downwards: lines 1 to 13 if `fluid` is one line.
inline std::string tube_deck(const std::string& fluid = "fluid = {}") {
    return gravity_down + R"([section.s]
shape = { tube = { outer_radius = 0.25, inner_radius = 0.2 } }
material = { E = 2e11, nu = 0.3, density = 7850 }
)" + fluid +
           R"(
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [10, 0, 0] }
elements = 4
[analysis]
kind = "dynamic"
end_time = 1.0
steps = 10
)";
}

// The same in three stages, the first static and the others with time, of 2 and 3.
inline std::string staged_tube_deck() {
    const std::string deck = tube_deck();
    return deck.substr(0, deck.find("[analysis]")) + R"([[stage]]
name = "hang"
kind = "static"
[[stage]]
name = "storm"
kind = "dynamic"
end_time = 2.0
steps = 10
[[stage]]
name = "calm"
kind = "quasi-static"
end_time = 3.0
steps = 10
)";
}

inline const std::string water_deck = "[fluid]\ndensity = 1000\nsurface = 0\n";

}  // namespace gxrod::test
