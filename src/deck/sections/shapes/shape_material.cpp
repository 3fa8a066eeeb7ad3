#include "deck/sections/shapes/shape_material.hpp"

#include <fmt/format.h>

#include "deck/sections/shapes/section_materials.hpp"
#include "deck/table/table.hpp"

namespace gxrod {
namespace {

// Poisson's ratio below which nothing is incompressible: cells would lock.
constexpr double most_nu = 0.4999;

// The name of the section's material; nothing if it has a table of its own, or none.
std::optional<CheckedWord> find_material_name(const SectionTable& section) {
    const auto* name = section.material ? std::get_if<TableName>(&*section.material) : nullptr;
    if (name == nullptr) return std::nullopt;
    return CheckedWord{name->word, section.place_of(&section.material), section.path_of(&section.material)};
}

// The table of a section by the numbers of a named material, with the places of these.
MaterialTable take_numbers(const ElasticMaterialTable& given) {
    MaterialTable table;
    static_cast<TableHead&>(table) = given;
    table.spec = &shape_material_table();
    table.E = given.E.numbers.front();
    if (given.nu) table.nu = given.nu->numbers.front();
    if (given.G) table.G = given.G->numbers.front();
    if (given.gives(given.density)) table.density = given.density;
    if (given.yield_stress) table.yield_stress = *given.yield_stress;
    if (given.expansion) table.expansion = given.expansion->numbers.front();
    table.interaction = given.interaction;
    table.elastic = given.elastic;
    return table;
}

std::optional<ElasticMaterial> make_elastic_material(const MaterialTable& table,
                                                     const SectionPlace& at,
                                                     const BuildContext& context) {
    const double E = number_of(table, table.E, at, context);
    const double nu = table.nu ? number_of(table, *table.nu, at, context)
                               : E / (2.0 * number_of(table, *table.G, at, context)) - 1.0;
    if (!(nu > -1.0 && nu <= most_nu)) {
        const std::string found =
            fmt::format("nu = {:.6g}; expected more than -1 and at most {}", nu, most_nu);
        const std::string message = found + ", as the stress across a rod depends on it";
        table.nu ? context.add_fault(table, table.nu, message)
                 : context.add_fault(table, table.G, "it means " + message);
        return std::nullopt;
    }
    ElasticMaterial material{.name = "material", .stiffness = compute_isotropic_stiffness(E, nu)};
    if (table.density) material.density = number_of(table, *table.density, at, context);
    if (table.yield_stress) material.yield_stress = number_of(table, *table.yield_stress, at, context);
    if (table.expansion)
        material.expansion.head<3>().setConstant(number_of(table, *table.expansion, at, context));
    material.yields = table.interaction.value_or(false);
    return material;
}

}  // namespace

const TableSpec& shape_material_table() {
    using T = MaterialTable;
    constexpr const char* of_stress = "mass/(length·time²)";
    // clang-format off
    static const TableSpec table = Table<T>("section.NAME.material", "")
        .key("E", &T::E, "Young's modulus.")
            .unit(of_stress).above(0).required()
            .also("youngs_modulus young young_modulus elastic_modulus modulus_of_elasticity elasticity modulus")
        .key("nu", &T::nu, "Poisson's ratio; G is E/(2(1 + nu)).")
            .unit("1").above(-1).at_most(0.5).also("poisson poisson_ratio poissons_ratio poissons v")
        .key("G", &T::G, "Shear modulus.")
            .unit(of_stress).above(0).also("shear_modulus mu")
        .key("yield_stress", &T::yield_stress, "Beyond it the material yields perfectly, and at 1/√3 of it in shear: "
             "bending, torsion and tension each by itself ([materials](guide/materials.md#yield-stress-of-a-material)). "
             "Of a profile, a polygon, walls or a mesh it is a limit to compare stresses with, unless they have interaction.")
            .unit(of_stress).above(0).also("stress yield yield_strength strength sigma_y fy")
        .key("interaction", &T::interaction, "true: axial force and bending moments yield together, by 192 to 768 "
             "fibres; more exact for columns, and slower. Of a shape that is cut into cells torsion and shear stay elastic.")
            .only_with("yield_stress").also("fibres fibers interact")
        .key("elastic", &T::elastic, "true: nothing yields, and the yield stress is a limit that stresses are compared with "
             "([stresses](guide/sections.md#stresses-over-time)), for circles, tubes and rectangles as for other shapes.")
            .only_with("yield_stress")
        .key("density", &T::density, "Mass per volume.")
            .unit("mass/length³").above(0).otherwise("none if static, else required")
            .also("rho mass_density specific_mass")
        .key("expansion", &T::expansion, "Strain by heat, for the temperatures of [[actuation]].")
            .unit("1/temperature").otherwise("0").also("alpha thermal_expansion cte")
        .key("shear_factor", &T::shear_factor, "Shear stiffness is shear_factor G A along y and z. Left out, it "
             "follows from the energy of Saint-Venant's flexure ([shear stiffness](theory/shear_stiffness.md)), and a "
             "rectangle has one along y and another along z.")
            .unit("1").above(0).otherwise("exact, for the shape and nu")
            .also("kappa k shear_correction shear_correction_factor shear_coefficient")
        .at_most_one_of({"interaction", "elastic"})
        .exactly_one_of({"nu", "G"});
    // clang-format on
    return table;
}

bool has_orthotropic_material(const SectionTable& section, const BuildContext& context) {
    const std::optional<CheckedWord> name = find_material_name(section);
    const ElasticMaterialTable* given = name ? look_up_material(name->word, context) : nullptr;
    return given != nullptr && is_orthotropic(*given);
}

std::optional<MaterialTable> find_shape_material(const SectionTable& section, const BuildContext& context) {
    const std::optional<CheckedWord> name = find_material_name(section);
    if (!section.material) return std::nullopt;
    if (!name) return std::get<MaterialTable>(*section.material);
    if (!SectionMaterials(context).find(*name)) return std::nullopt;
    const ElasticMaterialTable& given = *look_up_material(name->word, context);
    return is_orthotropic(given) ? std::nullopt : std::optional(take_numbers(given));
}

std::optional<ElasticMaterial> find_elastic_material(const SectionTable& section,
                                                     const SectionPlace& at,
                                                     const BuildContext& context) {
    const std::optional<CheckedWord> name = find_material_name(section);
    if (!name) return make_elastic_material(std::get<MaterialTable>(*section.material), at, context);
    SectionMaterials materials(context);
    if (!materials.find(*name)) return std::nullopt;
    return materials.materials().front();
}

}  // namespace gxrod
