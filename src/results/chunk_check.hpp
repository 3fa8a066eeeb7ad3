#pragma once

#include <hdf5.h>

#include <functional>

namespace gxrod {

// Whether chunks of rows of a dataset have the bytes that HDF5 takes them to have: each compressed one, and
// all others together. HDF5 does not look: it takes memory for as many as the file's index says, or as come
// out of what is compressed, and goes through rows in it as far as a chunk reaches. Calls `come_along` with
// each compressed chunk. Throws Hdf5Error, and std::bad_alloc.
bool has_sound_chunks(hid_t dataset, const std::function<void()>& come_along);

}  // namespace gxrod
