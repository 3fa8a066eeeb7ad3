#include "cross_section/reference_cell.hpp"

#include "numerics/gauss_legendre.hpp"

namespace gxrod {
namespace {

struct FactorValue {
    double value, slope;
};

// Silvester's polynomial of degree m: zero at 0, 1/order, … (m − 1)/order, one at m/order.
FactorValue compute_lattice_factor(int m, int order, double x) {
    FactorValue factor{1.0, 0.0};
    for (int q = 0; q < m; ++q) {
        const double slope = static_cast<double>(order) / (m - q);
        const double term = (order * x - q) / (m - q);
        factor = {factor.value * term, factor.slope * term + factor.value * slope};
    }
    return factor;
}

// Lagrange's polynomial of degree `order` that is one at m/order, zero at the other points of the lattice.
FactorValue compute_line_factor(int m, int order, double x) {
    FactorValue factor{1.0, 0.0};
    for (int q = 0; q <= order; ++q) {
        if (q == m) continue;
        const double slope = static_cast<double>(order) / (m - q);
        const double term = (order * x - q) / (m - q);
        factor = {factor.value * term, factor.slope * term + factor.value * slope};
    }
    return factor;
}

void fill_triangle_row(int order, const Eigen::Vector2d& at, Eigen::Index row, CellShapes& table) {
    Eigen::Index node = 0;
    for (int j = 0; j <= order; ++j) {
        for (int i = 0; i + j <= order; ++i, ++node) {
            const FactorValue a = compute_lattice_factor(i, order, at.x());
            const FactorValue b = compute_lattice_factor(j, order, at.y());
            const FactorValue c = compute_lattice_factor(order - i - j, order, 1.0 - at.x() - at.y());
            table.values(row, node) = a.value * b.value * c.value;
            table.slopes_1(row, node) = b.value * (a.slope * c.value - a.value * c.slope);
            table.slopes_2(row, node) = a.value * (b.slope * c.value - b.value * c.slope);
        }
    }
}

void fill_quad_row(int order, const Eigen::Vector2d& at, Eigen::Index row, CellShapes& table) {
    Eigen::Index node = 0;
    for (int j = 0; j <= order; ++j) {
        for (int i = 0; i <= order; ++i, ++node) {
            const FactorValue a = compute_line_factor(i, order, at.x());
            const FactorValue b = compute_line_factor(j, order, at.y());
            table.values(row, node) = a.value * b.value;
            table.slopes_1(row, node) = a.slope * b.value;
            table.slopes_2(row, node) = a.value * b.slope;
        }
    }
}

}  // namespace

CellShapes compute_cell_shapes(CellShape shape, int order, const std::vector<Eigen::Vector2d>& points) {
    const auto rows = static_cast<Eigen::Index>(points.size());
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(rows, count_nodes(shape, order));
    CellShapes table{zero, zero, zero};
    for (Eigen::Index row = 0; row < rows; ++row) {
        const Eigen::Vector2d& at = points[static_cast<std::size_t>(row)];
        if (shape == CellShape::triangle) {
            fill_triangle_row(order, at, row, table);
        } else {
            fill_quad_row(order, at, row, table);
        }
    }
    return table;
}

std::vector<Eigen::Vector2d> list_lattice(CellShape shape, int order) {
    std::vector<Eigen::Vector2d> points;
    for (int j = 0; j <= order; ++j) {
        const int last = shape == CellShape::triangle ? order - j : order;
        for (int i = 0; i <= last; ++i)
            points.emplace_back(static_cast<double>(i) / order, static_cast<double>(j) / order);
    }
    return points;
}

CellQuadrature list_cell_quadrature(CellShape shape, int order) {
    const std::vector<QuadraturePoint> line = list_gauss_rule(order + 1);
    CellQuadrature rule;
    for (const auto& [eta, weight_2] : line) {
        const double y = 0.5 * (1.0 + eta);
        const double width = shape == CellShape::triangle ? 1.0 - y : 1.0;
        for (const auto& [xi, weight_1] : line) {
            rule.points.emplace_back(0.5 * (1.0 + xi) * width, y);
            rule.weights.push_back(0.25 * weight_1 * weight_2 * width);
        }
    }
    return rule;
}

ReferenceCell::ReferenceCell(CellShape shape, int order)
    : quadrature(list_cell_quadrature(shape, order)),
      at_points(compute_cell_shapes(shape, order, quadrature.points)),
      at_nodes(compute_cell_shapes(shape, order, list_lattice(shape, order))) {}

}  // namespace gxrod
