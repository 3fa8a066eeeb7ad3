#include "deck/sections/build_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "deck/schema/schema_tables.hpp"
#include "deck/sections/build_law.hpp"
#include "deck/sections/section_matrices.hpp"
#include "deck/sections/section_shape.hpp"
#include "deck/surroundings/section_fluid.hpp"
#include "model/evaluation_error.hpp"
#include "model/sections/section_frame.hpp"

namespace gxrod {
namespace {

const CheckedTable& only(const CheckedTable& table, const char* key) { return table.tables(key).front(); }

Mat6 diagonal(const Vec3& translation, const Vec3& rotation) {
    Mat6 matrix = Mat6::Zero();
    matrix.diagonal() << translation, rotation;
    return matrix;
}

// Of a key of a table in "section.NAME.….…".
const Range& range_of(const CheckedTable& table, const char* key) {
    const TableSpec* spec = &section_table();
    std::istringstream path(table.path);
    std::string part;
    for (int i = 0; std::getline(path, part, '.'); ++i) {
        if (i > 1) spec = spec->find(part)->table;
    }
    return spec->find(key)->range;
}

Mat6 stiffness_of(const CheckedTable& stiffness, const SectionPlace& at, const BuildContext& context) {
    const auto c = [&](const char* key) { return number_of(stiffness, key, at, context); };
    return diagonal({c("EA"), c("GAy"), c("GAz")}, {c("GJ"), c("EIy"), c("EIz")});
}

// rhoIy and rhoIz, that a static analysis can do without, and a dynamic one cannot.
double find_rotary_inertia(const CheckedTable& inertia,
                           const char* key,
                           const SectionPlace& at,
                           const BuildContext& context) {
    if (inertia.gives(key)) return number_of(inertia, key, at, context);
    if (context.needs_inertia()) {
        const KeySpec& spec = *section_table().find("inertia")->table->find(key);
        context.add_fault(
            inertia, key, fmt::format("missing; expected {}; {}", describe_expected(spec), no_inertia));
    }
    return 0.0;
}

Mat6 mass_of(const CheckedTable& inertia, const SectionPlace& at, const BuildContext& context) {
    const double rhoA = number_of(inertia, "rhoA", at, context);
    const double rhoIy = find_rotary_inertia(inertia, "rhoIy", at, context);
    const double rhoIz = find_rotary_inertia(inertia, "rhoIz", at, context);
    const double rhoJ = inertia.gives("rhoJ") ? number_of(inertia, "rhoJ", at, context) : rhoIy + rhoIz;
    return diagonal(Vec3::Constant(rhoA), {rhoJ, rhoIy, rhoIz});
}

using MatrixCheck = std::optional<MatrixFault>(Mat6&);

Mat6 matrix_of(const CheckedTable& section,
               const char* key,
               MatrixCheck& check,
               const BuildContext& context) {
    Mat6 matrix = section.get<Mat6>(key);
    const std::optional<MatrixFault> fault = check(matrix);
    if (fault) context.faults.add(section.place_of(key), section.path_of(key) + fault->entry, fault->message);
    return matrix;
}

// Poisson's ratio, round-off of E/(2G) − 1 included.
constexpr double largest_nu = 0.5 + 1e-9;

struct Moduli {
    double E, G, nu;
};

// What is wrong with G goes to the faults: without a shear factor, Poisson's ratio must make sense.
Moduli find_moduli(const CheckedTable& material, const SectionPlace& at, const BuildContext& context) {
    const double E = number_of(material, "E", at, context);
    if (material.gives("nu")) {
        const double nu = number_of(material, "nu", at, context);
        return {E, E / (2.0 * (1.0 + nu)), nu};
    }
    const double G = number_of(material, "G", at, context);
    const double nu = E / (2.0 * G) - 1.0;
    if (nu > largest_nu && !material.gives("shear_factor")) {
        context.add_fault(
            material,
            "G",
            fmt::format("with E = {:.6g} it means nu = {:.6g}, above 0.5, for which there is no "
                        "shear factor; expected a greater G, or shear_factor",
                        E,
                        nu));
    }
    return {E, G, nu};
}

std::optional<ShapeConstants> find_shape(const CheckedTable& shape,
                                         double nu,
                                         const SectionPlace& at,
                                         const BuildContext& context) {
    const auto number = [&](const CheckedTable& table, const char* key) {
        return number_of(table, key, at, context);
    };
    if (shape.gives("circle")) return compute_circle(number(only(shape, "circle"), "radius"), nu);
    if (shape.gives("rectangle")) {
        const CheckedTable& rectangle = only(shape, "rectangle");
        return compute_rectangle(number(rectangle, "width_y"), number(rectangle, "height_z"), nu);
    }
    const CheckedTable& tube = only(shape, "tube");
    const double outer = number(tube, "outer_radius");
    const double inner = number(tube, "inner_radius");
    if (inner < outer) return compute_tube(outer, inner, nu);
    context.add_fault(
        tube, "inner_radius", fmt::format("expected less than outer_radius = {}, found {}", outer, inner));
    return std::nullopt;
}

struct ShearFactors {
    double y, z;
};

ShearFactors find_shear_factors(const CheckedTable& material,
                                const ShapeConstants& shape,
                                const SectionPlace& at,
                                const BuildContext& context) {
    if (!material.gives("shear_factor")) return {shape.shear_factor_y, shape.shear_factor_z};
    const double given = number_of(material, "shear_factor", at, context);
    return {given, given};
}

// "0.886 along y and z", or one for each.
std::string describe_factors(const ShapeConstants& shape) {
    if (shape.shear_factor_y == shape.shear_factor_z) {
        return fmt::format("{:.6g} along y and z", shape.shear_factor_y);
    }
    return fmt::format("{:.6g} along y and {:.6g} along z", shape.shear_factor_y, shape.shear_factor_z);
}

// What a shear factor is, and which one the section has.
std::string describe_shear_factors(const CheckedTable& table,
                                   const CheckedTable& material,
                                   const ShapeConstants& shape,
                                   const ShearFactors& factors,
                                   double nu) {
    const std::string text = table.path + ": shear stiffness is shear_factor G A; ";
    const std::string exact = fmt::format("the exact flexure at nu = {:.4g}", nu);
    if (!material.gives("shear_factor")) {
        return fmt::format("{}shear_factor follows from {}, {}", text, exact, describe_factors(shape));
    }
    const double given = factors.y;
    // Beyond it there is no flexure to compare with.
    if (nu > largest_nu) return fmt::format("{}shear_factor {:.6g} is given", text, given);
    return fmt::format(
        "{}shear_factor {:.6g} is given, where {} has {}", text, given, exact, describe_factors(shape));
}

void set_from_shape(const CheckedTable& table,
                    const SectionPlace& at,
                    Section& section,
                    const BuildContext& context) {
    const CheckedTable& material = only(table, "material");
    const Moduli moduli = find_moduli(material, at, context);
    const std::optional<ShapeConstants> shape = find_shape(only(table, "shape"), moduli.nu, at, context);
    if (!shape) return;
    const ShearFactors factors = find_shear_factors(material, *shape, at, context);
    if (at.rod.empty())
        context.notes.push_back(describe_shear_factors(table, material, *shape, factors, moduli.nu));
    const double Iy = shape->second_moment_y;
    const double Iz = shape->second_moment_z;
    const double GA = moduli.G * shape->area;
    section.stiffness = diagonal({moduli.E * shape->area, factors.y * GA, factors.z * GA},
                                 {moduli.G * shape->torsion_constant, moduli.E * Iy, moduli.E * Iz});
    if (!material.gives("density")) return;
    const double density = number_of(material, "density", at, context);
    section.mass = diagonal(Vec3::Constant(density * shape->area), density * Vec3(Iy + Iz, Iy, Iz));
}

// What a dynamic analysis needs, and a static one may miss.
void check_inertia(const CheckedTable& table, const Section& section, const BuildContext& context) {
    if (!context.needs_inertia()) {
        if (!context.deck.gives("gravity") || !section.mass.isZero(0.0)) return;
        context.notes.push_back(table.path + ": no inertia, so that gravity does not act on it");
    } else if (table.gives("shape")) {
        if (only(table, "material").gives("density")) return;
        context.add_fault(
            only(table, "material"), "density", "missing; a dynamic analysis needs the mass of the rods");
    } else if (!table.gives("inertia") && !table.gives("mass_matrix")) {
        context.add_fault(
            table, "inertia", "missing; a dynamic analysis needs inertia = { … } or mass_matrix");
    }
}

// The frame in which a deck gives the section.
SectionFrame frame_of(const CheckedTable& section, const SectionPlace& at, const BuildContext& context) {
    SectionFrame frame{.y = 0.0, .z = 0.0, .turn = number_of(section, "turn", at, context)};
    if (!section.gives("at")) return frame;
    const auto& point = section.get<std::vector<double>>("at");
    frame.y = point[0];
    frame.z = point[1];
    return frame;
}

bool has_function(const CheckedTable& table) {
    return std::ranges::any_of(table.values, [](const CheckedValue& value) {
        if (const auto* tables = std::get_if<std::vector<CheckedTable>>(&value.value))
            return std::ranges::any_of(*tables, has_function);
        return std::holds_alternative<CheckedArcFunction>(value.value);
    });
}

}  // namespace

double number_of(const CheckedTable& table,
                 const char* key,
                 const SectionPlace& at,
                 const BuildContext& context) {
    const CheckedValue& value = *table.find(key);
    if (const auto* constant = std::get_if<double>(&value.value)) return *constant;
    const Range& range = range_of(table, key);
    const std::string of_rod = at.rod.empty() ? "" : " of " + at.rod;
    try {
        const double number = std::get<CheckedArcFunction>(value.value).function(at.s);
        if (range.contains(number)) return number;
        context.faults.add(value.place,
                           table.path_of(key),
                           fmt::format("expected a number {}, found {} at s = {:.6g}{}",
                                       describe_range(range),
                                       number,
                                       at.s,
                                       of_rod));
    } catch (const EvaluationError& error) {
        // Its text begins with the key.
        const std::string text = error.what();
        const std::string path = table.path_of(key) + ": ";
        context.faults.add(value.place,
                           table.path_of(key),
                           (text.starts_with(path) ? text.substr(path.size()) : text) + of_rod);
    }
    return 1.0;
}

// Of what touches; 0 where nothing says it.
double find_contact_radius(const CheckedTable& table,
                           const SectionPlace& at,
                           const Section& section,
                           const BuildContext& context) {
    if (table.gives("radius")) return table.get<double>("radius");
    if (table.gives("shape")) {
        const CheckedTable& shape = only(table, "shape");
        if (shape.gives("circle")) return number_of(only(shape, "circle"), "radius", at, context);
        if (shape.gives("tube")) return number_of(only(shape, "tube"), "outer_radius", at, context);
    }
    return section.fluid ? 0.5 * section.fluid->diameter : 0.0;
}

Section build_section(const CheckedTable& table, const SectionPlace& at, const BuildContext& context) {
    Section section{.name = table.name};
    if (table.gives("shape")) {
        set_from_shape(table, at, section, context);
    } else if (table.gives("stiffness")) {
        section.stiffness = stiffness_of(only(table, "stiffness"), at, context);
    } else {
        section.stiffness = matrix_of(table, "stiffness_matrix", check_stiffness_matrix, context);
    }
    if (table.gives("inertia")) section.mass = mass_of(only(table, "inertia"), at, context);
    if (table.gives("mass_matrix")) {
        section.mass = matrix_of(table, "mass_matrix", check_mass_matrix, context);
    }
    section.expansion = number_of(table, "expansion", at, context);
    if (at.rod.empty()) check_inertia(table, section, context);
    const SectionFrame frame = frame_of(table, at, context);
    section.stiffness = move_from(frame, section.stiffness);
    section.mass = move_from(frame, section.mass);
    set_damping(table, section);
    set_fluid(table, at, section, context);
    section.radius = find_contact_radius(table, at, section, context);
    return section;
}

void set_damping(const CheckedTable& table, Section& section) {
    if (!table.gives("damping")) return;
    const CheckedTable& damping = only(table, "damping");
    if (damping.gives("kelvin_voigt")) {
        const auto& times = damping.get<std::vector<double>>("kelvin_voigt");
        section.kelvin_voigt = std::ranges::max(times);
        if (times.size() == 6) section.kelvin_voigt_components = Eigen::Map<const Vec6>(times.data());
    }
    section.mass_proportional = damping.get<double>("mass_proportional");
}

bool varies_along_rod(const CheckedTable& section) { return has_function(section); }

void build_sections(BuildContext& context) {
    for (const CheckedTable& table : context.deck.tables("section")) {
        context.model.sections.push_back(build_section(table, {}, context));
        set_law(table, context.model.sections.back(), context);
    }
}

}  // namespace gxrod
