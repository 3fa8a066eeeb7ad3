#pragma once

#include <memory>

#include "cross_section/section_properties.hpp"
#include "cross_section/stress_field.hpp"

namespace gxrod {

// A section that has been computed: what it is cut into, how it resists, and what stress is where.
struct CrossSection {
    std::string source;  // what it is, for people: "IPE 200"
    SectionMesh mesh;
    std::vector<ElasticMaterial> materials;
    SectionProperties properties;
    StressField stresses;
    // Free strains for each degree per length by which it gets hotter along y and along z.
    Eigen::Matrix<double, 6, 2> gradient_strains = Eigen::Matrix<double, 6, 2>::Zero();
};

// Computes a section. Throws SectionError if it does not hold together.
std::shared_ptr<const CrossSection> compute_cross_section(std::string source,
                                                          SectionMesh mesh,
                                                          std::vector<ElasticMaterial> materials);

}  // namespace gxrod
