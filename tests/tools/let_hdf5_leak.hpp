#pragma once

#include <hdf5.h>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace gxrod::test {

// As long as it lives, what is lost is not told of: HDF5 forgets memory when it fails.
struct LetHdf5Leak {
    // HDF5 gives back what it keeps from earlier files: of memory that is used again, the loss would be told of.
    LetHdf5Leak() { H5garbage_collect(); }

#ifdef __SANITIZE_ADDRESS__
    const __lsan::ScopedDisabler leaks;
#endif
};

}  // namespace gxrod::test
