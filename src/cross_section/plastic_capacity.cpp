#include "cross_section/plastic_capacity.hpp"

#include <algorithm>

namespace gxrod {
namespace {

// ∫ f dA and ∫ f x dA of what lies above a line x = level, of a coordinate x.
struct PartSums {
    double force = 0.0, moment = 0.0;

    void add(double area_force, double at) {
        force += area_force;
        moment += area_force * at;
    }
};

struct YieldingCell {
    const CellPoints* points;
    double yield_stress;
    std::vector<PlanePoint> corners;  // of straight triangles that fill it, three each
    double least[2], most[2];         // along y and z
};

// Cuts a cell into straight triangles between points of a lattice finer than that of its nodes.
std::vector<PlanePoint> cut_cell(const SectionMesh& mesh, const SectionCell& cell) {
    const int parts = cell.order == 1 ? 1 : 4 * cell.order;
    const CellShapes table = compute_cell_shapes(cell.shape, cell.order, list_lattice(cell.shape, parts));
    std::vector<PlanePoint> lattice(static_cast<std::size_t>(table.values.rows()), PlanePoint::Zero());
    for (std::size_t p = 0; p < lattice.size(); ++p) {
        for (std::size_t i = 0; i < cell.nodes.size(); ++i)
            lattice[p] += table.values(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(i)) *
                          mesh.nodes[static_cast<std::size_t>(cell.nodes[i])];
    }
    std::vector<PlanePoint> corners;
    std::size_t row = 0;
    for (int j = 0; j < parts; ++j) {
        const int width = cell.shape == CellShape::triangle ? parts - j : parts;  // pieces in this row
        const std::size_t next = row + static_cast<std::size_t>(width) + 1;
        for (int i = 0; i < width; ++i) {
            const auto k = static_cast<std::size_t>(i);
            for (const std::size_t corner : {row + k, row + k + 1, next + k})
                corners.push_back(lattice[corner]);
            if (cell.shape == CellShape::triangle && i + 1 == width) continue;
            for (const std::size_t corner : {row + k + 1, next + k + 1, next + k})
                corners.push_back(lattice[corner]);
        }
        row = next;
    }
    return corners;
}

// Adds the part of a triangle above the level: clipped, and summed as a fan.
void add_triangle(const PlanePoint* corners, int axis, double level, double yield_stress, PartSums& sums) {
    std::vector<PlanePoint> kept;
    for (int i = 0; i < 3; ++i) {
        const PlanePoint& a = corners[i];
        const PlanePoint& b = corners[(i + 1) % 3];
        if (a[axis] >= level) kept.push_back(a);
        if ((a[axis] < level) != (b[axis] < level))
            kept.push_back(a + (level - a[axis]) / (b[axis] - a[axis]) * (b - a));
    }
    for (std::size_t i = 2; i < kept.size(); ++i) {
        const PlanePoint u = kept[i - 1] - kept[0], v = kept[i] - kept[0];
        const double area = 0.5 * (u.x() * v.y() - u.y() * v.x());
        sums.add(yield_stress * area, (kept[0][axis] + kept[i - 1][axis] + kept[i][axis]) / 3.0);
    }
}

PartSums sum_above(const std::vector<YieldingCell>& cells, int axis, double level) {
    PartSums sums;
    for (const YieldingCell& cell : cells) {
        if (cell.most[axis] <= level) continue;
        if (cell.least[axis] >= level) {
            for (std::size_t q = 0; q < cell.points->at.size(); ++q)
                sums.add(cell.yield_stress * cell.points->weights[q], cell.points->at[q][axis]);
            continue;
        }
        for (std::size_t i = 0; i + 2 < cell.corners.size(); i += 3)
            add_triangle(&cell.corners[i], axis, level, cell.yield_stress, sums);
    }
    return sums;
}

// ∫ f |x − x₀| dA about the level x₀ that halves the force.
double compute_plastic_moment(const std::vector<YieldingCell>& cells, int axis) {
    double low = cells.front().least[axis], high = cells.front().most[axis];
    for (const YieldingCell& cell : cells) {
        low = std::min(low, cell.least[axis]);
        high = std::max(high, cell.most[axis]);
    }
    const PartSums all = sum_above(cells, axis, low);
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (sum_above(cells, axis, middle).force > 0.5 * all.force ? low : high) = middle;
    }
    const PartSums above = sum_above(cells, axis, low);
    return 2.0 * above.moment - all.moment - low * (2.0 * above.force - all.force);
}

}  // namespace

std::optional<PlasticCapacity> compute_plastic_capacity(const SectionQuadrature& quadrature) {
    std::vector<YieldingCell> cells;
    PlasticCapacity capacity;
    for (const CellPoints& points : quadrature.cells()) {
        const ElasticMaterial& material = quadrature.material_of(*points.cell);
        if (!material.yield_stress) return std::nullopt;
        YieldingCell cell{&points, *material.yield_stress, cut_cell(quadrature.mesh(), *points.cell), {}, {}};
        for (const int axis : {0, 1}) {
            const auto along = [axis](const PlanePoint& a, const PlanePoint& b) { return a[axis] < b[axis]; };
            const auto [least, most] = std::minmax_element(cell.corners.begin(), cell.corners.end(), along);
            cell.least[axis] = (*least)[axis];
            cell.most[axis] = (*most)[axis];
        }
        for (std::size_t q = 0; q < points.weights.size(); ++q) {
            capacity.axial_force += cell.yield_stress * points.weights[q];
            capacity.centre += cell.yield_stress * points.weights[q] * points.at[q];
        }
        cells.push_back(std::move(cell));
    }
    capacity.centre /= capacity.axial_force;
    capacity.moment_y = compute_plastic_moment(cells, 1);
    capacity.moment_z = compute_plastic_moment(cells, 0);
    return capacity;
}

}  // namespace gxrod
