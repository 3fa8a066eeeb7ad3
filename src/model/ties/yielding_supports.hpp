#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "model/model.hpp"

// Supports that yield are bushings from the ground to the supported node, in axes that stay. They have the
// name of their table, "support[2]", which no other bushing can have.
namespace gxrod {

inline constexpr std::string_view support_prefix = "support[";

inline bool is_support(const Bushing& bushing) { return bushing.name.starts_with(support_prefix); }

// Returns whether a support yields at the node.
inline bool yields_at(const Model& model, int node) {
    return std::ranges::any_of(model.bushings, [&](const Bushing& bushing) {
        return is_support(bushing) && bushing.ends[1].node == node;
    });
}

}  // namespace gxrod
