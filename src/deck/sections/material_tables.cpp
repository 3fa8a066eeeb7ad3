#include "deck/sections/material_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "deck/schema/suggestion.hpp"
#include "deck/table/table.hpp"

namespace gxrod {
namespace {

constexpr const char* stress_unit = "mass/(length·time²)";
// Beyond it an isotropic material hardly changes its volume, and cells would lock.
constexpr double most_isotropic_nu = 0.4999;

const TableSpec& strength_table() {
    using T = StrengthTable;
    // clang-format off
    static const TableSpec table = Table<T>("material.NAME.strength", "")
        .key("Xt", &T::Xt, "In tension along the fibres.")
            .unit(stress_unit).above(0).required().also("f1t")
        .key("Xc", &T::Xc, "In compression along the fibres, a positive number.")
            .unit(stress_unit).above(0).required().also("f1c")
        .key("Yt", &T::Yt, "In tension across the fibres.")
            .unit(stress_unit).above(0).required().also("f2t")
        .key("Yc", &T::Yc, "In compression across the fibres, a positive number.")
            .unit(stress_unit).above(0).required().also("f2c")
        .key("S12", &T::S12, "In shear along the fibres, 12 and 13.")
            .unit(stress_unit).above(0).required().also("s s6 f6 s_lt")
        .key("S23", &T::S23, "In shear across the fibres.")
            .unit(stress_unit).above(0).required().also("st s4 f4")
        .key("f12", &T::f12, "Tsai and Wu's F12 is f12 √(F11 F22).")
            .unit("1").above(-1).at_most(1);
    // clang-format on
    return table;
}

bool is_orthotropic(const ElasticMaterialTable& given) {
    return given.E.is_list || (given.G && given.G->is_list) || (given.nu && given.nu->is_list);
}

// The number at an index of a list, or the only one.
double at(const AxisNumbers& numbers, std::size_t index) {
    return numbers.numbers[std::min(index, numbers.numbers.size() - 1)];
}

// Finds the stiffness of a material of one modulus and a ratio, or two moduli.
std::optional<Mat6> find_isotropic_stiffness(const ElasticMaterialTable& given, const BuildContext& context) {
    if (given.G && given.nu) {
        context.add_fault(given, given.G, "nu is given too; an isotropic material has one of them");
        return std::nullopt;
    }
    if (!given.G && !given.nu) {
        context.add_fault(given, given.nu, "missing; expected nu or G, or arrays by axis of E, G and nu");
        return std::nullopt;
    }
    const double E = at(given.E, 0);
    const double nu = given.nu ? at(*given.nu, 0) : E / (2.0 * at(*given.G, 0)) - 1.0;
    if (nu > -1.0 && nu <= most_isotropic_nu) return compute_isotropic_stiffness(E, nu);
    const std::string found =
        fmt::format("nu = {:.6g}; expected more than -1 and at most {}", nu, most_isotropic_nu);
    given.nu ? context.add_fault(given, given.nu, found)
             : context.add_fault(given, given.G, "it means " + found);
    return std::nullopt;
}

// Whether the lists of an orthotropic material have the numbers that it needs.
bool has_orthotropic_numbers(const ElasticMaterialTable& given, const BuildContext& context) {
    if (!given.E.is_list || given.E.numbers.size() < 2) {
        context.add_fault(
            given, given.E, "expected [E1, E2, E3], or [E1, E2] for E3 = E2, as G or nu has numbers by axis");
        return false;
    }
    if (!given.nu || (given.nu->is_list && given.nu->numbers.size() != 3)) {
        context.add_fault(
            given,
            given.nu,
            "expected [nu12, nu13, nu23], or one number for all three, as E has numbers by axis");
        return false;
    }
    if (!given.G) {
        context.add_fault(given,
                          given.G,
                          "missing; expected [G12, G13, G23], of which G13 and G23 can be left out, as E has "
                          "numbers by axis");
        return false;
    }
    if (given.G->numbers.size() < 3 && given.E.numbers.size() == 3 &&
        given.E.numbers[1] != given.E.numbers[2]) {
        context.add_fault(
            given, given.G, "expected [G12, G13, G23]: without G23 = E2/(2(1 + nu23)), as E2 and E3 differ");
        return false;
    }
    return true;
}

std::optional<Mat6> find_orthotropic_stiffness(const ElasticMaterialTable& given,
                                               const BuildContext& context) {
    if (!has_orthotropic_numbers(given, context)) return std::nullopt;
    const double E2 = at(given.E, 1), nu23 = at(*given.nu, 2);
    const bool has_G23 = given.G->numbers.size() == 3;
    const OrthotropicModuli moduli{.E1 = at(given.E, 0),
                                   .E2 = E2,
                                   .E3 = at(given.E, 2),
                                   .G12 = at(*given.G, 0),
                                   .G13 = at(*given.G, 1),
                                   .G23 = has_G23 ? at(*given.G, 2) : E2 / (2.0 * (1.0 + nu23)),
                                   .nu12 = at(*given.nu, 0),
                                   .nu13 = at(*given.nu, 1),
                                   .nu23 = nu23};
    const std::string fault = find_fault(moduli);
    if (fault.empty()) return compute_orthotropic_stiffness(moduli);
    context.add_fault(given, given.nu, "the material is not positive definite: " + fault);
    return std::nullopt;
}

std::optional<ElasticMaterial> build_material(const ElasticMaterialTable& given,
                                              const BuildContext& context) {
    const bool has_axes = is_orthotropic(given);
    const std::optional<Mat6> stiffness =
        has_axes ? find_orthotropic_stiffness(given, context) : find_isotropic_stiffness(given, context);
    if (!stiffness) return std::nullopt;
    ElasticMaterial material{.name = given.name, .stiffness = *stiffness, .density = given.density};
    material.is_isotropic = !has_axes;
    material.yield_stress = given.yield_stress;
    if (const auto& s = given.strength)
        material.strength = PlyStrength{s->Xt, s->Xc, s->Yt, s->Yc, s->S12, s->S23, s->f12};
    for (std::size_t i = 0; given.expansion && i < 3; ++i)
        material.expansion[static_cast<Eigen::Index>(i)] = at(*given.expansion, i);
    return material;
}

// Finds a table of a deck by its name; adds a fault if there is none.
template <class T>
const T* find_named(const CheckedWord& name,
                    const char* kind,
                    const TableSpec& spec,
                    const BuildContext& context) {
    std::vector<std::string> known;
    for (const T& table : tables_of<T>(context.deck, spec)) {
        if (table.name == name.word) return &table;
        known.push_back(table.name);
    }
    std::string hint = did_you_mean(name.word, known);
    if (hint.empty())
        hint = known.empty() ? fmt::format("; the deck has no [{}.NAME]", kind)
                             : "; the deck has " + plain_list(known);
    context.faults.add(name.place, name.path, fmt::format("no {} \"{}\"{}", kind, name.word, hint));
    return nullptr;
}

}  // namespace

const TableSpec& elastic_material_table() {
    using T = ElasticMaterialTable;
    // clang-format off
    static const TableSpec table = Table<T>("[material.NAME]",
            "A linear elastic material of walls and meshes of sections, in its own axes: 1 along the fibres, 2 across them in "
            "the wall, 3 through the wall. Numbers make it isotropic; arrays are by axis. "
            "[Sections](guide/sections.md#materials-plies-and-meshes) has pictures.")
        .key("E", &T::E, "Young's modulus, or [E1, E2, E3]; E3 is E2 if left out.")
            .unit(stress_unit).above(0).required()
            .also("youngs_modulus young young_modulus elastic_modulus modulus_of_elasticity modulus e1")
        .key("G", &T::G, "Shear modulus, or [G12, G13, G23]; left out, G13 is G12 and G23 is E2/(2(1 + nu23)).")
            .unit(stress_unit).above(0).also("shear_modulus mu g12")
        .key("nu", &T::nu, "Poisson's ratio, or [nu12, nu13, nu23]: pulled along 1, it strains along 2 by −nu12 times as much.")
            .unit("1").also("poisson poisson_ratio poissons_ratio poissons v nu12")
        .key("density", &T::density, "Mass per volume.")
            .unit("mass/length³").at_least(0).also("rho mass_density specific_mass")
        .key("yield_stress", &T::yield_stress, "A limit that von Mises' stress is compared with.")
            .unit(stress_unit).above(0).also("yield yield_strength sigma_y fy")
        .key("strength", &T::strength, strength_table(), "Limits of a ply, for the criteria of Tsai and Wu, of Hashin and of "
             "the largest stress.")
            .also("strengths limits failure")
        .key("expansion", &T::expansion, "Strain by heat, or by axis.")
            .unit("1/temperature").otherwise("0").also("alpha thermal_expansion cte")
        .shown_by(
            "[material.carbon]\n"
            "E        = [141e9, 9.8e9]\n"
            "G        = [6e9, 6e9, 4.8e9]\n"
            "nu       = [0.30, 0.30, 0.34]\n"
            "density  = 1600\n"
            "strength = { Xt = 1500e6, Xc = 1200e6, Yt = 40e6, Yc = 200e6, S12 = 70e6, S23 = 50e6 }\n");
    // clang-format on
    return table;
}

const TableSpec& layup_table() {
    using T = LayupTable;
    // clang-format off
    static const TableSpec table = Table<T>("[layup.NAME]",
            "Plies one on the other, of the walls of sections.")
        .key("plies", &T::plies, "Material, thickness, angle of the fibres and how many times, one row a ply, from the right of "
             "the walk along the wall to its left: of a closed wall from outside in. The angle goes from x towards the walk; "
             "it is 0 and the times are 1 if left out.")
            .required().also("layers laminate stack stacking sequence")
        .shown_by(
            "[layup.skin]\n"
            "plies = [[\"carbon\", 1.25e-4, 0, 2], [\"carbon\", 1.25e-4, \"pi/4\"], [\"carbon\", 1.25e-4, \"-pi/4\"]]\n");
    // clang-format on
    return table;
}

std::optional<int> SectionMaterials::find(const CheckedWord& name) {
    if (const auto known = known_.find(name.word); known != known_.end()) return known->second;
    const auto* given =
        find_named<ElasticMaterialTable>(name, "material", elastic_material_table(), context_);
    if (given == nullptr) return std::nullopt;
    std::optional<ElasticMaterial> material = build_material(*given, context_);
    if (!material) return known_[name.word] = std::nullopt;
    materials_.push_back(std::move(*material));
    return known_[name.word] = static_cast<int>(materials_.size()) - 1;
}

std::optional<Layup> SectionMaterials::find_layup(const CheckedWord& name) {
    const auto* given = find_named<LayupTable>(name, "layup", layup_table(), context_);
    if (given == nullptr) return std::nullopt;
    Layup layup{.name = name.word, .plies = {}};
    bool is_complete = true;
    for (const CheckedPly& ply : given->plies.plies) {
        const std::optional<int> material = find(ply.material);
        is_complete = is_complete && material;
        for (long i = 0; material && i < ply.times; ++i)
            layup.plies.push_back({*material, ply.thickness, ply.fibre_angle});
    }
    return is_complete ? std::optional(std::move(layup)) : std::nullopt;
}

void check_materials(const BuildContext& context) {
    SectionMaterials all(context);
    for (const ElasticMaterialTable& table :
         tables_of<ElasticMaterialTable>(context.deck, elastic_material_table()))
        all.find({table.name, table.place, table.path});
    for (const LayupTable& table : tables_of<LayupTable>(context.deck, layup_table()))
        all.find_layup({table.name, table.place, table.path});
}

}  // namespace gxrod
