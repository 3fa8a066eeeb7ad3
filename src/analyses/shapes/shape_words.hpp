#pragma once

#include <string>

#include "assembly/system.hpp"
#include "state/records/mode_record.hpp"

namespace gxrod {

// Describes a shape for users, by its shares of strain energy: "bending about y of wing", "torsion of shaft
// and bending about z of arm"; or "the whole model turns about z" if it strains nothing.
std::string describe_shape(const System& system, const State& state, const Shape& shape);

}  // namespace gxrod
