#pragma once

#include <vector>

#include "cross_section/elastic_material.hpp"
#include "cross_section/section_mesh.hpp"

// Meshes of quadrilaterals for tests.
namespace gxrod {

// How many cells along each side, and their order.
struct Cutting {
    int first, second, order;
};

// A block of cells whose corner nodes' coordinates (a, b) from 0 to 1 a function takes to the section.
template <class Map>
SectionMesh make_block(const Cutting& cutting, bool is_closed, const Map& map) {
    SectionMesh mesh;
    mesh.layers = {{.name = "all", .material = 0, .fibre_angle = 0.0}};
    const int p = cutting.order;
    const int rows = cutting.second * p + 1;
    const int columns = cutting.first * p + (is_closed ? 0 : 1);
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j)
            mesh.nodes.push_back(
                map(static_cast<double>(i) / (cutting.first * p), static_cast<double>(j) / (rows - 1)));
    }
    for (int e = 0; e < cutting.first; ++e) {
        for (int f = 0; f < cutting.second; ++f) {
            SectionCell cell{.shape = CellShape::quad, .order = p, .layer = 0, .nodes = {}, .walls = {}};
            for (int b = 0; b <= p; ++b) {
                for (int a = 0; a <= p; ++a) cell.nodes.push_back(((e * p + a) % columns) * rows + f * p + b);
            }
            mesh.cells.push_back(cell);
        }
    }
    return mesh;
}

inline SectionMesh make_rectangle(double width, double height, const Cutting& cutting) {
    return make_block(cutting, false, [&](double a, double b) {
        return PlanePoint(width * (a - 0.5), height * (b - 0.5));
    });
}

// From one angle to another, from the outside in; a whole turn is closed.
struct RingShape {
    double outer, inner, from, to;
    bool is_closed;
};

inline SectionMesh make_ring(const RingShape& ring, const Cutting& cutting) {
    return make_block(cutting, ring.is_closed, [&](double a, double b) {
        const double angle = ring.from + (ring.to - ring.from) * a;
        const double radius = ring.outer + (ring.inner - ring.outer) * b;
        return PlanePoint(radius * std::cos(angle), radius * std::sin(angle));
    });
}

inline ElasticMaterial isotropic(double E, double nu) {
    ElasticMaterial material;
    material.stiffness = compute_isotropic_stiffness(E, nu);
    return material;
}

// Cuts a rectangle into triangles: each quadrilateral of even lattice into two.
inline SectionMesh cut_into_triangles(const SectionMesh& quads) {
    SectionMesh mesh = quads;
    mesh.cells.clear();
    for (const SectionCell& quad : quads.cells) {
        const int p = quad.order;
        const auto node = [&](int a, int b) { return quad.nodes[static_cast<std::size_t>(b * (p + 1) + a)]; };
        SectionCell lower{
            .shape = CellShape::triangle, .order = p, .layer = quad.layer, .nodes = {}, .walls = {}};
        SectionCell upper = lower;
        for (int j = 0; j <= p; ++j) {
            for (int i = 0; i + j <= p; ++i) {
                lower.nodes.push_back(node(i, j));
                upper.nodes.push_back(node(p - i, p - j));
            }
        }
        mesh.cells.push_back(lower);
        mesh.cells.push_back(upper);
    }
    return mesh;
}

}  // namespace gxrod
