#pragma once

#include "assembly/system.hpp"

// Rods and their static tangents, for tests of what is weak in them.
namespace gxrod::tools {

// Adds a straight rod of elements of order 1 or 2 from start to end; EA = GA = 1e6, GJ = EI = 100, mass 1 a
// length. Nodes are "NAME.start", "NAME node 1" …, "NAME.end".
struct RodSpec {
    std::string name;
    Vec3 start, end;
    int elements = 4;
    int order = 1;
};
Rod& add_rod(Model& model, const RodSpec& spec);
// Makes the start of the last rod the given node.
void connect_start(Model& model, int node);

// Holds the components x y z rx ry rz that are named, of a node.
void add_support(Model& model, int node, const std::vector<int>& components);

// At the trial motions of the state, without inertia.
std::vector<double> compute_static_tangent(const System& system, const State& state);

}  // namespace gxrod::tools
