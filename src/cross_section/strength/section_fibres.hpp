#pragma once

#include <vector>

#include "cross_section/section_quadrature.hpp"

namespace gxrod {

// A part of a section's area that is drawn together into one point.
struct SectionFibre {
    PlanePoint at;
    double area;
    int material;  // an index in the materials of the section
};

struct FibreSettings {
    int count = 512;  // about; a power of two for one material
};

// Draws the quadrature points of a section together into fibres (CS12). Area, centre and second moments of
// each material are those of the quadrature.
std::vector<SectionFibre> make_section_fibres(const SectionQuadrature& quadrature,
                                              const FibreSettings& settings = {});

}  // namespace gxrod
