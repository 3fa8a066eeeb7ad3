#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/settings/settings.hpp"
#include "rotation/types.hpp"

// Results on small motions about a state: vibrations and buckling shapes.
namespace gxrod {

// A small motion of the model.
struct Shape {
    std::vector<Vec6> nodes;  // displacement and spin of each, global axes
    // For each rod of the model the share of its extension, shear along y and z, torsion, bending about y and
    // z in the strain energy of the shape; all together 1, or 0 if there is none.
    std::vector<Vec6> energy_shares;
    std::string words;  // "bending about y of wing", "the whole model moves along x"
};

// A mode φ of vibration: (K − ω² M) φ = 0, φᵀ M φ = 1.
struct Mode {
    double omega_squared = 0.0;
    double omega = 0.0;      // rad per time; 0 where ω² < 0
    double frequency = 0.0;  // cycles per time
    double growth = 0.0;     // per time: √−ω² where ω² < 0, and the state is unstable
    // Distance within which an eigenvalue lies from ω², relative to its distance from a shift below all of
    // them.
    double residual = 0.0;
    // Effective mass of this mode if the model moves along x, y, z as one piece, and effective moment of
    // inertia if it turns about the axes through the origin.
    Vec6 effective_mass = Vec6::Zero();
    Shape shape;
};

struct ModesRecord {
    std::string failure;  // why there are none, "" if they were found
    Linearization linearization = Linearization::elastic;
    double time = 0.0;        // at which loads were taken
    std::vector<Mode> modes;  // by rising ω²

    Vec6 total_mass = Vec6::Zero();       // mass of the model with held nodes, in the same six directions
    Vec6 effective_share = Vec6::Zero();  // share of all modes together in the total

    // Numbers of modes below ω² = limit: as counted by pivots, and as found.
    double limit = 0.0;
    std::int64_t counted = -1;  // −1: not known
    std::int64_t found = 0;
    bool is_complete = false;   // counted and all found
    bool is_all = false;        // the model has no others, whatever their frequency
    std::int64_t unstable = 0;  // with ω² < 0 beyond round-off

    // Coupling of the modes by the unsymmetric part of K, which they leave out: the largest |φᵢᵀ(K − Kᵀ)φⱼ|
    // over the larger |ω²|.
    double unsymmetry = 0.0;
    bool is_symmetric = true;  // except for round-off and forces out of balance
    std::string cause;         // why it is not symmetric: "load[0] follows its point"
};

struct BucklingFactor {
    double factor = 0.0;  // on the load
    double residual = 0.0;
    Shape shape;  // its largest displacement 1; rotation, if nothing is displaced
};

struct BucklingRecord {
    std::string failure;
    Linearization linearization = Linearization::elastic;
    double mesh_error = 0.0;  // relative error, about, by which the mesh makes the first factor too large
    std::string coarse_rod;   // whose elements cause most of that
    double load_time = 0.0;   // the load that is multiplied is the deck's at this time
    std::vector<BucklingFactor> factors;   // positive, rising
    std::vector<BucklingFactor> reversed;  // negative, falling: for the reversed load

    // Numbers of factors from −limit to limit, as counted by pivots.
    double limit = 0.0;
    std::int64_t counted_positive = -1, counted_negative = -1;
    bool is_complete = false;
    bool is_symmetric = true;
    std::string cause;
};

}  // namespace gxrod
