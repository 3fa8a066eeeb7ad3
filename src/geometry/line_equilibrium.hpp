#pragma once

#include <functional>
#include <optional>
#include <vector>

// The equilibrium of an elastic line without bending stiffness in an upright plane, under weights that differ
// along it, in part on a level bed without friction (docs/theory/water.md).
namespace gxrod {

// A stretch of a line with the same properties everywhere, free of stress.
struct LineStretch {
    double length;
    double weight;                               // per length below the surface; negative if it rises
    double dry_weight;                           // per length above the surface; not less than `weight`
    double compliance = 0.0;                     // 1/EA
    std::function<double(double)> end_weight{};  // what hangs at its end, by the height there; not falling
};

// A line from the start at x = z = 0 to its end. The bed is not above either of them.
struct SuspendedLine {
    double span, rise;  // x and z of the end; span ≥ 0
    std::vector<LineStretch> stretches;
    std::optional<double> bed{}, surface{};  // heights
};

// A piece in closed form, from its start: V = upright + weight s there, and the level part of the tension is
// the same everywhere.
struct LinePiece {
    double s, x, z;      // of its start; s free of stress
    double upright;      // upright part of the tension, by which what follows pulls up
    double weight;       // per length that hangs; 0 if it lies
    double compliance;   // 1/EA
    bool lies = false;   // on the bed
    bool kinks = false;  // whether its start bends at a weight
};

struct LineEquilibrium {
    double level;  // level part of the tension
    std::vector<LinePiece> pieces;
};

// Finds the only equilibrium in tension. Throws std::invalid_argument, with the numbers, for a line that is
// too long to be in tension, or that cannot stretch to its end.
LineEquilibrium find_line_equilibrium(const SuspendedLine& line);

}  // namespace gxrod
