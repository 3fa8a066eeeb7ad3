#include "cross_section/warping_system.hpp"

#include <Eigen/OrderingMethods>

#include "cross_section/section_error.hpp"

namespace gxrod {
namespace {

using NodeGraph = Eigen::SparseMatrix<double>;

// Which nodes share a cell, itself included.
NodeGraph find_graph(const SectionMesh& mesh) {
    std::vector<Eigen::Triplet<double>> pairs;
    for (const SectionCell& cell : mesh.cells) {
        for (const int a : cell.nodes) {
            for (const int b : cell.nodes) pairs.emplace_back(a, b, 1.0);
        }
    }
    const auto nodes = static_cast<Eigen::Index>(mesh.nodes.size());
    NodeGraph graph(nodes, nodes);
    graph.setFromTriplets(pairs.begin(), pairs.end());
    return graph;
}

std::vector<int> find_elimination_places(const NodeGraph& graph) {
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>{}(graph, order);
    std::vector<int> places(static_cast<std::size_t>(graph.cols()));
    for (int k = 0; k < graph.cols(); ++k) places[static_cast<std::size_t>(order.indices()[k])] = k;
    return places;
}

// Three unknowns of the first node, and of the farthest one that across the line between both.
std::array<int, 4> choose_held_unknowns(const std::vector<PlanePoint>& nodes) {
    int farthest = 0;
    double largest = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double distance = (nodes[i] - nodes.front()).squaredNorm();
        if (distance <= largest) continue;
        largest = distance;
        farthest = static_cast<int>(i);
    }
    const PlanePoint line = nodes[static_cast<std::size_t>(farthest)] - nodes.front();
    return {0, 1, 2, 3 * farthest + (std::abs(line.x()) > std::abs(line.y()) ? 2 : 1)};
}

// Entries of B for slopes along y (0) and z (1): rows of strain (yy, zz, yz, xz, xy) of the components of a
// displacement (x, y, z).
constexpr std::array<std::array<int, 3>, 2> strain_rows{{{5, 1, 3}, {4, 3, 2}}};

// One component pair of a cell's matrix: Σ ∂N_a ∂N_b Q over both slopes.
Eigen::MatrixXd compute_pair(const CellPoints& points, int row, int column) {
    const auto nodes = points.slopes_y.cols();
    Eigen::MatrixXd pair = Eigen::MatrixXd::Zero(nodes, nodes);
    const std::array slopes{&points.slopes_y, &points.slopes_z};
    Eigen::VectorXd weights(points.slopes_y.rows());
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) {
            const int a = strain_rows[i][static_cast<std::size_t>(row)];
            const int b = strain_rows[j][static_cast<std::size_t>(column)];
            for (Eigen::Index q = 0; q < weights.size(); ++q) {
                const auto point = static_cast<std::size_t>(q);
                weights[q] = points.weights[point] * points.stiffness_at(point)(a, b);
            }
            if (weights.isZero(0.0)) continue;
            pair.noalias() += slopes[i]->transpose() * (weights.asDiagonal() * *slopes[j]);
        }
    }
    return pair;
}

}  // namespace

WarpingSystem::WarpingSystem(const SectionQuadrature& quadrature) : quadrature_(quadrature) {
    held_ = choose_held_unknowns(quadrature.mesh().nodes);
    lay_out();
    assemble();
    factor_.compute(matrix_);
    if (factor_.info() != Eigen::Success || factor_.vectorD().minCoeff() <= 0.0)
        throw SectionError("its parts do not hold together: the stiffness against warping is singular");
}

bool WarpingSystem::is_held(int unknown) const {
    return std::find(held_.begin(), held_.end(), unknown) != held_.end();
}

void WarpingSystem::lay_out() {
    const NodeGraph graph = find_graph(quadrature_.mesh());
    place_of_node_ = find_elimination_places(graph);
    below_.resize(static_cast<std::size_t>(graph.cols()));
    for (int node = 0; node < graph.cols(); ++node) {
        const int column = place_of_node_[static_cast<std::size_t>(node)];
        for (NodeGraph::InnerIterator entry(graph, node); entry; ++entry) {
            const int row = place_of_node_[static_cast<std::size_t>(entry.row())];
            if (row >= column) below_[static_cast<std::size_t>(column)].push_back(row);
        }
    }
    std::vector<int> starts{0}, rows;
    for (int column = 0; column < graph.cols(); ++column) {
        std::vector<int>& list = below_[static_cast<std::size_t>(column)];
        std::sort(list.begin(), list.end());
        for (int c = 0; c < 3; ++c) {
            for (const int row : list) {
                for (int r = row == column ? c : 0; r < 3; ++r) rows.push_back(3 * row + r);
            }
            starts.push_back(static_cast<int>(rows.size()));
        }
    }
    const std::vector<double> values(rows.size(), 0.0);
    const auto size = 3 * graph.cols();
    matrix_ = Eigen::Map<const Eigen::SparseMatrix<double>>(
        size, size, static_cast<Eigen::Index>(rows.size()), starts.data(), rows.data(), values.data());
}

