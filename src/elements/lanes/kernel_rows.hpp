#pragma once

#include "elements/lanes/kernels.hpp"
#include "elements/rod/rod_element.hpp"

namespace gxrod {

// Make the rows of an element's sections and constants for kernels.
template <int Nodes>
std::array<double, RodKernels<Nodes>::shared_rows> make_shared_rows(const ObjectiveElement<Nodes>& element);
template <int Nodes>
std::array<double, RodKernels<Nodes>::section_rows> make_section_rows(const ObjectiveElement<Nodes>& element);
template <int Nodes>
std::array<double, RodKernels<Nodes>::constant_rows> make_constant_rows(
    const ObjectiveElement<Nodes>& element);

}  // namespace gxrod
