#pragma once

#include <tuple>
#include <vector>

#include "state/values/bushing_values.hpp"
#include "state/values/spring_values.hpp"

namespace gxrod {

// Values of the ties that are elements, at a step; each list in the order of the model's.
struct TieValues {
    std::tuple<std::vector<SpringValues>, std::vector<BushingValues>> lists;

    template <class Values>
    const std::vector<Values>& of() const {
        return std::get<std::vector<Values>>(lists);
    }
};

}  // namespace gxrod
