#pragma once

#include "deck/sections/build_sections.hpp"

// Properties of sections for forces of water and air.
namespace gxrod {

// Gives a section the properties in `fluid` of its table, if there are any, and the mass of its contents.
void set_fluid(const SectionTable& given,
               const SectionPlace& at,
               Section& section,
               const BuildContext& context);

// Computes a × one + b × other, number by number; nullopt if one of them is.
std::optional<SectionInFluid> combine(double a,
                                      const std::optional<SectionInFluid>& one,
                                      double b,
                                      const std::optional<SectionInFluid>& other);

}  // namespace gxrod
