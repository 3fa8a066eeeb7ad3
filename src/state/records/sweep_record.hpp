#pragma once

#include <complex>
#include <string>
#include <vector>

// How eigenvalues follow a parameter.
namespace gxrod {

// Where motions begin to grow, or stop to.
struct Onset {
    double value = 0.0;  // of the parameter
    double omega = 0.0;  // rad per time; 0 where the model diverges
    bool is_flutter = false;
    bool is_merging = false;  // of two undamped frequencies; or an undamped one that vanishes
    bool begins = true;       // as the parameter goes on
};

inline const char* name_kind(const Onset& onset) { return onset.is_flutter ? "flutter" : "divergence"; }

struct SweepRecord {
    struct Point {
        double value = 0.0;
        double speed = 0.0;   // at which the state turns, rad per time
        std::string failure;  // why there are no eigenvalues here, "" if they were found
        // Of each mode that is followed, in the order in which the first point has them; NaN where it was
        // lost.
        std::vector<std::complex<double>> lambda;
        // How much each has of another mode of the point before, relative to what it has of itself: 0 for a
        // mode that is the same, near 1 where two exchange their shapes.
        std::vector<double> corruption;
        double growth = 0.0;      // the largest Re λ of all that were found
        bool is_growing = false;  // beyond round-off
    };
    std::string key;                 // of the deck, whose value is swept
    std::vector<std::string> words;  // of each mode, at the first point
    std::vector<Point> points;
    std::vector<Onset> onsets;  // by the parameter
    long equilibria = 0;        // that it took
};

}  // namespace gxrod
