#include "cross_section/section_quadrature.hpp"

namespace gxrod {
namespace {

// Rows 3 node + component of the unknowns of a cell.
Eigen::MatrixXd gather_component(const SectionCell& cell, const Eigen::MatrixXd& unknowns, int component) {
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(cell.nodes.size()), unknowns.cols());
    for (std::size_t i = 0; i < cell.nodes.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)) = unknowns.row(3 * cell.nodes[i] + component);
    return rows;
}

void scatter_component(const SectionCell& cell,
                       const Eigen::MatrixXd& rows,
                       int component,
                       Eigen::MatrixXd& all) {
    for (std::size_t i = 0; i < cell.nodes.size(); ++i)
        all.row(3 * cell.nodes[i] + component) += rows.row(static_cast<Eigen::Index>(i));
}

// One component of stress at each point, times the weight: a row for each point.
Eigen::MatrixXd weigh_component(const CellPoints& points,
                                const std::vector<StrainColumns>& stresses,
                                int component) {
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(stresses.size()), stresses.front().cols());
    for (std::size_t q = 0; q < stresses.size(); ++q)
        rows.row(static_cast<Eigen::Index>(q)) = points.weights[q] * stresses[q].row(component);
    return rows;
}

void add_row(const Eigen::MatrixXd& of_points, int component, std::vector<StrainColumns>& strains) {
    for (std::size_t q = 0; q < strains.size(); ++q)
        strains[q].row(component) += of_points.row(static_cast<Eigen::Index>(q));
}

PlanePoint unit(const PlanePoint& vector) { return vector / vector.norm(); }

}  // namespace

Eigen::Index WarpingFields::count() const { return std::max({warping.cols(), slope.cols(), strain.cols()}); }

Mat6 compute_slice_strains(const PlanePoint& at) {
    Mat6 strains = Mat6::Zero();
    strains(0, 0) = 1.0;
    strains(0, 4) = at.y();  // the coordinate z
    strains(0, 5) = -at.x();
    strains(4, 2) = 1.0;
    strains(4, 3) = at.x();
    strains(5, 1) = 1.0;
    strains(5, 3) = -at.y();
    return strains;
}

std::vector<StrainColumns> compute_strains(const CellPoints& points, const WarpingFields& fields) {
    std::vector<StrainColumns> strains(points.at.size(), StrainColumns::Zero(6, fields.count()));
    if (fields.warping.size() > 0) {
        const Eigen::MatrixXd x = gather_component(*points.cell, fields.warping, 0);
        const Eigen::MatrixXd y = gather_component(*points.cell, fields.warping, 1);
        const Eigen::MatrixXd z = gather_component(*points.cell, fields.warping, 2);
        add_row(points.slopes_y * y, 1, strains);
        add_row(points.slopes_z * z, 2, strains);
        add_row(points.slopes_y * z + points.slopes_z * y, 3, strains);
        add_row(points.slopes_z * x, 4, strains);
        add_row(points.slopes_y * x, 5, strains);
    }
    if (fields.slope.size() > 0) {
        add_row(*points.shapes * gather_component(*points.cell, fields.slope, 0), 0, strains);
        add_row(*points.shapes * gather_component(*points.cell, fields.slope, 2), 4, strains);
        add_row(*points.shapes * gather_component(*points.cell, fields.slope, 1), 5, strains);
    }
    if (fields.strain.size() > 0) {
        for (std::size_t q = 0; q < strains.size(); ++q)
            strains[q] += compute_slice_strains(points.at[q]) * fields.strain;
    }
    return strains;
}

void add_warping_force(const CellPoints& points,
                       const std::vector<StrainColumns>& stresses,
                       Eigen::MatrixXd& force) {
    const Eigen::MatrixXd yy = weigh_component(points, stresses, 1);
    const Eigen::MatrixXd zz = weigh_component(points, stresses, 2);
    const Eigen::MatrixXd yz = weigh_component(points, stresses, 3);
    const Eigen::MatrixXd xz = weigh_component(points, stresses, 4);
    const Eigen::MatrixXd xy = weigh_component(points, stresses, 5);
    scatter_component(
        *points.cell, points.slopes_y.transpose() * xy + points.slopes_z.transpose() * xz, 0, force);
    scatter_component(
        *points.cell, points.slopes_y.transpose() * yy + points.slopes_z.transpose() * yz, 1, force);
    scatter_component(
        *points.cell, points.slopes_y.transpose() * yz + points.slopes_z.transpose() * zz, 2, force);
}

