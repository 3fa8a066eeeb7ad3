#pragma once

#include <optional>
#include <string>
#include <vector>

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
    std::optional<bool> interaction, elastic;
    std::optional<StrengthTable> strength;
    std::optional<AxisNumbers> expansion;
};

struct LayupTable : TableHead {
    PlyRows plies;
};

const TableSpec& elastic_material_table();
const TableSpec& layup_table();

}  // namespace gxrod
