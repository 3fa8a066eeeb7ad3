#pragma once

#include <hdf5.h>

#include <functional>

namespace gxrod {

// Whether each chunk of rows of a dataset has the bytes that HDF5 takes it to have. HDF5 does not look: it
// takes memory for as many as the file's index says, or as come out of what is compressed, and goes through
// rows in it as far as a chunk reaches. Calls `come_along` with each compressed chunk. Throws Hdf5Error, and
// std::bad_alloc.
bool has_sound_chunks(hid_t dataset, const std::function<void()>& come_along);

}  // namespace gxrod
