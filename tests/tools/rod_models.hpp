#pragma once

#include <functional>

#include "model/model.hpp"

// Models of one rod along any line.
namespace gxrod::tools {

// Where a section is: of the centreline, and its axes.
struct Placement {
    Vec3 r;
    Quat axes;
};
using Line = std::function<Placement(double)>;  // of arc length

// Along the global x, section axes global.
Placement along_x(double s);

struct Mesh {
    int elements;
    int order = 1;
    ElementKind kind = ElementKind::objective;
};

// Stiffness and mass given by their diagonals.
Section make_section(const std::array<double, 6>& stiffness, const std::array<double, 6>& mass = {});

Model make_rod_model(const Line& line, double length, const Mesh& mesh, const Section& section);
inline int last_node(const Model& model) { return static_cast<int>(model.nodes.size()) - 1; }

void clamp(Model& model, int node);
// Rising from nothing at t = 0 to these values at t = 1.
void add_ramp(Model& model, int node, const Vec3& force, const Vec3& moment, Frame frame = Frame::spatial);

inline TimeFunction ramp(double value) {
    return TimeFunction([value](double t) { return t * value; });
}

}  // namespace gxrod::tools
