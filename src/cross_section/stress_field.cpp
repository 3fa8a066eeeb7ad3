#include "cross_section/stress_field.hpp"

#include <map>

namespace gxrod {
namespace {

// Compared with the largest of a cell: at a corner whose two sides lie on one smooth curve the map is flat,
// and has no derivatives.
constexpr double least_determinant = 1e-2;

bool is_in_reach(const std::vector<SharpCorner>& corners, const PlanePoint& at) {
    return std::ranges::any_of(
        corners, [&](const SharpCorner& corner) { return (at - corner.at).norm() <= corner.reach; });
}

// Points by node and layer, and how many cells are added up at each.
class PointGathering {
  public:
    PointGathering(const SectionMesh& mesh, StressField& field) : mesh_(mesh), field_(field) {}

    // Returns the index of the point of a node in a layer; without an operator, the cell has no say in it.
    int add(int node, int layer, const PlanePoint& wall, const Mat6* stress_operator) {
        const auto [place, is_new] =
            index_.try_emplace({node, layer}, static_cast<int>(field_.points.size()));
        if (is_new) {
            const PlanePoint& at = mesh_.nodes[static_cast<std::size_t>(node)];
            field_.points.push_back(
                {at, layer, PlanePoint::Zero(), Mat6::Zero(), is_in_reach(mesh_.sharp_corners, at)});
            counts_.push_back(0);
        }
        const auto index = static_cast<std::size_t>(place->second);
        field_.points[index].wall += wall;
        if (stress_operator != nullptr) {
            field_.points[index].stress_operator += *stress_operator;
            ++counts_[index];
        }
        return place->second;
    }

    void take_means() {
        for (std::size_t i = 0; i < counts_.size(); ++i) {
            if (counts_[i] > 0) {
                field_.points[i].stress_operator /= counts_[i];
            } else {
                field_.points[i].is_singular = true;
            }
            field_.points[i].wall.normalize();
        }
    }

  private:
    const SectionMesh& mesh_;
    StressField& field_;
    std::map<std::pair<int, int>, int> index_;
    std::vector<int> counts_;
};

}  // namespace

StressField compute_stress_field(const SectionQuadrature& quadrature, const CentralSolutions& solutions) {
    StressField field;
    PointGathering gathering(quadrature.mesh(), field);
    for (const SectionCell& cell : quadrature.mesh().cells) {
        const CellPoints points = quadrature.at_nodes(cell);
        const std::vector<Mat6> strains = compute_strain_operators(points, solutions);
        std::vector<int> indices;
        const double flat = least_determinant * *std::ranges::max_element(points.weights);
        for (std::size_t i = 0; i < strains.size(); ++i) {
            const Mat6 stress_operator = points.stiffness_at(i) * strains[i];
            indices.push_back(gathering.add(cell.nodes[i],
                                            cell.layer,
                                            points.walls[i],
                                            points.weights[i] > flat ? &stress_operator : nullptr));
        }
        field.points_of_cells.push_back(std::move(indices));
    }
    gathering.take_means();
    return field;
}

Mat6 integrate_stresses(const SectionQuadrature& quadrature, const CentralSolutions& solutions) {
    Mat6 sum = Mat6::Zero();
    for (const CellPoints& points : quadrature.cells()) {
        const std::vector<Mat6> strains = compute_strain_operators(points, solutions);
        for (std::size_t q = 0; q < strains.size(); ++q) {
            sum += points.weights[q] * compute_slice_strains(points.at[q]).transpose() *
                   points.stiffness_at(q) * strains[q];
        }
    }
    return sum;
}

}  // namespace gxrod
