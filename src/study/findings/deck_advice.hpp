#pragma once

#include <string>
#include <vector>

#include "study/deck_study.hpp"

namespace gxrod {

// What of step and mesh to refine, by how much, and what that would bring: sentences; none where all is
// right.
std::vector<std::string> advise_on_steps(const DeckStudy& study);
std::vector<std::string> advise_on_mesh(const DeckStudy& study);

}  // namespace gxrod