void WarpingSystem::assemble() {
    for (const CellPoints& points : quadrature_.cells()) add_cell(points);
    const double typical = matrix_.diagonal().mean();
    for (const int unknown : held_) {
        const int place = 3 * place_of_node_[static_cast<std::size_t>(unknown / 3)];
        matrix_.coeffRef(place + unknown % 3, place + unknown % 3) = typical;
    }
}

void WarpingSystem::add_cell(const CellPoints& points) {
    std::array<std::array<Eigen::MatrixXd, 3>, 3> pairs;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c <= r; ++c) {
            const auto i = static_cast<std::size_t>(r), j = static_cast<std::size_t>(c);
            pairs[i][j] = compute_pair(points, r, c);
            if (c < r) pairs[j][i] = pairs[i][j].transpose();
        }
    }
    const std::vector<int>& nodes = points.cell->nodes;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
        for (std::size_t b = 0; b < nodes.size(); ++b) {
            const auto row_place = place_of_node_[static_cast<std::size_t>(nodes[a])];
            if (row_place < place_of_node_[static_cast<std::size_t>(nodes[b])]) continue;
            Eigen::Matrix3d block;
            for (int r = 0; r < 3; ++r) {
                for (int c = 0; c < 3; ++c) {
                    block(r, c) = pairs[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)](
                        static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
                }
            }
            add_block(nodes[a], nodes[b], block);
        }
    }
}

void WarpingSystem::add_block(int row_node, int column_node, const Eigen::Matrix3d& block) {
    const int row = place_of_node_[static_cast<std::size_t>(row_node)];
    const int column = place_of_node_[static_cast<std::size_t>(column_node)];
    const std::vector<int>& list = below_[static_cast<std::size_t>(column)];
    const auto position = std::lower_bound(list.begin(), list.end(), row) - list.begin();
    for (int c = 0; c < 3; ++c) {
        if (is_held(3 * column_node + c)) continue;
        // The block of the diagonal, the first, lacks what is above it.
        double* const values =
            matrix_.valuePtr() + matrix_.outerIndexPtr()[3 * column + c] + 3 * position - c;
        for (int r = position == 0 ? c : 0; r < 3; ++r) {
            if (!is_held(3 * row_node + r)) values[r] += block(r, c);
        }
    }
}

Eigen::MatrixXd WarpingSystem::solve_once(const Eigen::MatrixXd& force) const {
    Eigen::MatrixXd ordered(force.rows(), force.cols());
    for (std::size_t node = 0; node < place_of_node_.size(); ++node)
        ordered.middleRows<3>(3 * place_of_node_[node]) =
            force.middleRows<3>(3 * static_cast<Eigen::Index>(node));
    for (const int unknown : held_)
        ordered.row(3 * place_of_node_[static_cast<std::size_t>(unknown / 3)] + unknown % 3).setZero();
    const Eigen::MatrixXd solved = factor_.solve(ordered);
    Eigen::MatrixXd warping(force.rows(), force.cols());
    for (std::size_t node = 0; node < place_of_node_.size(); ++node)
        warping.middleRows<3>(3 * static_cast<Eigen::Index>(node)) =
            solved.middleRows<3>(3 * place_of_node_[node]);
    return warping;
}

Eigen::MatrixXd WarpingSystem::solve(const Eigen::MatrixXd& force) const {
    const WarpingFields fields{.warping = solve_once(force)};
    Eigen::MatrixXd left = force;
    for (const CellPoints& points : quadrature_.cells()) {
        PointFields stresses = compute_stresses(points, compute_strains(points, fields), -1.0);
        weigh(points, stresses);
        add_warping_force(points, stresses, left);
    }
    return fields.warping + solve_once(left);
}

}  // namespace gxrod
