#include <fcntl.h>
#include <pthread.h>
#include <sanitizer/common_interface_defs.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>

#include "fuzz/inputs.hpp"

namespace {

// A child of a reader may break down: that is what it is for. libFuzzer is not to take it for a finding.
void leave_libfuzzer() {
    __sanitizer_set_death_callback(nullptr);
    ::dup2(::open("/dev/null", O_WRONLY), STDERR_FILENO);
}

const int registered = ::pthread_atfork(nullptr, nullptr, leave_libfuzzer);

}  // namespace

// Where libFuzzer enters a program. GXROD_FUZZ_INPUT is the function that it tries.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static_cast<void>(registered);
    gxrod::fuzz::GXROD_FUZZ_INPUT({reinterpret_cast<const char*>(data), size});
    return 0;
}
