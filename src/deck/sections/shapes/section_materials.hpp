#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cross_section/elastic_material.hpp"
#include "cross_section/walls/layup.hpp"
#include "deck/places/build_context.hpp"
#include "deck/sections/shapes/material_tables.hpp"

// From [material.NAME] and [layup.NAME] to materials and layups of sections.
namespace gxrod {

// Returns a [material.NAME], or nullptr.
const ElasticMaterialTable* look_up_material(const std::string& name, const BuildContext& context);

// Returns whether a material has numbers by axis.
bool is_orthotropic(const ElasticMaterialTable& given);

// The materials of one section, each once, by their index.
class SectionMaterials {
  public:
    explicit SectionMaterials(const BuildContext& context) : context_(context) {}

    // Returns the index of a [material.NAME]. Without one, or with a fault of it, adds a fault and returns
    // nothing.
    std::optional<int> find(const CheckedWord& name);
    // Returns a [layup.NAME] with its materials likewise.
    std::optional<Layup> find_layup(const CheckedWord& name);

    const std::vector<ElasticMaterial>& materials() const { return materials_; }

  private:
    const BuildContext& context_;
    std::vector<ElasticMaterial> materials_;
    std::map<std::string, std::optional<int>> known_;
};

// Checks all materials and layups of a deck, and notes those that nothing has.
void check_materials(const BuildContext& context);

}  // namespace gxrod