void add_slope_force(const CellPoints& points,
                     const std::vector<StrainColumns>& stresses,
                     Eigen::MatrixXd& force) {
    scatter_component(
        *points.cell, points.shapes->transpose() * weigh_component(points, stresses, 0), 0, force);
    scatter_component(
        *points.cell, points.shapes->transpose() * weigh_component(points, stresses, 5), 1, force);
    scatter_component(
        *points.cell, points.shapes->transpose() * weigh_component(points, stresses, 4), 2, force);
}

SectionQuadrature::SectionQuadrature(const SectionMesh& mesh, std::span<const ElasticMaterial> materials)
    : mesh_(mesh), materials_(materials) {
    for (const SectionCell& cell : mesh.cells)
        references_.try_emplace({cell.shape, cell.order}, cell.shape, cell.order);
    cells_.reserve(mesh.cells.size());
    for (const SectionCell& cell : mesh.cells) {
        const ReferenceCell& common = reference(cell);
        cells_.push_back(compute_points(cell, common.at_points));
        for (std::size_t q = 0; q < common.quadrature.weights.size(); ++q)
            cells_.back().weights[q] *= common.quadrature.weights[q];
    }
}

const ReferenceCell& SectionQuadrature::reference(const SectionCell& cell) const {
    return references_.at({cell.shape, cell.order});
}

const ElasticMaterial& SectionQuadrature::material_of(const SectionCell& cell) const {
    return materials_[static_cast<std::size_t>(mesh_.layers[static_cast<std::size_t>(cell.layer)].material)];
}

CellPoints SectionQuadrature::at_nodes(const SectionCell& cell) const {
    return compute_points(cell, reference(cell).at_nodes);
}

CellPoints SectionQuadrature::compute_points(const SectionCell& cell, const CellShapes& table) const {
    Eigen::MatrixX2d nodes(static_cast<Eigen::Index>(cell.nodes.size()), 2);
    for (std::size_t i = 0; i < cell.nodes.size(); ++i)
        nodes.row(static_cast<Eigen::Index>(i)) = mesh_.nodes[static_cast<std::size_t>(cell.nodes[i])];
    const Eigen::MatrixX2d at = table.values * nodes;
    const Eigen::MatrixX2d along_1 = table.slopes_1 * nodes;
    const Eigen::MatrixX2d along_2 = table.slopes_2 * nodes;
    CellPoints points{
        .cell = &cell, .shapes = &table.values, .slopes_y = table.slopes_1, .slopes_z = table.slopes_2};
    const double fibre_angle = mesh_.layers[static_cast<std::size_t>(cell.layer)].fibre_angle;
    const ElasticMaterial& material = material_of(cell);
    const bool turns = !material.is_isotropic && !cell.walls.empty();
    for (Eigen::Index q = 0; q < at.rows(); ++q) {
        const double determinant = along_1(q, 0) * along_2(q, 1) - along_1(q, 1) * along_2(q, 0);
        points.at.emplace_back(at.row(q));
        points.weights.push_back(determinant);
        points.slopes_y.row(q) =
            (along_2(q, 1) * table.slopes_1.row(q) - along_1(q, 1) * table.slopes_2.row(q)) / determinant;
        points.slopes_z.row(q) =
            (along_1(q, 0) * table.slopes_2.row(q) - along_2(q, 0) * table.slopes_1.row(q)) / determinant;
        PlanePoint wall = PlanePoint::Zero();
        for (std::size_t i = 0; i < cell.walls.size(); ++i)
            wall += table.values(q, static_cast<Eigen::Index>(i)) * cell.walls[i];
        points.walls.push_back(cell.walls.empty() ? PlanePoint::UnitX() : unit(wall));
        if (turns)
            points.stiffness.push_back(turn_stiffness(material.stiffness, fibre_angle, points.walls.back()));
    }
    if (!turns) {
        points.stiffness.push_back(
            material.is_isotropic ? material.stiffness
                                  : turn_stiffness(material.stiffness, fibre_angle, PlanePoint::UnitX()));
    }
    return points;
}

}  // namespace gxrod
