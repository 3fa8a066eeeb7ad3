#include "deck/sections/shapes/section_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "deck/schema/schema_tables.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/sections/section_tables.hpp"
#include "deck/table/table.hpp"

namespace gxrod {
namespace {

// Beyond it an isotropic material hardly changes its volume, and cells would lock.
constexpr double most_isotropic_nu = 0.4999;

// The number at an index of a list, or the only one.
double number_at(const AxisNumbers& numbers, std::size_t index) {
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
    const double E = number_at(given.E, 0);
    const double nu = given.nu ? number_at(*given.nu, 0) : E / (2.0 * number_at(*given.G, 0)) - 1.0;
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
    const double E2 = number_at(given.E, 1), nu23 = number_at(*given.nu, 2);
    const bool has_G23 = given.G->numbers.size() == 3;
    const OrthotropicModuli moduli{.E1 = number_at(given.E, 0),
                                   .E2 = E2,
                                   .E3 = number_at(given.E, 2),
                                   .G12 = number_at(*given.G, 0),
                                   .G13 = number_at(*given.G, 1),
                                   .G23 = has_G23 ? number_at(*given.G, 2) : E2 / (2.0 * (1.0 + nu23)),
                                   .nu12 = number_at(*given.nu, 0),
                                   .nu13 = number_at(*given.nu, 1),
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
        material.expansion[static_cast<Eigen::Index>(i)] = number_at(*given.expansion, i);
    material.yields = given.interaction.value_or(false);
    if (!material.yields || !has_axes) return material;
    context.add_fault(
        given, given.interaction, "goes with an isotropic material; this one has numbers by axis");
    return std::nullopt;
}

// Finds a table of a deck by its name; adds a fault if the deck has no such table.
template <class T>
const T* find_table_named(const CheckedWord& name,
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

// Notes materials that no layup and no section has, and layups that no section has.
void note_idle_tables(const BuildContext& context) {
    std::set<std::string> materials, layups;
    for (const SectionTable& section : tables_of<SectionTable>(context.deck, section_table())) {
        if (!section.shape) continue;
        const auto* own = section.material ? std::get_if<TableName>(&*section.material) : nullptr;
        if (own != nullptr) materials.insert(own->word);
        if (const auto& walls = section.shape->walls) {
            for (const CheckedWord& name : walls->layup.names) layups.insert(name.word);
        }
        if (const auto& mesh = section.shape->mesh) {
            for (const MeshGroupTable& group : mesh->groups.tables) materials.insert(group.material.word);
            if (mesh->material) materials.insert(mesh->material->word);
        }
    }
    for (const LayupTable& layup : tables_of<LayupTable>(context.deck, layup_table())) {
        if (!layups.contains(layup.name)) context.notes.push_back(layup.path + ": no section has it");
        for (const CheckedPly& ply : layup.plies.plies) materials.insert(ply.material.word);
    }
    for (const ElasticMaterialTable& material :
         tables_of<ElasticMaterialTable>(context.deck, elastic_material_table())) {
        if (!materials.contains(material.name))
            context.notes.push_back(material.path + ": no layup and no section has it");
    }
}

}  // namespace

const ElasticMaterialTable* look_up_material(const std::string& name, const BuildContext& context) {
    for (const ElasticMaterialTable& table :
         tables_of<ElasticMaterialTable>(context.deck, elastic_material_table())) {
        if (table.name == name) return &table;
    }
    return nullptr;
}

bool is_orthotropic(const ElasticMaterialTable& given) {
    return given.E.is_list || (given.G && given.G->is_list) || (given.nu && given.nu->is_list);
}

std::optional<int> SectionMaterials::find(const CheckedWord& name) {
    if (const auto known = known_.find(name.word); known != known_.end()) return known->second;
    const auto* given =
        find_table_named<ElasticMaterialTable>(name, "material", elastic_material_table(), context_);
    if (given == nullptr) return std::nullopt;
    std::optional<ElasticMaterial> material = build_material(*given, context_);
    if (!material) return known_[name.word] = std::nullopt;
    materials_.push_back(std::move(*material));
    return known_[name.word] = static_cast<int>(materials_.size()) - 1;
}

std::optional<Layup> SectionMaterials::find_layup(const CheckedWord& name) {
    const auto* given = find_table_named<LayupTable>(name, "layup", layup_table(), context_);
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
    note_idle_tables(context);
}

}  // namespace gxrod
