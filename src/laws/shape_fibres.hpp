#pragma once

#include <vector>

#include "laws/fibre_law.hpp"

// Fibres whose area, centre and second moments are those of a shape; docs/theory/laws.md, (L30).
namespace gxrod {

// Makes the fibres of a tube, or of a circle if `inner` is zero. `inner` < `outer`.
std::vector<Fibre> make_tube_fibres(double outer, double inner);
// Makes the fibres of a rectangle with the sides `width` along y and `height` along z.
std::vector<Fibre> make_rectangle_fibres(double width, double height);

}  // namespace gxrod
