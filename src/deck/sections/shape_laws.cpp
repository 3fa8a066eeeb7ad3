#include "deck/sections/shape_laws.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "cross_section/strength/section_fibres.hpp"
#include "deck/sections/shapes/cut_shape.hpp"
#include "deck/sections/shapes/shape_material.hpp"
#include "laws/shape_fibres.hpp"
#include "laws/shape_layers.hpp"

namespace gxrod {
namespace {

using SharedShapeLaw = std::shared_ptr<const SectionLaw>;

struct TubeRadii {
    double outer, inner;
};

// The radii of a circle or a tube.
std::optional<TubeRadii> find_radii(const ShapeLawSource& source) {
    const ShapeTable& shape = *source.given.shape;
    const auto find = [&](const TableHead& table, const ArcNumber& value) {
        return number_of(table, value, source.at, source.context);
    };
    if (const auto& circle = shape.circle) return TubeRadii{find(*circle, circle->radius), 0.0};
    if (const auto& tube = shape.tube)
        return TubeRadii{find(*tube, tube->outer_radius), find(*tube, tube->inner_radius)};
    return std::nullopt;
}

// The sides of a rectangle along y and z.
Eigen::Vector2d find_sides(const ShapeLawSource& source) {
    const RectangleTable& rectangle = *source.given.shape->rectangle;
    return {number_of(rectangle, rectangle.width_y, source.at, source.context),
            number_of(rectangle, rectangle.height_z, source.at, source.context)};
}

YieldingMaterial find_yielding(const MaterialTable& material, const ShapeLawSource& source) {
    const auto find = [&](const ArcNumber& value) {
        return number_of(material, value, source.at, source.context);
    };
    const double E = find(material.E);
    const double G = material.G ? find(*material.G) : E / (2.0 * (1.0 + find(*material.nu)));
    const YieldingMaterial yielding{E, G, find(*material.yield_stress)};
    constexpr double least_yield_strain = 1e-5;
    if (source.at.rod.empty() && yielding.yield_stress < least_yield_strain * E) {
        source.context.notes.push_back(fmt::format(
            "{}: it is {:.2g} of E, where metals have 1e-3 and lead 2e-4; are both in one unit of stress?",
            material.path_of(&material.yield_stress),
            yielding.yield_stress / E));
    }
    return yielding;
}

// Makes layers or fibres in place of all stiffness but that of shear.
SharedShapeLaw make_plain_law(const MaterialTable& material, const ShapeLawSource& source) {
    const Mat6& C = source.section.stiffness;
    const YieldingMaterial yielding = find_yielding(material, source);
    std::vector<Layer> layers;
    std::vector<Fibre> fibres;
    if (const std::optional<TubeRadii> radii = find_radii(source)) {
        layers = make_tube_layers(radii->outer, radii->inner, yielding);
        fibres = make_tube_fibres(radii->outer, radii->inner);
    } else {
        const Eigen::Vector2d sides = find_sides(source);
        layers = make_rectangle_layers(sides[0], sides[1], C(3, 3) / yielding.G, yielding);
        fibres = make_rectangle_fibres(sides[0], sides[1]);
    }
    Mat6 shear = Mat6::Zero();
    shear.block<2, 2>(1, 1) = C.block<2, 2>(1, 1);
    if (!material.interaction.value_or(false)) return std::make_shared<LayeredLaw>(shear, std::move(layers));
    std::erase_if(layers, [](const Layer& layer) { return layer.on != StrainPart::torsion; });
    return std::make_shared<FibreLaw>(
        LayeredLaw(shear, std::move(layers)), std::move(fibres), yielding.E, yielding.yield_stress);
}

// ∫ E (1, z, −y) ⊗ (1, z, −y) dA over fibres.
Mat3 sum_fibres(const std::vector<FibreGroup>& groups) {
    Mat3 sum = Mat3::Zero();
    for (const FibreGroup& group : groups) {
        for (const Fibre& fibre : group.fibres) {
            const Vec3 by_strain(1.0, fibre.z, -fibre.y);
            sum += group.E * fibre.area * by_strain * by_strain.transpose();
        }
    }
    return sum;
}

constexpr std::array<int, 3> fibre_strains{0, 4, 5};

Mat3 pick_fibre_strains(const Mat6& stiffness) {
    Mat3 picked;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) picked(i, j) = stiffness(fibre_strains[i], fibre_strains[j]);
    }
    return picked;
}

