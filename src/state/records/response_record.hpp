#pragma once

#include <string>
#include <vector>

#include "model/settings/response_settings.hpp"

// The response of a model to harmonic forces.
namespace gxrod {

// Amplitudes of nodes, Re((real + i imaginary) e^(iωt)); displacements and spins, or forces and moments;
// global axes.
struct ComplexVectors {
    std::vector<Vec6> real, imaginary;
};

struct Response {
    double omega = 0.0;        // rad per time
    std::string failure;       // "" if it was found; an undamped model has none at its natural frequencies
    ComplexVectors motion;     // motion of each node, about the state
    ComplexVectors reactions;  // reactions of supports, in addition to their reactions in the state
    double error = 0.0;        // relative error of the motion by round-off in the equations
};

struct ResponseRecord {
    double time = 0.0;  // at which loads were taken
    std::vector<Response> responses;
    std::vector<ResponsePoint> points;  // whose responses are recorded
};

}  // namespace gxrod
