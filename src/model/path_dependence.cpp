#include "model/path_dependence.hpp"

#include <algorithm>

#include "model/sticking.hpp"

namespace gxrod {

bool depends_on_path(const Model& model) {
    const auto remembers = [](const Section& section) {
        return section.law && section.law->memory_size() > 0;
    };
    const auto measures_from_step = [](const Rod& rod) { return rod.kind == ElementKind::simo; };
    return std::ranges::any_of(model.sections, remembers) ||
           std::ranges::any_of(model.rods, measures_from_step) || !list_frictions(model).empty();
}

}  // namespace gxrod
