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

PointFields compute_strains(const CellPoints& points, const WarpingFields& fields) {
    const auto count = static_cast<Eigen::Index>(points.at.size());
    PointFields strains;
    strains.fill(Eigen::MatrixXd::Zero(count, fields.count()));
    if (fields.warping.size() > 0) {
        const Eigen::MatrixXd x = gather_component(*points.cell, fields.warping, 0);
        const Eigen::MatrixXd y = gather_component(*points.cell, fields.warping, 1);
        const Eigen::MatrixXd z = gather_component(*points.cell, fields.warping, 2);
        strains[1].noalias() += points.slopes_y * y;
        strains[2].noalias() += points.slopes_z * z;
        strains[3].noalias() += points.slopes_y * z;
        strains[3].noalias() += points.slopes_z * y;
        strains[4].noalias() += points.slopes_z * x;
        strains[5].noalias() += points.slopes_y * x;
    }
    if (fields.slope.size() > 0) {
        strains[0].noalias() += *points.shapes * gather_component(*points.cell, fields.slope, 0);
        strains[4].noalias() += *points.shapes * gather_component(*points.cell, fields.slope, 2);
        strains[5].noalias() += *points.shapes * gather_component(*points.cell, fields.slope, 1);
    }
    if (fields.strain.size() > 0) {
        const Eigen::MatrixXd& psi = fields.strain;
        for (Eigen::Index q = 0; q < count; ++q) {
            const PlanePoint& at = points.at[static_cast<std::size_t>(q)];
            strains[0].row(q) += psi.row(0) + at.y() * psi.row(4) - at.x() * psi.row(5);
            strains[4].row(q) += psi.row(2) + at.x() * psi.row(3);
            strains[5].row(q) += psi.row(1) - at.y() * psi.row(3);
        }
    }
    return strains;
}

PointFields compute_stresses(const CellPoints& points, const PointFields& strains, double factor) {
    PointFields stresses;
    stresses.fill(Eigen::MatrixXd::Zero(strains[0].rows(), strains[0].cols()));
    Eigen::VectorXd entries(strains[0].rows());
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
            for (Eigen::Index q = 0; q < entries.size(); ++q)
                entries[q] = factor * points.stiffness_at(static_cast<std::size_t>(q))(row, column);
            if (!entries.isZero(0.0)) stresses[i].noalias() += entries.asDiagonal() * strains[j];
        }
    }
    return stresses;
}

void weigh(const CellPoints& points, PointFields& fields) {
    const Eigen::Map<const Eigen::ArrayXd> weights(points.weights.data(),
                                                   static_cast<Eigen::Index>(points.weights.size()));
    for (Eigen::MatrixXd& field : fields) field.array().colwise() *= weights;
}

void add_warping_force(const CellPoints& points, const PointFields& stresses, Eigen::MatrixXd& force) {
    const auto add = [&](const Eigen::MatrixXd& along_y, const Eigen::MatrixXd& along_z, int component) {
        Eigen::MatrixXd rows = points.slopes_y.transpose() * along_y;
        rows.noalias() += points.slopes_z.transpose() * along_z;
        scatter_component(*points.cell, rows, component, force);
    };
    add(stresses[5], stresses[4], 0);
    add(stresses[1], stresses[3], 1);
    add(stresses[3], stresses[2], 2);
}

void add_slope_force(const CellPoints& points, const PointFields& stresses, Eigen::MatrixXd& force) {
    scatter_component(*points.cell, points.shapes->transpose() * stresses[0], 0, force);
    scatter_component(*points.cell, points.shapes->transpose() * stresses[5], 1, force);
    scatter_component(*points.cell, points.shapes->transpose() * stresses[4], 2, force);
}

void add_resultants(const CellPoints& points, const PointFields& stresses, Eigen::MatrixXd& resultants) {
    const auto& [xx, yy, zz, yz, xz, xy] = stresses;
    resultants.row(0) += xx.colwise().sum();
    resultants.row(1) += xy.colwise().sum();
    resultants.row(2) += xz.colwise().sum();
    for (Eigen::Index q = 0; q < xx.rows(); ++q) {
        const PlanePoint& at = points.at[static_cast<std::size_t>(q)];
        resultants.row(3) += at.x() * xz.row(q) - at.y() * xy.row(q);
        resultants.row(4) += at.y() * xx.row(q);
        resultants.row(5) -= at.x() * xx.row(q);
    }
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
