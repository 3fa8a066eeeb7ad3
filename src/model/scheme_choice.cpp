#include "model/scheme_choice.hpp"

#include <fmt/format.h>

namespace gxrod {
namespace {

// From here on steps of order 2 were seen to be the cheaper ones; in fluids also where no accuracy is given.
constexpr double loose = 1e-2;
constexpr double loose_in_fluids = 1e-3;

bool has_rods_in_fluids(const Model& model) { return !model.rods.empty() && !model.surroundings.is_empty(); }

}  // namespace

SchemeChoice choose_scheme(const Model& model, std::optional<double> accuracy) {
    if (accuracy && *accuracy >= loose)
        return {Scheme::generalized_alpha,
                fmt::format("an accuracy of {:g} wants no higher order", *accuracy)};
    if (has_rods_in_fluids(model) && accuracy.value_or(1.0) >= loose_in_fluids)
        return {Scheme::generalized_alpha, "for rods in water, wind or on the ground"};
    if (model.rods.empty()) return {Scheme::radau_5, "for bodies"};
    return {Scheme::radau_5, "for rods, whose fastest vibrations steps do not resolve"};
}

}  // namespace gxrod
