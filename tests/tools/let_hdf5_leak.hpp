#pragma once

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace gxrod::test {

// As long as it lives, what is lost is not told of: HDF5 forgets memory when it fails.
struct LetHdf5Leak {
    LetHdf5Leak() {}  // so that it is no unused variable
#ifdef __SANITIZE_ADDRESS__
    const __lsan::ScopedDisabler leaks;
#endif
};

}  // namespace gxrod::test
