#include "deck/cross_section.hpp"

#include <Eigen/SparseLU>
#include <array>
#include <vector>

// V. Giavotto et al. (Computers & Structures 16, 1983): displacements of a slice are those of a rigid
// section, of strains ψ, and a warping w(y, z) that changes along the bar,
//   ε = Z ψ + B w + S w′,   energy of a length ½ ∫ εᵀ D ε dA.
// Letters: A = ∫ZᵀDZ, R = ∫BᵀDZ, L = ∫SᵀDZ, C = ∫SᵀDB, E = ∫BᵀDB, M = ∫SᵀDS. Where resultants θ change along
// the bar by at most a constant θ′, w″ = 0, and equilibrium is
//   E w′ + R ψ′ = 0,                       Rᵀ w′ + A ψ′ = θ′
//   E w + R ψ = (C − Cᵀ) w′ + L ψ′,        Rᵀ w + A ψ = θ − Lᵀ w′
// with w, w′ free of rigid motions. Strains are in the order (xx, yy, zz, yz, xz, xy).
namespace gxrod::test {
namespace {

using Eigen::MatrixXd;
using Vector2 = Eigen::Vector2d;
using Sparse = Eigen::SparseMatrix<double>;

// Aᵀ B. Products of many types would take half a minute to compile.
MatrixXd pair(const MatrixXd& A, const MatrixXd& B) { return A.transpose() * B; }

struct Matrices {
    std::vector<Eigen::Triplet<double>> E, C, M;
    MatrixXd R, L, constraints;  // 6 columns each
    MatrixXd A = MatrixXd::Zero(6, 6);
};

// Lagrange polynomials through −1, 0, 1 and their derivatives.
struct Shape {
    explicit Shape(double x)
        : value{0.5 * x * (x - 1), 1 - x * x, 0.5 * x * (x + 1)}, slope{x - 0.5, -2 * x, x + 0.5} {}
    std::array<double, 3> value, slope;
};

Mat6 make_material(double E, double nu) {
    const double G = E / (2.0 * (1.0 + nu));
    const double lambda = E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
    Mat6 D = Mat6::Zero();
    D.topLeftCorner<3, 3>().setConstant(lambda);
    D.diagonal().head<3>().array() += 2.0 * G;
    D.diagonal().tail<3>().setConstant(G);
    return D;
}

// Strains of a slice at (y, z) from ψ: extension, shears, twist, curvatures.
Mat6 make_rigid_strains(const Vector2& p) {
    const double y = p[0];
    const double z = p[1];
    Mat6 Z = Mat6::Zero();
    Z.row(0) << 1, 0, 0, 0, z, -y;
    Z.row(4) << 0, 0, 1, y, 0, 0;
    Z.row(5) << 0, 1, 0, -z, 0, 0;
    return Z;
}

class Assembly {
  public:
    explicit Assembly(const SectionGrid& grid) : grid_(grid), D_(make_material(grid.E, grid.nu)) {
        matrices.R = matrices.L = matrices.constraints = MatrixXd::Zero(size(), 6);
        for (int i = 0; i < grid.columns; ++i) {
            for (int j = 0; j < grid.rows; ++j) add_element(i, j);
        }
    }

    int size() const { return 3 * lines() * (2 * grid_.columns + 1); }
    Matrices matrices;

  private:
    int lines() const { return 2 * grid_.rows + (grid_.closes ? 0 : 1); }
    int node(int i, int j) const { return i * lines() + j % lines(); }

    void add_element(int column, int row) {
        std::array<int, 9> nodes{};
        Eigen::Matrix<double, 2, 9> places;
        for (int k = 0; k < 9; ++k) {
            const int i = 2 * column + k / 3;
            const int j = 2 * row + k % 3;
            nodes[k] = node(i, j);
            places.col(k) = grid_.map(i / (2.0 * grid_.columns), j / (2.0 * grid_.rows));
        }
        const double g = std::sqrt(0.6);
        const std::array<double, 3> points{-g, 0.0, g};
        const std::array<double, 3> weights{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b)
                add_point(nodes, places, points[a], points[b], weights[a] * weights[b]);
        }
    }

