#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>

#include "cross_section/section_quadrature.hpp"

namespace gxrod {

// The matrix E = ∫ Bᵀ Q B of the warping of a section, factorized once. It resists neither translations nor a
// turn about x; four unknowns are held at zero for these, three of one node and one of the node farthest from
// it.
class WarpingSystem {
  public:
    // Keeps a reference. Throws SectionError if the section hangs together too little to be solved.
    explicit WarpingSystem(const SectionQuadrature& quadrature);

    // Solves E w = f for several columns, refined once; f must do no work on rigid motions.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& force) const;

  private:
    void lay_out();
    void assemble();
    void add_cell(const CellPoints& points);
    // Adds the block of two nodes; the row's node comes later in the order of elimination.
    void add_block(int row_node, int column_node, const Eigen::Matrix3d& block);
    bool is_held(int unknown) const;
    Eigen::MatrixXd solve_once(const Eigen::MatrixXd& force) const;

    const SectionQuadrature& quadrature_;
    std::array<int, 4> held_{};
    std::vector<int> place_of_node_;  // in the order of elimination
    std::vector<std::vector<int>>
        below_;  // by place of a node: of those that share a cell, its own and later ones
    Eigen::SparseMatrix<double> matrix_;  // lower triangle, blocks of three in that order
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
};

}  // namespace gxrod
