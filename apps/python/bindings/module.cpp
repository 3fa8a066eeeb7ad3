#include "module.hpp"

#include <nanobind/stl/string.h>

#include "deck/schema/schema.hpp"
#include "model/version.hpp"

NB_MODULE(_core, module) {
    using namespace gxrod::python;
    module.doc() = "The compiled part of gxrod; `import gxrod` is how to use it.";
    module.attr("version") = gxrod::version;
    module.def(
        "schema",
        [] { return gxrod::json_schema(gxrod::deck_schema(), "gxrod deck"); },
        "The JSON Schema of decks, as text.");
    nanobind::set_leak_warnings(
        false);  // PyTorch and JAX keep functions until after the interpreter has ended
    bind_errors(module);
    bind_section(module);
    bind_deck(module);
    bind_simulation(module);
    bind_fatigue(module);
    bind_group(module);
}
