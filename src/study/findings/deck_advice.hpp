#pragma once

#include <string>
#include <vector>

#include "study/deck_study.hpp"

namespace gxrod {

// Advises in sentences whether to refine step or mesh, by how much, and to which errors that would lead; none
// if errors are small.
std::vector<std::string> advise_on_steps(const DeckStudy& study);
std::vector<std::string> advise_on_mesh(const DeckStudy& study);

}  // namespace gxrod
