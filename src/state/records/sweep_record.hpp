#pragma once

#include <complex>
#include <string>
#include <vector>

#include "state/motion.hpp"
#include "state/records/eigenvalue_record.hpp"

// Eigenvalues as functions of a parameter.
namespace gxrod {

// A value of the parameter at which motions begin or cease to grow.
struct Onset {
    double value = 0.0;  // value of the parameter
    double omega = 0.0;  // rad per time; 0 where the model diverges
    bool is_flutter = false;
    bool is_merging = false;  // two undamped frequencies merge, or one vanishes
    bool begins = true;       // whether growth begins there as the parameter proceeds
};

inline const char* name_kind(const Onset& onset) { return onset.is_flutter ? "flutter" : "divergence"; }

struct SweepRecord {
    struct Point {
        double value = 0.0;
        double speed = 0.0;   // rotational speed of the state, rad per time
        std::string failure;  // why there are no eigenvalues here, "" if they were found
        // λ of each mode that is followed, in the order of the first point; NaN where the mode was lost.
        std::vector<std::complex<double>> lambda;
        // Share of another mode of the previous point in each mode, relative to the share of the mode itself:
        // 0 if the mode is the same, near 1 where two modes exchange their shapes.
        std::vector<double> corruption;
        std::vector<std::string> words;  // of each mode here; "" where it was lost
        // If shapes are kept: the modes, without motion where they were lost, and the equilibrium.
        std::vector<Eigenmode> modes;
        std::vector<NodeMotion> nodes;
        double growth = 0.0;      // the largest Re λ of all that were found
        bool is_growing = false;  // beyond round-off
    };
    std::string key;                 // the key of the deck whose value is swept
    std::vector<std::string> words;  // words for each mode, at the first point
    std::vector<Point> points;
    std::vector<Onset> onsets;  // in order of the parameter
    long equilibria = 0;        // solved in all
};

}  // namespace gxrod
