#pragma once

#include <vector>

#include "laws/layered_law.hpp"

// Sections of an elastic, perfectly plastic material, without interaction of bending, torsion and tension, as
// layers of fibres; docs/theory/laws.md, (L10) and (L11).
namespace gxrod {

struct YieldingMaterial {
    double E = 0.0;
    double G = 0.0;
    double yield_stress = 0.0;  // in tension; in shear 1/√3 of it (von Mises)
};

// Makes the layers of a tube, or of a circle if `inner` is zero. `inner` < `outer`.
std::vector<Layer> make_tube_layers(double outer, double inner, const YieldingMaterial& material);
// Makes the layers of a rectangle with the sides `width` along y and `height` along z; `torsion_constant` is
// Saint-Venant's J.
std::vector<Layer> make_rectangle_layers(double width,
                                         double height,
                                         double torsion_constant,
                                         const YieldingMaterial& material);

}  // namespace gxrod
