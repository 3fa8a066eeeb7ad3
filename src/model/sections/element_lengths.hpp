#pragma once

#include <algorithm>

#include "model/model.hpp"

namespace gxrod {

struct ElementLengths {
    double least = 0.0;
    double most = 0.0;
};

// Finds the lengths of a rod's elements.
inline ElementLengths find_element_lengths(const Rod& rod) {
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    ElementLengths lengths{rod.length, 0.0};
    for (std::size_t first = 0; first < rod.arc_length.size(); first += per_element) {
        const double length = rod.arc_length[first + per_element - 1] - rod.arc_length[first];
        lengths.least = std::min(lengths.least, length);
        lengths.most = std::max(lengths.most, length);
    }
    return lengths;
}

}  // namespace gxrod
