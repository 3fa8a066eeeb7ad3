#pragma once

#include <cstddef>
#include <cstdint>

// What an FMU of gxrod needs of the C interface FMI 3.0 (fmi3PlatformTypes.h, fmi3FunctionTypes.h of
// https://fmi-standard.org), declared anew.
extern "C" {
using fmi3Instance = void*;
using fmi3InstanceEnvironment = void*;
using fmi3FMUState = void*;
using fmi3ValueReference = std::uint32_t;
using fmi3Float64 = double;
using fmi3Boolean = bool;
using fmi3String = const char*;
enum fmi3Status { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal };
using fmi3LogMessageCallback = void (*)(fmi3InstanceEnvironment,
                                        fmi3Status,
                                        fmi3String category,
                                        fmi3String message);
using fmi3IntermediateUpdateCallback = void (*)();
}

#define FMI3_EXPORT extern "C" __attribute__((visibility("default")))
