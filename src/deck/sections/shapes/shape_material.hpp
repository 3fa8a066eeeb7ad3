#pragma once

#include <optional>

#include "cross_section/elastic_material.hpp"
#include "deck/sections/build_sections.hpp"

// The one material of a profile, a polygon, a circle, a tube or a rectangle: a table of the section, or the
// name of a [material.NAME].
namespace gxrod {

const TableSpec& shape_material_table();

// Returns whether a section names an orthotropic [material.NAME].
bool has_orthotropic_material(const SectionTable& section, const BuildContext& context);

// Finds the numbers of an isotropic material, as the section's own table has them. Nullopt without a
// material, of an orthotropic one, and with a fault.
std::optional<MaterialTable> find_shape_material(const SectionTable& section, const BuildContext& context);

// Finds the material for cells, at a place. With a fault, nullopt.
std::optional<ElasticMaterial> find_elastic_material(const SectionTable& section,
                                                     const SectionPlace& at,
                                                     const BuildContext& context);

}  // namespace gxrod
