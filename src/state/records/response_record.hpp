#pragma once

#include <string>
#include <vector>

#include "model/settings/response_settings.hpp"

// How a model answers to forces that swing steadily.
namespace gxrod {

// Amplitudes of nodes, Re((real + i imaginary) e^(iωt)); displacements and spins, or forces and moments;
// global axes.
struct ComplexVectors {
    std::vector<Vec6> real, imaginary;
};

struct Response {
    double omega = 0.0;        // rad per time
    std::string failure;       // "" if it was found; at a frequency of an undamped model there is none
    ComplexVectors motion;     // of each node, about the state
    ComplexVectors reactions;  // what supports exert, in addition to what they do in the state
    double error = 0.0;        // of the motion, relative: what round-off in the equations makes of it
};

struct ResponseRecord {
    double time = 0.0;  // at which loads were taken
    std::vector<Response> responses;
    std::vector<ResponsePoint> points;  // whose answers are recorded
};

}  // namespace gxrod
