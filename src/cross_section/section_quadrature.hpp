#pragma once

#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "cross_section/elastic_material.hpp"
#include "cross_section/reference_cell.hpp"
#include "cross_section/section_mesh.hpp"

// Integrals over a section. A slice of a rod is displaced by a rigid motion and by the warping w(y, z), three
// components; its strains (xx, yy, zz, yz, xz, xy) are
//     ε = B w + S (w′ + Z ψ),     ψ = (Γ, K),     Z ψ = Γ + K × (0, y, z),     S a = (a_x, 0, 0, 0, a_z, a_y)
//     (CS1)
// with the derivatives across in B w, and ′ along x.
namespace gxrod {

// Warpings, their slopes along x and generalised strains: a column for each case. Unknowns of node n are the
// rows 3 n (x), 3 n + 1 (y), 3 n + 2 (z). An empty matrix is zero.
struct WarpingFields {
    Eigen::MatrixXd warping{}, slope{}, strain{};

    Eigen::Index count() const;
};

// A cell with the data of its points: quadrature points, or its nodes.
struct CellPoints {
    const SectionCell* cell = nullptr;
    const Eigen::MatrixXd* shapes = nullptr;  // a row for each point, a column for each node
    Eigen::MatrixXd slopes_y{}, slopes_z{};   // derivatives of the shape functions, likewise
    std::vector<double> weights{};            // of the area; at nodes the determinant of the map
    std::vector<PlanePoint> at{};
    std::vector<PlanePoint> walls{};  // the unit vector t at each point
    std::vector<Mat6> stiffness{};    // in section axes: one for all points or one for each

    const Mat6& stiffness_at(std::size_t point) const { return stiffness[stiffness.size() > 1 ? point : 0]; }
};

// Strains or stresses (xx, yy, zz, yz, xz, xy) at the points of a cell: of each component a row for each
// point, a column for each case.
using PointFields = std::array<Eigen::MatrixXd, 6>;

// Returns S Z at a point.
Mat6 compute_slice_strains(const PlanePoint& at);

// Computes the strains at the points of a cell.
PointFields compute_strains(const CellPoints& points, const WarpingFields& fields);

// Computes stresses from strains, times a factor.
PointFields compute_stresses(const CellPoints& points, const PointFields& strains, double factor = 1.0);
// Multiplies values at points by their weights.
void weigh(const CellPoints& points, PointFields& fields);

// Adds ∫ Bᵀ σ to rows of unknowns, for weighed stresses at the points of a cell.
void add_warping_force(const CellPoints& points, const PointFields& stresses, Eigen::MatrixXd& force);
// Adds ∫ Nᵀ Sᵀ σ, likewise.
void add_slope_force(const CellPoints& points, const PointFields& stresses, Eigen::MatrixXd& force);
// Adds ∫ (S Z)ᵀ σ to six rows, likewise.
void add_resultants(const CellPoints& points, const PointFields& stresses, Eigen::MatrixXd& resultants);

// A mesh ready to be integrated over. It keeps references to the mesh and the materials.
class SectionQuadrature {
  public:
    SectionQuadrature(const SectionMesh& mesh, std::span<const ElasticMaterial> materials);

    const SectionMesh& mesh() const { return mesh_; }
    const ElasticMaterial& material_of(const SectionCell& cell) const;
    const std::vector<CellPoints>& cells() const { return cells_; }
    Eigen::Index unknowns() const { return 3 * static_cast<Eigen::Index>(mesh_.nodes.size()); }

    // Computes a cell's data at its nodes.
    CellPoints at_nodes(const SectionCell& cell) const;

  private:
    CellPoints compute_points(const SectionCell& cell, const CellShapes& table) const;
    const ReferenceCell& reference(const SectionCell& cell) const;

    const SectionMesh& mesh_;
    std::span<const ElasticMaterial> materials_;
    std::map<std::pair<CellShape, int>, ReferenceCell> references_;
    std::vector<CellPoints> cells_;
};

}  // namespace gxrod