    void add_point(const std::array<int, 9>& nodes,
                   const Eigen::Matrix<double, 2, 9>& places,
                   double xi,
                   double eta,
                   double weight) {
        const Shape u(xi);
        const Shape v(eta);
        Eigen::Matrix<double, 9, 1> N;
        Eigen::Matrix<double, 9, 2> local;
        for (int k = 0; k < 9; ++k) {
            N[k] = u.value[k / 3] * v.value[k % 3];
            local.row(k) << u.slope[k / 3] * v.value[k % 3], u.value[k / 3] * v.slope[k % 3];
        }
        const Eigen::Matrix2d jacobian = places * local;
        const Eigen::Matrix<double, 9, 2> gradient = local * jacobian.inverse();
        MatrixXd strains = MatrixXd::Zero(6, 60);  // B, S and Z
        auto B = strains.leftCols(27);
        auto S = strains.middleCols(27, 27);
        for (int k = 0; k < 9; ++k) {
            const double dy = gradient(k, 0);
            const double dz = gradient(k, 1);
            B(1, 3 * k + 1) = B(3, 3 * k + 2) = B(5, 3 * k) = dy;
            B(2, 3 * k + 2) = B(3, 3 * k + 1) = B(4, 3 * k) = dz;
            S(0, 3 * k) = S(5, 3 * k + 1) = S(4, 3 * k + 2) = N[k];
        }
        strains.rightCols(6) = make_rigid_strains(places * N);
        scatter(nodes, strains, weight * std::abs(jacobian.determinant()));
    }

    void scatter(const std::array<int, 9>& nodes, const MatrixXd& strains, double area) {
        const MatrixXd energy = pair(area * strains, D_ * strains);
        // Rigid motions of a section: those whose strains S w′ are Z ψ.
        const MatrixXd rigid = pair(area * strains, strains.rightCols(6));
        matrices.A += energy.bottomRightCorner(6, 6);
        for (int i = 0; i < 27; ++i) {
            const int row = 3 * nodes[i / 3] + i % 3;
            matrices.R.row(row) += energy.row(i).tail(6);
            matrices.L.row(row) += energy.row(27 + i).tail(6);
            matrices.constraints.row(row) += rigid.row(27 + i);
            for (int j = 0; j < 27; ++j) {
                const int column = 3 * nodes[j / 3] + j % 3;
                matrices.E.emplace_back(row, column, energy(i, j));
                matrices.C.emplace_back(row, column, energy(27 + i, j));
                matrices.M.emplace_back(row, column, energy(27 + i, 27 + j));
            }
        }
    }

    const SectionGrid& grid_;
    MatrixXd D_;
};

Sparse make_sparse(int size, const std::vector<Eigen::Triplet<double>>& entries) {
    Sparse matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

// [E R D; Rᵀ A 0; Dᵀ 0 0].
Sparse make_system(int size, const Matrices& matrices) {
    std::vector<Eigen::Triplet<double>> entries = matrices.E;
    const auto add = [&](int i, int j, double value) {
        entries.emplace_back(i, j, value);
        entries.emplace_back(j, i, value);
    };
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < 6; ++j) {
            add(i, size + j, matrices.R(i, j));
            add(i, size + 6 + j, matrices.constraints(i, j));
        }
    }
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) entries.emplace_back(size + i, size + j, matrices.A(i, j));
    }
    return make_sparse(size + 12, entries);
}

}  // namespace

Mat6 compute_section_compliance(const SectionGrid& grid) {
    const Assembly assembly(grid);
    const Matrices& m = assembly.matrices;
    const int size = assembly.size();
    Eigen::SparseLU<Sparse> solver(make_system(size, m));
    // dθ/dx: the moments change by the shear forces, M′ = N × e_x.
    Mat6 change = Mat6::Zero();
    change(4, 2) = 1.0;
    change(5, 1) = -1.0;
    MatrixXd right = MatrixXd::Zero(size + 12, 6);
    right.middleRows(size, 6) = change;
    const MatrixXd rates = solver.solve(right);
    const Sparse C = make_sparse(size, m.C);
    const MatrixXd dw = rates.topRows(size);
    const MatrixXd dpsi = rates.middleRows(size, 6);
    right.setZero();
    const MatrixXd C_dw = C * dw;
    const MatrixXd Ct_dw = C.transpose() * dw;
    right.topRows(size) = C_dw - Ct_dw + MatrixXd(m.L * dpsi);
    right.middleRows(size, 6) = MatrixXd::Identity(6, 6) - pair(m.L, dw);
    const MatrixXd solution = solver.solve(right);
    const MatrixXd w = solution.topRows(size);
    const MatrixXd psi = solution.middleRows(size, 6);
    const MatrixXd crossed = pair(w, m.R * psi) + pair(Ct_dw, w) + pair(dw, m.L * psi);
    const MatrixXd own =
        pair(w, make_sparse(size, m.E) * w) + pair(dw, make_sparse(size, m.M) * dw) + pair(psi, m.A * psi);
    return own + crossed + crossed.transpose();
}

}  // namespace gxrod::test
