#include <fmt/format.h>

#include <algorithm>

#include "cross_section/heat/heat_strains.hpp"
#include "cross_section/moved_section.hpp"
#include "deck/output/stress_criterion.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/top_level.hpp"
#include "deck/sections/build_sections.hpp"
#include "deck/sections/section_matrices.hpp"
#include "deck/sections/section_shape.hpp"
#include "deck/sections/shapes/cut_shape.hpp"
#include "deck/sections/shapes/profile_keys.hpp"
#include "deck/sections/shapes/profile_outline.hpp"
#include "deck/sections/shapes/shape_material.hpp"
#include "deck/surroundings/section_fluid.hpp"
#include "model/evaluation_error.hpp"
#include "model/sections/section_frame.hpp"

namespace gxrod {
namespace {

constexpr const char* axial_stiffness = "mass·length/time²";
constexpr const char* bending_stiffness = "mass·length³/time²";

const TableSpec& stiffness_table() {
    using T = StiffnessTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.stiffness", "")
        .key("EA", &T::EA, "Axial stiffness.")
            .unit(axial_stiffness).above(0).required().also("axial axial_stiffness")
        .key("GAy", &T::GAy, "Shear stiffness along y.")
            .unit(axial_stiffness).above(0).required()
        .key("GAz", &T::GAz, "Shear stiffness along z.")
            .unit(axial_stiffness).above(0).required()
        .key("GJ", &T::GJ, "Torsional stiffness.")
            .unit(bending_stiffness).above(0).required().also("git gip gi_t torsion torsional_stiffness")
        .key("EIy", &T::EIy, "Bending stiffness about y.")
            .unit(bending_stiffness).above(0).required()
        .key("EIz", &T::EIz, "Bending stiffness about z.")
            .unit(bending_stiffness).above(0).required()
        .not_here("ei", "EIy and EIz, about y and z")
        .not_here("ga", "GAy and GAz, along y and z");
    // clang-format on
    return table;
}

const TableSpec& inertia_table() {
    using T = InertiaTable;
    constexpr const char* rotary = "mass·length";
    constexpr const char* needed = "0 if static, else required";
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.inertia", "")
        .key("rhoA", &T::rhoA, "Mass per length.")
            .unit("mass/length").above(0).required().also("m mass mass_per_length rho_a a_rho mu")
        .key("rhoJ", &T::rhoJ, "Rotary inertia per length about x.")
            .unit(rotary).above(0).otherwise("rhoIy + rhoIz").remark(no_inertia).also("j ip rhoip rhoix polar")
        .key("rhoIy", &T::rhoIy, "Rotary inertia per length about y.")
            .unit(rotary).above(0).otherwise(needed).remark(no_inertia)
        .key("rhoIz", &T::rhoIz, "Rotary inertia per length about z.")
            .unit(rotary).above(0).otherwise(needed).remark(no_inertia);
    // clang-format on
    return table;
}

const TableSpec& circle_table() {
    using T = CircleTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.circle", "")
        .key("radius", &T::radius, "Radius.")
            .unit("length").above(0).required().also("r").also("diameter d", "half the diameter");
    // clang-format on
    return table;
}

const TableSpec& tube_table() {
    using T = TubeTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.tube", "")
        .key("outer_radius", &T::outer_radius, "Outer radius.")
            .unit("length").above(0).required()
            .also("ro r_outer r_out r").also("outer_diameter diameter", "half the diameter")
        .key("inner_radius", &T::inner_radius, "Inner radius, below the outer one.")
            .unit("length").above(0).required()
            .also("ri r_inner r_in").also("inner_diameter", "half the diameter")
            .also("thickness wall wall_thickness", "outer_radius less the wall");
    // clang-format on
    return table;
}

const TableSpec& rectangle_table() {
    using T = RectangleTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape.rectangle", "")
        .key("width_y", &T::width_y, "Side along y.")
            .unit("length").above(0).required().also("width w b breadth")
        .key("height_z", &T::height_z, "Side along z.")
            .unit("length").above(0).required().also("height h depth thickness t");
    // clang-format on
    return table;
}

const TableSpec& shape_table() {
    using T = ShapeTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.shape", "")
        .key("circle", &T::circle, circle_table(), "A solid circle.")
            .also("round cylinder disc disk solid_circle")
        .key("tube", &T::tube, tube_table(), "A hollow circle.")
            .also("pipe ring annulus hollow_circle hollow_cylinder")
        .key("rectangle", &T::rectangle, rectangle_table(), "A solid rectangle with sides along y and z.")
            .also("rect square plate")
        .with(&add_outlined_shapes)
        .key("walls", &T::walls, walls_table(), "Walls of plies along a line.")
            .also("wall laminate plies layup layups")
        .key("mesh", &T::mesh, mesh_shape_table(), "Triangles and quadrangles of a file.")
            .also("file msh gmsh")
        .exactly_one_of({"circle", "tube", "rectangle", "profile", "I", "channel", "angle", "tee", "box", "zed", "hat",
                         "polygon", "walls", "mesh"});
    // clang-format on
    return table;
}

constexpr const char* section_examples =
    "[section.tube]\n"
    "stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = \"GJ\", EIy = \"EI\", EIz = \"EI\" }\n"
    "inertia   = { rhoA = 1.0, rhoJ = 20.0, rhoIy = 10.0, rhoIz = 10.0 }\n"
    "damping   = { kelvin_voigt = 1e-3 }\n"
    "\n"
    "[section.wire]\n"
    "shape    = { circle = { radius = 5e-3 } }\n"
    "material = { E = 2.1e11, nu = 0.3, density = 7850 }\n"
    "fluid    = { drag = 1.0 }\n"
    "\n"
    "[section.strand]\n"
    "stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 300, EIy = 800, EIz = 800 }\n"
    "inertia   = { rhoA = 1.0, rhoIy = 10.0, rhoIz = 10.0 }\n"
    "law       = { layers = [{ on = \"bending\", stiffness = 4200, limit = 120 }] }\n"
    "\n"
    "[section.laminate]\n"
    "stiffness_matrix = [\n"
    "  [1e6,   0,   0,   0,   0,   0],\n"
    "  [  0, 4e5,   0,   0,   0,   0],\n"
    "  [  0,   0, 4e5,   0,   0,   0],\n"
    "  [  0,   0,   0,  50,  10,   0],\n"
    "  [  0,   0,   0,  10,  80,   0],\n"
    "  [  0,   0,   0,   0,   0, 900]]\n"
    "mass_matrix = [\n"
    "  [ 2.0,   0,   0,    0,    0, -0.1],\n"
    "  [   0, 2.0,   0,    0,    0,    0],\n"
    "  [   0,   0, 2.0,  0.1,    0,    0],\n"
    "  [   0,   0, 0.1, 0.03,    0,    0],\n"
    "  [   0,   0,   0,    0, 0.02,    0],\n"
    "  [-0.1,   0,   0,    0,    0, 0.02]]\n";

}  // namespace

const TableSpec& damping_table() {
    using T = DampingTable;
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.damping", "")
        .key("kelvin_voigt", &T::kelvin_voigt, "Resultants are the stiffness times strain + kelvin_voigt × rate of the "
             "strain. Six numbers, for extension, shear along y and z, torsion and bending about y and z, damp each "
             "by its own: √(τᵢ τⱼ) Kᵢⱼ in place of τ Kᵢⱼ.")
            .unit("time").at_least(0).otherwise("0")
            .also("beta rayleigh_beta stiffness_proportional viscosity")
        .key("mass_proportional", &T::mass_proportional,
             "Forces and couples are −mass_proportional × the momenta, per length.")
            .unit("1/time").at_least(0).also("alpha rayleigh_alpha mass");
    // clang-format on
    return table;
}

const TableSpec& section_table() {
    using T = SectionTable;
    // clang-format off
    static const TableSpec table = Table<T>("[section.NAME]",
            "A cross-section in its own axes: x along the tangent of the rod, y and z across. Stiffness and inertia "
            "come from constants, from matrices or from a shape and its material; a static analysis needs no inertia. "
            "Numbers can be functions of s, the arc length from the start of each rod that has the section. Rows and "
            "columns of matrices are in the order x y z rx ry rz. [Sections](guide/sections.md) has the formulas.")
        .key("stiffness", &T::stiffness, stiffness_table(), "Resultants from strains.")
            .also("ea ei ga gj eiy eiz gay gaz constitutive")
        .key("stiffness_matrix", &T::stiffness_matrix, "The same as a full matrix: symmetric, positive definite.")
            .unit("of stiffness").also("k c constitutive_matrix")
        .key("shape", &T::shape, shape_table(), "Stiffness and inertia from the shape, with material.")
            .also("geometry profile circle tube rectangle")
        .key("inertia", &T::inertia, inertia_table(), "Momenta per length from velocities.")
            .also("rhoa rhoiy rhoiz rhoj mass mass_per_length")
        .key("mass_matrix", &T::mass_matrix, "The same as a full matrix: that of a rigid slice, [m 1, −m [d]×; m [d]×, "
             "J] with d from the node to the centre of mass and J about the node; positive definite.")
            .unit("of inertia").also("m inertia_matrix")
        .key("material", &T::material, shape_material_table(), "What the shape is made of: the name of a [material.NAME], or its "
             "numbers. Walls and meshes name materials of their own.")
            .names_of({"material"}).only_with("shape").otherwise("of walls and meshes none, else required")
            .also("e nu rho density youngs_modulus")
        .key("at", &T::at, "Where the point is, from the rod and in its section axes, about which stiffness and "
             "inertia are given, or in which the middle of the shape lies. They are moved from there to the rod, "
             "exactly.")
            .unit("length").otherwise("[0, 0]")
        .key("turn", &T::turn, "Of the axes in which they are given, from the rod's about x, right-handed: from y "
             "towards z. Also of the shape.")
            .unit("angle")
        .key("damping", &T::damping, damping_table(), "None if left out.")
            .also("rayleigh viscosity")
        .key("law", &T::law, law_table(), "Linear and elastic if left out.")
        .key("trapeze", &T::trapeze, "Whether twist pulls the section together, as BeamDyn has it: with c = EIy + EIz, "
             "½ c twist² of axial force and c × twist × extension of torque.")
            .otherwise("false")
        .key("expansion", &T::expansion, "Strain by heat, for the temperatures of [[actuation]]; materials of shapes can have it "
             "instead.")
            .unit("1/temperature").also("alpha thermal_expansion cte")
        .key("radius", &T::radius, "Of contact: what touches is round.")
            .unit("length").above(0)
            .otherwise("of a circle or a tube its outer radius; else half of fluid's outer_diameter")
            .also("contact_radius r")
        .key("fluid", &T::fluid, section_fluid_table(), "What [fluid], [air] and [seabed] see of it; {} takes part "
             "with the defaults. Without it they pass it by.")
            .also("hydro drag cd ca cm added_mass morison outer_diameter")
        .exactly_one_of({"stiffness", "stiffness_matrix", "shape"})
        .at_most_one_of({"inertia", "mass_matrix", "material"})
        .shown_by(section_examples);
    // clang-format on
    return table;
}

namespace {

Mat6 diagonal(const Vec3& translation, const Vec3& rotation) {
    Mat6 matrix = Mat6::Zero();
    matrix.diagonal() << translation, rotation;
    return matrix;
}

Mat6 stiffness_of(const StiffnessTable& given, const SectionPlace& at, const BuildContext& context) {
    const auto c = [&](const ArcNumber& number) { return number_of(given, number, at, context); };
    return diagonal({c(given.EA), c(given.GAy), c(given.GAz)}, {c(given.GJ), c(given.EIy), c(given.EIz)});
}

// rhoIy and rhoIz, that a static analysis can do without, and a dynamic one cannot.
double find_rotary_inertia(const InertiaTable& inertia,
                           const std::optional<ArcNumber>& given,
                           const SectionPlace& at,
                           const BuildContext& context) {
    if (given) return number_of(inertia, *given, at, context);
    if (context.needs_inertia()) {
        context.add_fault(
            inertia,
            given,
            fmt::format("missing; expected {}; {}", describe_expected(inertia.key_of(&given)), no_inertia));
    }
    return 0.0;
}

Mat6 mass_of(const InertiaTable& given, const SectionPlace& at, const BuildContext& context) {
    const double rhoA = number_of(given, given.rhoA, at, context);
    const double rhoIy = find_rotary_inertia(given, given.rhoIy, at, context);
    const double rhoIz = find_rotary_inertia(given, given.rhoIz, at, context);
    const double rhoJ = given.rhoJ ? number_of(given, *given.rhoJ, at, context) : rhoIy + rhoIz;
    return diagonal(Vec3::Constant(rhoA), {rhoJ, rhoIy, rhoIz});
}

using MatrixCheck = std::optional<MatrixFault>(Mat6&);

Mat6 matrix_of(const SectionTable& section,
               const Mat6& given,
               MatrixCheck& check,
               const BuildContext& context) {
    Mat6 matrix = given;
    const std::optional<MatrixFault> fault = check(matrix);
    if (fault)
        context.faults.add(section.place_of(&given), section.path_of(&given) + fault->entry, fault->message);
    return matrix;
}

// Poisson's ratio, round-off of E/(2G) − 1 included.
constexpr double largest_nu = 0.5 + 1e-9;

struct Moduli {
    double E, G, nu;
};

// What is wrong with G goes to the faults: without a shear factor, Poisson's ratio must make sense.
Moduli find_moduli(const MaterialTable& material, const SectionPlace& at, const BuildContext& context) {
    const double E = number_of(material, material.E, at, context);
    if (material.nu) {
        const double nu = number_of(material, *material.nu, at, context);
        return {E, E / (2.0 * (1.0 + nu)), nu};
    }
    const double G = number_of(material, *material.G, at, context);
    const double nu = E / (2.0 * G) - 1.0;
    if (nu > largest_nu && !material.shear_factor) {
        context.add_fault(
            material,
            material.G,
            fmt::format("with E = {:.6g} it means nu = {:.6g}, above 0.5, for which there is no "
                        "shear factor; expected a greater G, or shear_factor",
                        E,
                        nu));
    }
    return {E, G, nu};
}

std::optional<ShapeConstants> find_shape(const ShapeTable& shape,
                                         double nu,
                                         const SectionPlace& at,
                                         const BuildContext& context) {
    if (const auto& circle = shape.circle)
        return compute_circle(number_of(*circle, circle->radius, at, context), nu);
    if (const auto& rectangle = shape.rectangle) {
        const double width = number_of(*rectangle, rectangle->width_y, at, context);
        return compute_rectangle(width, number_of(*rectangle, rectangle->height_z, at, context), nu);
    }
    const TubeTable& tube = *shape.tube;
    const double outer = number_of(tube, tube.outer_radius, at, context);
    const double inner = number_of(tube, tube.inner_radius, at, context);
    return is_hollow(tube, outer, inner, context) ? std::optional(compute_tube(outer, inner, nu))
                                                  : std::nullopt;
}

struct ShearFactors {
    double y, z;
};

ShearFactors find_shear_factors(const MaterialTable& material,
                                const ShapeConstants& shape,
                                const SectionPlace& at,
                                const BuildContext& context) {
    if (!material.shear_factor) return {shape.shear_factor_y, shape.shear_factor_z};
    const double given = number_of(material, *material.shear_factor, at, context);
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
std::string describe_shear_factors(const SectionTable& table,
                                   const MaterialTable& material,
                                   const ShapeConstants& shape,
                                   const ShearFactors& factors,
                                   double nu) {
    const std::string text = table.path + ": shear stiffness is shear_factor G A; ";
    const std::string exact = fmt::format("the exact flexure at nu = {:.4g}", nu);
    if (!material.shear_factor) {
        return fmt::format("{}shear_factor follows from {}, {}", text, exact, describe_factors(shape));
    }
    const double given = factors.y;
    // Beyond it there is no flexure to compare with.
    if (nu > largest_nu) return fmt::format("{}shear_factor {:.6g} is given", text, given);
    return fmt::format(
        "{}shear_factor {:.6g} is given, where {} has {}", text, given, exact, describe_factors(shape));
}

void set_from_shape(const SectionTable& table,
                    const MaterialTable& material,
                    const SectionPlace& at,
                    Section& section,
                    const BuildContext& context) {
    const Moduli moduli = find_moduli(material, at, context);
    const std::optional<ShapeConstants> shape = find_shape(*table.shape, moduli.nu, at, context);
    if (!shape) return;
    const ShearFactors factors = find_shear_factors(material, *shape, at, context);
    if (at.rod.empty())
        context.notes.push_back(describe_shear_factors(table, material, *shape, factors, moduli.nu));
    const double Iy = shape->second_moment_y;
    const double Iz = shape->second_moment_z;
    const double GA = moduli.G * shape->area;
    section.stiffness = diagonal({moduli.E * shape->area, factors.y * GA, factors.z * GA},
                                 {moduli.G * shape->torsion_constant, moduli.E * Iy, moduli.E * Iz});
    if ((at.rod.empty() || at.is_node) && asks_for_stresses(context.deck))
        section.shape = cut_plain_shape(table, at, context);
    if (!material.density) return;
    const double density = number_of(material, *material.density, at, context);
    section.mass = diagonal(Vec3::Constant(density * shape->area), density * Vec3(Iy + Iz, Iy, Iz));
}

void set_from_cells(const SectionTable& table,
                    const SectionPlace& at,
                    Section& section,
                    const BuildContext& context) {
    const CutSection cut = compute_cut_section(table, at, context);
    section.stiffness = cut.stiffness;
    section.mass = cut.mass;
    section.shape = cut.shape;
}

// The strain by heat of a section, the same all over it: by its own key, or by its material. Materials with
// several act by the free strains of the shape instead.
double find_expansion(const SectionTable& given,
                      const SectionPlace& at,
                      const Section& section,
                      const BuildContext& context) {
    std::optional<double> by_material;
    const std::optional<MaterialTable> material =
        given.shape && !is_plied(*given.shape) ? find_shape_material(given, context) : std::nullopt;
    if (material && material->expansion) {
        by_material = number_of(*material, *material->expansion, at, context);
    } else if (!material && section.shape && expands(*section.shape)) {
        by_material = find_even_expansion(*section.shape).value_or(0.0);
    }
    if (by_material && given.gives(given.expansion))
        context.add_fault(given, given.expansion, "its material has one too; only one of them can be given");
    return by_material ? *by_material : number_of(given, given.expansion, at, context);
}

// The mass of a shape that a dynamic analysis needs.
void check_shape_inertia(const SectionTable& given, const Section& section, const BuildContext& context) {
    if (is_plied(*given.shape) || has_orthotropic_material(given, context)) {
        if (!section.mass.isZero(0.0)) return;
        return context.add_fault(
            given,
            given.shape,
            "its materials have no density; a dynamic analysis needs the mass of the rods");
    }
    const std::optional<MaterialTable> material = find_shape_material(given, context);
    if (!material || material->density) return;
    context.add_fault(*material, material->density, "missing; a dynamic analysis needs the mass of the rods");
}

// What a dynamic analysis needs, and a static one may miss.
void check_inertia(const SectionTable& given, const Section& section, const BuildContext& context) {
    if (!context.needs_inertia()) {
        if (!top_level_of(context.deck).gravity || !section.mass.isZero(0.0)) return;
        context.notes.push_back(given.path + ": no inertia, so that gravity does not act on it");
    } else if (given.shape) {
        check_shape_inertia(given, section, context);
    } else if (!given.inertia && !given.mass_matrix) {
        context.add_fault(
            given, given.inertia, "missing; a dynamic analysis needs inertia = { … } or mass_matrix");
    }
}

// The frame in which a deck gives the section.
SectionFrame frame_of(const SectionTable& section, const SectionPlace& at, const BuildContext& context) {
    SectionFrame frame{.y = 0.0, .z = 0.0, .turn = number_of(section, section.turn, at, context)};
    if (section.at) {
        frame.y = (*section.at)[0];
        frame.z = (*section.at)[1];
    }
    return frame;
}

// Of what touches; 0 where nothing says it.
double find_contact_radius(const SectionTable& given,
                           const SectionPlace& at,
                           const Section& section,
                           const BuildContext& context) {
    if (given.radius) return *given.radius;
    if (given.shape) {
        const auto& circle = given.shape->circle;
        const auto& tube = given.shape->tube;
        if (circle) return number_of(*circle, circle->radius, at, context);
        if (tube) return number_of(*tube, tube->outer_radius, at, context);
    }
    return section.fluid ? 0.5 * section.fluid->diameter : 0.0;
}

}  // namespace

double number_of(const TableHead& table,
                 const ArcNumber& given,
                 const SectionPlace& at,
                 const BuildContext& context) {
    if (const auto* constant = std::get_if<double>(&given)) return *constant;
    const std::string of_rod = at.rod.empty() ? "" : " of " + at.rod;
    try {
        const double number = std::get<CheckedArcFunction>(given).function(at.s);
        const Range& range = table.key_of(&given).range;
        if (range.contains(number)) return number;
        context.add_fault(table,
                          given,
                          fmt::format("expected a number {}, found {} at s = {:.6g}{}",
                                      describe_range(range),
                                      number,
                                      at.s,
                                      of_rod));
    } catch (const EvaluationError& error) {
        // Its text begins with the key.
        const std::string text = error.what();
        const std::string path = table.path_of(&given) + ": ";
        context.add_fault(table, given, (text.starts_with(path) ? text.substr(path.size()) : text) + of_rod);
    }
    return 1.0;
}

Section build_section(const SectionTable& given, const SectionPlace& at, const BuildContext& context) {
    Section section{.name = given.name};
    if (given.shape) check_outline_keys(*given.shape, context);
    const bool is_on_cells = is_cut(given, context);
    const std::optional<MaterialTable> material =
        given.shape && !is_on_cells ? find_shape_material(given, context) : std::nullopt;
    if (given.shape && !is_plied(*given.shape) && !given.material) {
        context.add_fault(
            given, given.material, "missing; expected " + describe_expected(given.key_of(&given.material)));
        section.stiffness = Mat6::Identity();
    } else if (is_on_cells) {
        set_from_cells(given, at, section, context);
    } else if (given.shape && !material) {
        section.stiffness = Mat6::Identity();  // the material is at fault
    } else if (given.shape) {
        set_from_shape(given, *material, at, section, context);
    } else if (given.stiffness) {
        section.stiffness = stiffness_of(*given.stiffness, at, context);
    } else {
        section.stiffness = matrix_of(given, *given.stiffness_matrix, check_stiffness_matrix, context);
    }
    if (given.inertia) section.mass = mass_of(*given.inertia, at, context);
    if (given.mass_matrix) section.mass = matrix_of(given, *given.mass_matrix, check_mass_matrix, context);
    section.expansion = find_expansion(given, at, section, context);
    if (at.rod.empty()) check_inertia(given, section, context);
    const SectionFrame frame = frame_of(given, at, context);
    set_law(given, at, frame, section, context);
    section.mass = move_from(frame, section.mass);
    if (section.shape) section.shape = move_cross_section(section.shape, {frame.y, frame.z}, frame.turn);
    if (given.damping) set_damping(*given.damping, section);
    set_fluid(given, at, section, context);
    section.radius = find_contact_radius(given, at, section, context);
    return section;
}

void set_damping(const DampingTable& given, Section& section) {
    if (given.kelvin_voigt) {
        const std::vector<double>& times = given.kelvin_voigt->times;
        section.kelvin_voigt = std::ranges::max(times);
        if (times.size() == 6) section.kelvin_voigt_components = Eigen::Map<const Vec6>(times.data());
    }
    section.mass_proportional = given.mass_proportional;
}

bool is_hollow(const TubeTable& tube, double outer, double inner, const BuildContext& context) {
    if (inner < outer) return true;
    context.add_fault(
        tube, tube.inner_radius, fmt::format("expected less than outer_radius = {}, found {}", outer, inner));
    return false;
}

bool varies_along_rod(const CheckedTable& section) {
    const auto numbers = values_of<ArcNumber>(*section.record);
    const auto is_function = [](const ArcNumber& number) {
        return std::holds_alternative<CheckedArcFunction>(number);
    };
    return std::ranges::any_of(numbers, is_function) ||
           std::ranges::any_of(section.values, [](const CheckedValue& value) {
               const auto* tables = std::get_if<std::vector<CheckedTable>>(&value.value);
               return tables != nullptr && std::ranges::any_of(*tables, varies_along_rod);
           });
}

bool depends_on_place(const SectionTable& section, const BuildContext& context) {
    const std::vector<CheckedTable>& tables = context.deck.tables("section");
    const auto own = std::ranges::find_if(
        tables, [&](const CheckedTable& table) { return table.record.get() == &section; });
    return own != tables.end() && varies_along_rod(*own);
}

void build_sections(BuildContext& context) {
    for (const CheckedTable& table : context.deck.tables("section")) {
        const auto& given = static_cast<const SectionTable&>(*table.record);
        context.model.sections.push_back(build_section(given, {}, context));
    }
}

}  // namespace gxrod