// Sections that vary along a rod have the fibres of the nearest station. They are moved so that their sum is
// the stiffness at hand: the map of (1, z, −y) is affine.
void fit_fibres(const Mat3& stiffness, std::vector<FibreGroup>& groups) {
    const Eigen::LLT<Mat3> wanted(stiffness), found(sum_fibres(groups));
    const Mat3 map = Mat3(wanted.matrixL()) * Mat3(found.matrixL()).inverse();
    const double area_factor = map(0, 0) * map(0, 0);
    for (FibreGroup& group : groups) {
        for (Fibre& fibre : group.fibres) {
            const Vec3 moved = map * Vec3(1.0, fibre.z, -fibre.y) / map(0, 0);
            fibre = {-moved[2], moved[1], area_factor * fibre.area};
        }
    }
}

// The materials of a section on cells, at the place at hand.
std::vector<ElasticMaterial> find_materials(const ShapeLawSource& source) {
    std::vector<ElasticMaterial> materials = source.section.shape->materials;
    if (is_plied(*source.given.shape)) return materials;
    if (const auto own = find_elastic_material(source.given, source.at, source.context))
        materials.front() = *own;
    return materials;
}

std::vector<FibreGroup> find_fibres(const ShapeLawSource& source) {
    const std::vector<ElasticMaterial> materials = find_materials(source);
    const SectionQuadrature quadrature(source.section.shape->mesh, source.section.shape->materials);
    std::vector<FibreGroup> groups(materials.size());
    for (std::size_t i = 0; i < materials.size(); ++i) {
        groups[i].E = 1.0 / materials[i].stiffness.inverse()(0, 0);
        groups[i].yield_stress =
            materials[i].yields ? *materials[i].yield_stress : std::numeric_limits<double>::infinity();
    }
    for (const SectionFibre& fibre : make_section_fibres(quadrature))
        groups[static_cast<std::size_t>(fibre.material)].fibres.push_back(
            {fibre.at.x(), fibre.at.y(), fibre.area});
    return groups;
}

// ∫ f |x − x₀| dA of fibres about the line that halves their force; x is z for the moment about y, else y.
double sum_plastic_moment(const std::vector<FibreGroup>& groups, bool is_about_y) {
    std::vector<std::pair<double, double>> forces;  // by place
    double all = 0.0, below = 0.0, moment = 0.0;
    for (const FibreGroup& group : groups) {
        for (const Fibre& fibre : group.fibres) {
            forces.emplace_back(is_about_y ? fibre.z : fibre.y, group.yield_stress * fibre.area);
            all += forces.back().second;
        }
    }
    std::ranges::sort(forces);
    for (const auto& [at, force] : forces) {
        const double above = std::clamp(below + force - 0.5 * all, 0.0, force);
        moment += at * (2.0 * above - force);
        below += force;
    }
    return moment;
}

// Notes plastic moments of fibres that are off, by coarse cells.
void note_plastic_moments(const std::vector<FibreGroup>& groups, const ShapeLawSource& source) {
    constexpr double worth_saying = 5e-3;
    const auto is_elastic = [](const FibreGroup& group) { return std::isinf(group.yield_stress); };
    if (std::ranges::any_of(groups, is_elastic)) return;
    const SectionQuadrature quadrature(source.section.shape->mesh, source.section.shape->materials);
    const std::optional<PlasticCapacity> exact = compute_plastic_capacity(quadrature);
    if (!exact) return;
    const double of_y = sum_plastic_moment(groups, true) / exact->moment_y - 1.0;
    const double of_z = sum_plastic_moment(groups, false) / exact->moment_z - 1.0;
    if (std::max(std::abs(of_y), std::abs(of_z)) < worth_saying) return;
    source.context.notes.push_back(fmt::format(
        "{}: plastic moments of its fibres are {:+.2g} and {:+.2g} of themselves off, about y and z; smaller "
        "cells would help",
        source.given.path,
        of_y,
        of_z));
}

