#include "face/convergence_error.hpp"

namespace gxrod {

const char* name_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::out_of_iterations:
            return "out of iterations";
        case Outcome::singular:
            return "singular";
        case Outcome::not_finite:
            return "not finite";
        case Outcome::rotation_too_large:
            return "rotation too large";
        case Outcome::element_too_turned:
            return "element too turned";
        case Outcome::error_too_large:
            return "error too large";
        case Outcome::energy_out_of_reach:
            return "energy out of reach";
        case Outcome::joints_open:
            return "joints open";
        case Outcome::control_turned:
            return "control turned";
        case Outcome::path_crawls:
            return "path crawls";
        case Outcome::lost_stability:
            return "lost stability";
        default:
            return "converged";
    }
}

}  // namespace gxrod
