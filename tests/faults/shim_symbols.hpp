#pragma once

#include <dlfcn.h>

#include <cstdlib>
#include <cstring>

// What the libraries that stand before the C library in a faulted process (LD_PRELOAD) have in common.
namespace gxrod::faults {

// The function that this library replaces.
template <class Function>
Function* real(Function*, const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

inline long read_number(const char* variable, long otherwise) {
    const char* text = std::getenv(variable);
    return text ? std::strtol(text, nullptr, 10) : otherwise;
}

inline bool is_chosen(const char* variable, const char* value) {
    const char* text = std::getenv(variable);
    return text && std::strcmp(text, value) == 0;
}

}  // namespace gxrod::faults
