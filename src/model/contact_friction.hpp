#pragma once

#include <algorithm>

#include "model/contact.hpp"

namespace gxrod {

// Whether any contact has friction.
inline bool rubs(const Contact& contact) {
    const bool has_rods = contact.between_rods || contact.within_rods;
    const auto rubs_there = [](const ContactException& one) { return one.friction.value_or(0.0) > 0.0; };
    return (has_rods && contact.friction > 0.0) || std::ranges::any_of(contact.exceptions, rubs_there) ||
           std::ranges::any_of(contact.obstacles, [](const Obstacle& one) { return one.friction > 0.0; });
}

}  // namespace gxrod
