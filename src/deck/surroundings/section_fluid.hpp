#pragma once

#include "deck/sections/build_sections.hpp"

// What water and air see of sections.
namespace gxrod {

// Gives a section what its table says of `fluid`, if anything, and the mass of its contents.
void set_fluid(const CheckedTable& table,
               const SectionPlace& at,
               Section& section,
               const BuildContext& context);

// a × one + b × other, number by number; nullopt if one of them is.
std::optional<SectionInFluid> combine(double a,
                                      const std::optional<SectionInFluid>& one,
                                      double b,
                                      const std::optional<SectionInFluid>& other);

}  // namespace gxrod
