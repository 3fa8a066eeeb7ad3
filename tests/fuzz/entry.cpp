#include <cstddef>
#include <cstdint>

#include "fuzz/inputs.hpp"

// Where libFuzzer enters a program. GXROD_FUZZ_INPUT is the function that it tries.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    gxrod::fuzz::GXROD_FUZZ_INPUT({reinterpret_cast<const char*>(data), size});
    return 0;
}
