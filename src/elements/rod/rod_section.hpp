#pragma once

#include <array>
#include <memory>
#include <optional>

#include "model/model.hpp"

namespace gxrod {

// The data of a section that elements share. Material axes.
struct RodSection {
    Mat6 stiffness;                         // resultants from strains
    double kelvin_voigt;                    // time
    double mass_proportional;               // 1/time
    double mass;                            // per length
    Vec3 centre_of_mass;                    // from the node
    Mat3 rotary_inertia;                    // per length, about the centre of mass
    bool has_inertia;                       // as Model::has_inertia
    std::optional<Vec6> damping_roots;      // √τ_i, if the components of kelvin_voigt differ
    std::shared_ptr<const SectionLaw> law;  // nullptr if resultants are stiffness × strains

    int memory_size() const { return law ? law->memory_size() : 0; }

    explicit RodSection(const Section& section, bool resists_acceleration = true);

    // Computes the resultants of Kelvin-Voigt damping at these strain rates; for a matrix, at each of its
    // columns.
    Vec6 compute_viscous_resultants(const Vec6& rates) const;
    Mat6 compute_viscosity() const;

    bool has_offset() const { return !centre_of_mass.isZero(0.0); }
};

using SharedRodSection = std::shared_ptr<const RodSection>;

// The sections of one element: at its force points, at the Gauss points of its mass and at its nodes.
template <int Nodes>
struct ElementSections {
    std::array<SharedRodSection, Nodes - 1> at_forces;
    std::array<SharedRodSection, Nodes> at_masses, at_nodes;

    ElementSections() = default;
    // Takes the same section everywhere.
    ElementSections(const SharedRodSection& section) {
        at_forces.fill(section);
        at_masses.fill(section);
        at_nodes.fill(section);
    }
};

}  // namespace gxrod
