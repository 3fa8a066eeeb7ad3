#pragma once

#include <Eigen/Core>
#include <vector>

#include "cross_section/section_mesh.hpp"

// Shape functions of cells on their reference: of a triangle ξ, η ≥ 0, ξ + η ≤ 1, of a quadrilateral the unit
// square.
namespace gxrod {

// Lagrange shape functions of an even lattice, their slopes along ξ and η: a row for each point, a column for
// each node, in the order of SectionCell::nodes.
struct CellShapes {
    Eigen::MatrixXd values, slopes_1, slopes_2;
};

// Computes the shape functions of a cell at points (ξ, η).
CellShapes compute_cell_shapes(CellShape shape, int order, const std::vector<Eigen::Vector2d>& points);

// Lists the points of the lattice, the nodes.
std::vector<Eigen::Vector2d> list_lattice(CellShape shape, int order);

struct CellQuadrature {
    std::vector<Eigen::Vector2d> points;
    std::vector<double> weights;
};

// Returns a Gauss rule of (order + 1)² points. Integrates polynomials of degree 2 order + 1 in each variable
// over a square, of degree 2 order over a triangle, on which it is collapsed into a corner. Orders go from 1
// to 4.
CellQuadrature list_cell_quadrature(CellShape shape, int order);

// Quadrature and shape functions that all cells of a shape and an order share.
struct ReferenceCell {
    CellQuadrature quadrature;
    CellShapes at_points;  // at the quadrature points
    CellShapes at_nodes;

    ReferenceCell(CellShape shape, int order);
};

}  // namespace gxrod
