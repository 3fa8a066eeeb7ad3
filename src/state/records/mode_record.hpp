#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/settings/settings.hpp"
#include "rotation/types.hpp"

// What is found of small motions about a state: vibrations, and shapes in which it gives way.
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
    // Some eigenvalue lies so near to ω², relative to its distance from a shift below all of them.
    double residual = 0.0;
    // Moved along x, y, z and turned about the axes through the origin as one piece, the model meets this
    // mode with such a mass, or moment of inertia.
    Vec6 effective_mass = Vec6::Zero();
    Shape shape;
};

struct ModesRecord {
    std::string failure;  // why there are none, "" if they were found
    Linearization linearization = Linearization::elastic;
    double time = 0.0;        // at which loads were taken
    std::vector<Mode> modes;  // by rising ω²

    Vec6 total_mass = Vec6::Zero();       // of the model, held nodes too, in the same six directions
    Vec6 effective_share = Vec6::Zero();  // of the modes together in it

    // Below ω² = limit lie so many, as counted by pivots, and so many were found.
    double limit = 0.0;
    std::int64_t counted = -1;  // −1: not known
    std::int64_t found = 0;
    bool is_complete = false;   // counted and all found
    bool is_all = false;        // the model has no others, whatever their frequency
    std::int64_t unstable = 0;  // with ω² < 0 beyond round-off

    // How much the part of K that is not symmetric, which modes leave out, couples them: largest |φᵢᵀ(K −
    // Kᵀ)φⱼ| over the larger |ω²|.
    double unsymmetry = 0.0;
    bool is_symmetric = true;  // but for round-off and what is out of balance
    std::string cause;         // of that part where it is not: "load[0] follows its point"
};

struct BucklingFactor {
    double factor = 0.0;  // on the load
    double residual = 0.0;
    Shape shape;  // its largest displacement 1; rotation, if nothing is displaced
};

struct BucklingRecord {
    std::string failure;
    Linearization linearization = Linearization::elastic;
    double mesh_error = 0.0;  // by how much elements make the first factor too large, about, relative
    std::string coarse_rod;   // whose elements do most of that
    double load_time = 0.0;   // the load that is multiplied is the deck's at this time
    std::vector<BucklingFactor> factors;   // positive, rising
    std::vector<BucklingFactor> reversed;  // negative, falling: of the load turned round

    // From −limit to limit lie so many, as counted by pivots.
    double limit = 0.0;
    std::int64_t counted_positive = -1, counted_negative = -1;
    bool is_complete = false;
    bool is_symmetric = true;
    std::string cause;
};

}  // namespace gxrod