// Fibres stretch and bend; torsion and shear stay elastic.
SharedShapeLaw make_cell_law(const ShapeLawSource& source) {
    for (const ElasticMaterial& material : source.section.shape->materials) {
        if (material.is_isotropic) continue;
        source.context.add_fault(
            source.given,
            source.given.shape,
            fmt::format("interaction goes with isotropic materials; \"{}\" has numbers by axis",
                        material.name));
        return nullptr;
    }
    const Mat6& C = source.section.stiffness;
    std::vector<FibreGroup> groups = find_fibres(source);
    const Mat3 bending = pick_fibre_strains(C);
    if (depends_on_place(source.given, source.context)) fit_fibres(bending, groups);
    const Vec3 scale = bending.diagonal().cwiseSqrt();
    const double error =
        ((sum_fibres(groups) - bending).array() / (scale * scale.transpose()).array()).abs().maxCoeff();
    constexpr double worth_saying = 1e-6;
    if (source.at.rod.empty() && error > worth_saying)
        source.context.notes.push_back(fmt::format(
            "{}: its fibres leave out that its materials hold each other across the rod: stiffness against "
            "extension and bending differs by {:.2g} of itself",
            source.given.path,
            error));
    if (source.at.rod.empty()) note_plastic_moments(groups, source);
    Mat6 rest = Mat6::Zero();
    rest.block<3, 3>(1, 1) = C.block<3, 3>(1, 1);
    return std::make_shared<FibreLaw>(LayeredLaw(rest, {}), groups);
}

bool has_yielding_cells(const CrossSection& section) {
    return std::ranges::any_of(section.mesh.cells, [&](const SectionCell& cell) {
        const int material = section.mesh.layers[static_cast<std::size_t>(cell.layer)].material;
        return section.materials[static_cast<std::size_t>(material)].yields;
    });
}

PlasticCapacity compute_plain_capacity(double yield_stress, const ShapeLawSource& source) {
    if (const std::optional<TubeRadii> radii = find_radii(source)) {
        const auto [outer, inner] = *radii;
        const double moment = 4.0 / 3.0 * yield_stress * (std::pow(outer, 3) - std::pow(inner, 3));
        return {.axial_force = M_PI * yield_stress * (outer - inner) * (outer + inner),
                .moment_y = moment,
                .moment_z = moment};
    }
    const Eigen::Vector2d sides = find_sides(source);
    const double force = yield_stress * sides.prod();
    return {.axial_force = force, .moment_y = 0.25 * force * sides[1], .moment_z = 0.25 * force * sides[0]};
}

}  // namespace

bool yields_by_shape(const ShapeLawSource& source) {
    if (!source.given.shape) return false;
    if (is_cut(source.given, source.context))
        return source.section.shape && has_yielding_cells(*source.section.shape);
    const std::optional<MaterialTable> material = find_shape_material(source.given, source.context);
    return material && material->yield_stress && !material->elastic.value_or(false);
}

std::shared_ptr<const SectionLaw> make_shape_law(const ShapeLawSource& source) {
    if (is_cut(source.given, source.context)) return make_cell_law(source);
    return make_plain_law(*find_shape_material(source.given, source.context), source);
}

std::optional<PlasticCapacity> find_plastic_capacity(const PlasticTable& law, const ShapeLawSource& source) {
    const auto refuse = [&](const std::string& message) {
        source.context.add_fault(law, law.yield, message);
        return std::nullopt;
    };
    const std::string needs_stress = "\"shape\" needs yield_stress of what the section is made of";
    if (!source.given.shape) return refuse("\"shape\" goes with a section that has a shape; expected limits");
    if (!is_cut(source.given, source.context)) {
        const std::optional<MaterialTable> material = find_shape_material(source.given, source.context);
        if (!material || !material->yield_stress) return refuse(needs_stress);
        return compute_plain_capacity(find_yielding(*material, source).yield_stress, source);
    }
    if (depends_on_place(source.given, source.context))
        return refuse(
            "\"shape\" goes with a shape that is the same along the rod; expected limits, which can be "
            "functions of s, or interaction = true of the material");
    if (!source.section.shape) return std::nullopt;  // at fault itself
    const SectionQuadrature quadrature(source.section.shape->mesh, source.section.shape->materials);
    std::optional<PlasticCapacity> capacity = compute_plastic_capacity(quadrature);
    return capacity ? capacity : refuse(needs_stress);
}

}  // namespace gxrod
