#pragma once

#include <vector>

#include "mesh/chains.hpp"
#include "mesh/line_mesh.hpp"

namespace gxrod {

// An element of a rod from a mesh, in the direction of its chain, on the polynomial through the mesh's nodes.
struct NetElement {
    std::vector<int> nodes = {};          // order + 1, indices of RodNet::positions
    std::vector<double> arc_length = {};  // arc lengths of the nodes, from the start of the element
    std::vector<Quat> transports =
        {};  // carry axes from the start of the element to its nodes, without twisting
    Vec3 start_tangent, end_tangent;
    double turn = 0.0;  // turn of the tangent, from start to end
    int curve = 0;      // the number of the geometry's curve that it is on

    double length() const { return arc_length.back(); }
};

struct NetChain {
    std::vector<NetElement> elements;
    bool is_closed = false;
    double length = 0.0;
};

// The lines of a mesh as a net of a rod: chains with numbered nodes, inner nodes moved along their element to
// the Gauss-Lobatto points of its parameter.
struct RodNet {
    static constexpr std::size_t no_mesh_node = static_cast<std::size_t>(-1);
    int order = 1;
    std::vector<Vec3> positions;
    std::vector<std::size_t> mesh_nodes;  // index of each in LineMesh::positions; no_mesh_node if it has none
    std::vector<NetChain> chains;

    double length() const;
    // Whether it is one chain with two ends.
    bool is_line() const { return chains.size() == 1 && !chains.front().is_closed; }
    // Returns the fraction of the length at each node, for a line.
    std::vector<double> fractions() const;
};

// Makes a net from lines, which must have elements, all of one order from 1 to 3. Straight elements, of order
// 1, take any `order` from 1 to 4; the others keep theirs. Throws MeshError, naming the place, if an element
// has no length, ends where it starts or folds.
RodNet make_rod_net(const LineMesh& mesh, const MeshLines& lines, int order = 1);

}  // namespace gxrod
