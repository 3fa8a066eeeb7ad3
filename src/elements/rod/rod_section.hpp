#pragma once

#include <memory>

#include "model/model.hpp"

namespace gxrod {

// What the elements of a section share. Material axes.
struct RodSection {
    Mat6 stiffness;            // resultants from strains
    double kelvin_voigt;       // time
    double mass_proportional;  // 1/time
    double mass;               // per length
    Vec3 centre_of_mass;       // from the node
    Mat3 rotary_inertia;       // per length, about the centre of mass
    bool has_inertia;          // as Model::has_inertia

    explicit RodSection(const Section& section, bool resists_acceleration = true);

    bool has_offset() const { return !centre_of_mass.isZero(0.0); }
};

using SharedRodSection = std::shared_ptr<const RodSection>;

}  // namespace gxrod
