#include "cross_section/cross_section.hpp"

namespace gxrod {

std::shared_ptr<const CrossSection> compute_cross_section(std::string source,
                                                          SectionMesh mesh,
                                                          std::vector<ElasticMaterial> materials) {
    auto section = std::make_shared<CrossSection>();
    section->source = std::move(source);
    section->mesh = std::move(mesh);
    section->materials = std::move(materials);
    const SectionQuadrature quadrature(section->mesh, section->materials);
    const CentralSolutions solutions = solve_section(quadrature);
    section->properties = compute_properties(quadrature, solutions);
    section->stresses = compute_stress_field(quadrature, solutions);
    section->gradient_strains = compute_gradient_strains(quadrature, solutions);
    return section;
}

}  // namespace gxrod
