#pragma once

#include <string>

#include "assembly/system.hpp"
#include "state/records/mode_record.hpp"

namespace gxrod {

// Names a mode by how the rod moves that strains most. Puts the order before the words of its strain, "2nd
// bending about z of wing". In a frame that turns, the larger part of its kinetic energy decides: along the
// axis of the frame "1st flap: bending about z of blade", in the plane across it "edge", about the rod's own
// axis "torsion", along it "extension". The order is one more than the number of nodes of vibration: the
// displacement, or the moment, whichever changes its sign less often, so that it is 1 for the first mode
// however the rod's ends are held. Returns the words alone if the shape strains no rod that is one line.
// `imaginary`: the imaginary part at each node, of a complex mode.
std::string name_mode(const System& system,
                      const State& state,
                      const Shape& shape,
                      const std::vector<Vec6>* imaginary = nullptr);

}  // namespace gxrod
