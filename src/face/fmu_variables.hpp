#pragma once

#include <string>
#include <vector>

#include "model/problem.hpp"

namespace gxrod {

// A variable of a deck as an FMU has it (FMI 3.0). Its value reference is its place in the list.
struct FmuVariable {
    enum class Causality { independent, parameter, input, output };

    std::string name;  // "tendon", "tip.position.x"
    Causality causality;
    double start = 0.0;  // of parameters and inputs
    std::string description = {};
    // The history of an output, its quantity and the component.
    std::size_t history = 0, quantity = 0, component = 0;
};

// Lists the time, the [parameters] that are numbers, the inputs and the components of what histories record.
std::vector<FmuVariable> list_fmu_variables(const Problem& problem);

// Writes modelDescription.xml for co-simulation. Throws std::invalid_argument if two variables have one name.
std::string describe_fmu(const Problem& problem);

// The name of the FMU's library, without its ending.
inline constexpr const char* fmu_model_identifier = "gxrod_fmu";

}  // namespace gxrod
