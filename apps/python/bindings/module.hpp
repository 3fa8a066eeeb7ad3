#pragma once

#include <nanobind/nanobind.h>

// The compiled part of the Python package gxrod: what the library has, as it is. The package's own modules
// make a pleasant interface of it.
namespace gxrod::python {

namespace nb = nanobind;

void bind_errors(nb::module_& module);
void bind_deck(nb::module_& module);
void bind_fatigue(nb::module_& module);
void bind_group(nb::module_& module);
void bind_section(nb::module_& module);
void bind_simulation(nb::module_& module);

}  // namespace gxrod::python
