#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cross_section/elastic_material.hpp"
#include "cross_section/walls/layup.hpp"
#include "deck/places/build_context.hpp"
#include "deck/table/kinds.hpp"
#include "deck/table/material_kinds.hpp"

// [material.NAME] and [layup.NAME].
namespace gxrod {

struct StrengthTable : TableHead {
    double Xt = 0.0, Xc = 0.0, Yt = 0.0, Yc = 0.0, S12 = 0.0, S23 = 0.0;
    double f12 = -0.5;
};

struct ElasticMaterialTable : TableHead {
    AxisNumbers E;
    std::optional<AxisNumbers> G, nu;
    double density = 0.0;
    std::optional<double> yield_stress;
    std::optional<StrengthTable> strength;
    std::optional<AxisNumbers> expansion;
};

struct LayupTable : TableHead {
    PlyRows plies;
};

const TableSpec& elastic_material_table();
const TableSpec& layup_table();

// The materials of one section, each once, by their index.
class SectionMaterials {
  public:
    explicit SectionMaterials(const BuildContext& context) : context_(context) {}

    // Returns the index of a [material.NAME]. If there is none, or it has a fault, adds a fault and returns
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

// Checks all materials and layups of a deck, whether a section has them or not.
void check_materials(const BuildContext& context);

}  // namespace gxrod
