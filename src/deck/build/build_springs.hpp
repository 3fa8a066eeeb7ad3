#pragma once

#include "deck/build/build_context.hpp"

namespace gxrod {

// What `between` of a [spring.NAME] says for an end that does not move.
inline constexpr const char* ground_word = "ground";

// After build_bodies.
void build_springs(BuildContext& context);

}  // namespace gxrod
