#include "check/summaries/shape_summary.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <set>

#include "cross_section/plastic_capacity.hpp"

namespace gxrod {
namespace {

// Compared with the size of a section.
constexpr double least_offset = 1e-9;
constexpr double of_homogeneous = 1e-12;

double clean(double value, double size) { return std::abs(value) < least_offset * size ? 0.0 : value; }

std::string describe_point(const PlanePoint& point, double size) {
    return fmt::format("({:.6g}, {:.6g})", clean(point.x(), size), clean(point.y(), size));
}

// The one isotropic material of a section, or nothing.
const ElasticMaterial* find_only_material(const CrossSection& section) {
    std::set<int> used;
    for (const SectionCell& cell : section.mesh.cells)
        used.insert(section.mesh.layers[static_cast<std::size_t>(cell.layer)].material);
    const ElasticMaterial& first = section.materials[static_cast<std::size_t>(*used.begin())];
    return used.size() == 1 && first.is_isotropic ? &first : nullptr;
}

std::string describe_mesh(const CrossSection& section) {
    const SectionMesh& mesh = section.mesh;
    const auto is_triangle = [](const SectionCell& cell) { return cell.shape == CellShape::triangle; };
    const auto triangles = std::ranges::count_if(mesh.cells, is_triangle);
    const auto quads = static_cast<std::ptrdiff_t>(mesh.cells.size()) - triangles;
    std::string cells;
    if (triangles > 0) cells = fmt::format("{} triangles", triangles);
    if (quads > 0) cells += fmt::format("{}{} quadrilaterals", cells.empty() ? "" : " and ", quads);
    return fmt::format("{} of order {}, {} unknowns", cells, mesh.cells.front().order, 3 * mesh.nodes.size());
}

struct Reach {
    PlanePoint least, most;
};

Reach find_reach(const SectionMesh& mesh) {
    Reach reach{mesh.nodes.front(), mesh.nodes.front()};
    for (const PlanePoint& node : mesh.nodes) {
        reach.least = reach.least.cwiseMin(node);
        reach.most = reach.most.cwiseMax(node);
    }
    return reach;
}

// Second moments and section moduli about the centroid.
std::string describe_bending(const SectionProperties& properties, const Reach& reach) {
    const PlanePoint farthest =
        (reach.most - properties.centroid).cwiseMax(properties.centroid - reach.least);
    const double size = farthest.maxCoeff();
    std::string text =
        fmt::format("Iy {:.6g}, Iz {:.6g}", properties.second_moment_y, properties.second_moment_z);
    if (std::abs(properties.product_moment) > least_offset * properties.area * size * size)
        text += fmt::format(", Iyz {:.6g}", properties.product_moment);
    return text + fmt::format("; Wy {:.6g}, Wz {:.6g}",
                              properties.second_moment_y / farthest.y(),
                              properties.second_moment_z / farthest.x());
}

std::string describe_torsion(const CrossSection& section, const ElasticMaterial* material) {
    const SectionProperties& properties = section.properties;
    const double torsion = 1.0 / properties.stiffness.inverse()(3, 3);
    // Compared with a section of the same stiffness and of a warping that reaches as far as it is large.
    const double length = properties.warping_length();
    const bool warps = length * length > of_homogeneous * properties.area;
    const double stiffness = warps ? properties.warping_stiffness : 0.0;
    const std::string reach =
        fmt::format("restrained warping reaches {:.4g} along the rod", warps ? length : 0.0);
    if (material == nullptr) return fmt::format("torsion {:.6g}; E Iw {:.6g}, {}", torsion, stiffness, reach);
    const double G = material->stiffness(5, 5);
    return fmt::format("It {:.6g}, Iw {:.6g}; {}", torsion / G, stiffness / properties.stiffest, reach);
}

std::string describe_capacity(const CrossSection& section) {
    const SectionQuadrature quadrature(section.mesh, section.materials);
    const std::optional<PlasticCapacity> capacity = compute_plastic_capacity(quadrature);
    if (!capacity) return "";
    return fmt::format("  yields as a whole at N {:.6g}, My {:.6g} or Mz {:.6g}\n",
                       capacity->axial_force,
                       capacity->moment_y,
                       capacity->moment_z);
}

}  // namespace

std::string describe_shape(const CrossSection& section) {
    const SectionProperties& properties = section.properties;
    const Reach reach = find_reach(section.mesh);
    const double size = (reach.most - reach.least).maxCoeff();
    std::string text = fmt::format("  shape: {}, {}\n", section.source, describe_mesh(section));
    text += fmt::format("  {:.6g} along y, {:.6g} along z; A {:.6g}, centroid {}, {}\n",
                        reach.most.x() - reach.least.x(),
                        reach.most.y() - reach.least.y(),
                        properties.area,
                        describe_point(properties.centroid, size),
                        describe_bending(properties, reach));
    text += fmt::format("  {}\n", describe_torsion(section, find_only_material(section)));
    if (!section.mesh.sharp_corners.empty()) {
        text += fmt::format(
            "  {} re-entrant corners without a radius: stresses there have no bound and are left out\n",
            section.mesh.sharp_corners.size());
    }
    return text + describe_capacity(section);
}

}  // namespace gxrod
