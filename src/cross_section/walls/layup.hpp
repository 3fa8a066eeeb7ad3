#pragma once

#include <string>
#include <vector>

// Walls of plies, as a deck gives them.
namespace gxrod {

struct Ply {
    int material = 0;  // an index in the materials of the section
    double thickness = 0.0;
    double fibre_angle = 0.0;  // θ from x towards t, the direction in which the wall is walked
};

// Plies one on the other, from the right of the walk to its left.
struct Layup {
    std::string name;
    std::vector<Ply> plies;

    double thickness() const;
};

}  // namespace gxrod
