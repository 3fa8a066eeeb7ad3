#include "cross_section/walls/solid_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "cross_section/walls/graded_line.hpp"
#include "cross_section/walls/quad_grid.hpp"

namespace gxrod {
namespace {

constexpr double quarter_turn = 0.5 * std::numbers::pi;

int refined(double cells, const SolidMeshSettings& settings) {
    return std::max(1, static_cast<int>(std::ceil(cells * settings.refinement - 1e-6)));
}

PlanePoint at_angle(double angle, double radius) {
    return radius * PlanePoint(std::cos(angle), std::sin(angle));
}

SectionMesh make_grid_mesh(const QuadGrid& grid) {
    SectionMesh mesh;
    mesh.layers.push_back({.name = "shape"});
    const int nodes = grid.columns() * grid.rows();
    mesh.nodes.resize(static_cast<std::size_t>(nodes));
    for (int along = 0; along < grid.cells_along; ++along) {
        for (int across = 0; across < grid.cells_across; ++across)
            mesh.cells.push_back(grid.cell_at(along, across));
    }
    return mesh;
}

// Places the nodes of a lattice by fractions of element ends.
std::vector<double> place_nodes(const std::vector<double>& ends, int order) {
    std::vector<double> nodes{ends.front()};
    for (std::size_t i = 1; i < ends.size(); ++i) {
        for (int k = 1; k <= order; ++k) nodes.push_back(ends[i - 1] + (ends[i] - ends[i - 1]) * k / order);
    }
    return nodes;
}

// The core of a circle is a square whose sides bulge: half-way between straight and round.
constexpr double core_size = 0.5;  // its corners, over the radius
constexpr double core_bulge = 0.5;

// Returns a point of the core for a place in the square from −1 to 1.
PlanePoint place_in_core(double u, double v, double radius) {
    const double half = core_size / std::numbers::sqrt2;
    // A side of a square with corners on a circle would be that much farther out at its middle if it were
    // round.
    const double bulge = core_bulge * (core_size - half);
    return radius * PlanePoint(u * (half + bulge * (1.0 - v * v)), v * (half + bulge * (1.0 - u * u)));
}

// Returns a point of the square's edge, from its lower right corner on anticlockwise; `around` goes from 0
// to 4.
PlanePoint place_on_square(double around) {
    const int side = std::min(3, static_cast<int>(around));
    const double along = 2.0 * (around - side) - 1.0;
    switch (side) {
        case 0:
            return {1.0, along};
        case 1:
            return {-along, 1.0};
        case 2:
            return {-1.0, -along};
        default:
            return {along, -1.0};
    }
}

// Returns the column of a ring at a place of the edge of its core; −1 within the core. Column 0 is at the
// lower right corner.
int find_ring_column(int i, int j, int last) {
    if (i == last) return j;
    if (j == last) return 2 * last - i;
    if (i == 0) return 3 * last - j;
    return j == 0 ? 3 * last + i : -1;
}

// Adds the core of a circle, whose edge is the inner row of the ring.
void add_core(const QuadGrid& ring, int side, double radius, SectionMesh& mesh) {
    const QuadGrid core{.order = ring.order, .cells_along = side, .cells_across = side};
    const int last = side * ring.order;
    std::vector<int> numbers(static_cast<std::size_t>(core.columns() * core.rows()));
    for (int i = 0; i <= last; ++i) {
        for (int j = 0; j <= last; ++j) {
            int& number = numbers[static_cast<std::size_t>(core.node(i, j))];
            const int column = find_ring_column(i, j, last);
            if (column >= 0) {
                number = ring.node(column, ring.rows() - 1);
            } else {
                number = static_cast<int>(mesh.nodes.size());
                mesh.nodes.push_back(place_in_core(2.0 * i / last - 1.0, 2.0 * j / last - 1.0, radius));
            }
        }
    }
    for (int along = 0; along < side; ++along) {
        for (int across = 0; across < side; ++across) {
            SectionCell cell = core.cell_at(along, across);
            for (int& node : cell.nodes) node = numbers[static_cast<std::size_t>(node)];
            mesh.cells.push_back(std::move(cell));
        }
    }
}

}  // namespace

SectionMesh mesh_rectangle(double width_y, double height_z, const SolidMeshSettings& settings) {
    const double least = std::min(width_y, height_z) / settings.refinement;
    // Each half alike, so that there are nodes on both axes, where shear stresses are largest.
    const auto places = [&](double length) {
        const LineGrading grading{.at_start = 0.15 * least,
                                  .at_end = length,
                                  .growth = 0.5 / settings.refinement,
                                  .largest = 0.25 * length / settings.refinement};
        std::vector<double> ends = grade_line(0.5 * length, grading);
        for (double& end : ends) end *= 0.5;
        for (std::size_t i = ends.size() - 1; i-- > 0;) ends.push_back(1.0 - ends[i]);
        return place_nodes(ends, settings.order);
    };
    const std::vector<double> y = places(width_y), z = places(height_z);
    const auto cells = [&](const std::vector<double>& nodes) {
        return static_cast<int>(nodes.size() - 1) / settings.order;
    };
    const QuadGrid grid{.order = settings.order, .cells_along = cells(y), .cells_across = cells(z)};
    SectionMesh mesh = make_grid_mesh(grid);
    for (int i = 0; i < grid.columns(); ++i) {
        for (int j = 0; j < grid.rows(); ++j) {
            mesh.nodes[static_cast<std::size_t>(grid.node(i, j))] = {
                (y[static_cast<std::size_t>(i)] - 0.5) * width_y,
                (z[static_cast<std::size_t>(j)] - 0.5) * height_z};
        }
    }
    return mesh;
}

SectionMesh mesh_tube(double outer_radius, double inner_radius, const SolidMeshSettings& settings) {
    const double thickness = outer_radius - inner_radius;
    // Radii grow by at most two thirds across a row.
    const double rows = std::max(1.0, std::log(outer_radius / inner_radius) / std::log(5.0 / 3.0));
    const QuadGrid grid{.order = settings.order,
                        .cells_along = refined(24.0, settings),
                        .cells_across = refined(std::ceil(rows), settings),
                        .is_ring = true};
    SectionMesh mesh = make_grid_mesh(grid);
    for (int i = 0; i < grid.columns(); ++i) {
        for (int j = 0; j < grid.rows(); ++j) {
            mesh.nodes[static_cast<std::size_t>(grid.node(i, j))] = at_angle(
                4.0 * quarter_turn * i / grid.columns(), outer_radius - thickness * j / (grid.rows() - 1));
        }
    }
    return mesh;
}

SectionMesh mesh_circle(double radius, const SolidMeshSettings& settings) {
    // An even number puts nodes on both axes, where bending stresses are largest.
    const int side = 2 * refined(3.0, settings), order = settings.order;
    const QuadGrid ring{
        .order = order, .cells_along = 4 * side, .cells_across = refined(2.0, settings), .is_ring = true};
    SectionMesh mesh = make_grid_mesh(ring);
    for (int i = 0; i < ring.columns(); ++i) {
        const double around = 4.0 * i / ring.columns();
        const PlanePoint on_square = place_on_square(around);
        const PlanePoint inner = place_in_core(on_square.x(), on_square.y(), radius);
        const PlanePoint outer = at_angle((around - 0.5) * quarter_turn, radius);
        for (int j = 0; j < ring.rows(); ++j) {
            const double inwards = static_cast<double>(j) / (ring.rows() - 1);
            mesh.nodes[static_cast<std::size_t>(ring.node(i, j))] = outer + inwards * (inner - outer);
        }
    }
    add_core(ring, side, radius, mesh);
    return mesh;
}

}  // namespace gxrod
