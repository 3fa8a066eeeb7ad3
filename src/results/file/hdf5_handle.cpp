#include "results/file/hdf5_handle.hpp"

#include <string>

namespace gxrod {
namespace {

// The innermost entry of the error stack is the cause.
herr_t keep_last(unsigned, const H5E_error2_t* error, void* reason) {
    if (error->desc) *static_cast<std::string*>(reason) = error->desc;
    return 0;
}

std::string describe_failure(const char* action) {
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_last, &reason);
    H5Eclear2(H5E_DEFAULT);
    return reason.empty() ? action : std::string(action) + ": " + reason;
}

}  // namespace

Hdf5Error::Hdf5Error(const char* action) : std::runtime_error(describe_failure(action)) {}

void silence_hdf5() {
    // Everything is closed when the program ends; what lack of memory kept open would crash HDF5's exit
    // handler.
    static const herr_t once = H5dont_atexit();
    static_cast<void>(once);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace gxrod
