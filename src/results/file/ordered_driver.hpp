#pragma once

#include "results/file/hdf5_handle.hpp"
#include "results/file/ordered_file.hpp"

namespace gxrod {

// The smallest size of HDF5's heap of texts (a "global heap collection").
inline constexpr std::size_t text_heap_bytes = 4096;

// File access properties that make HDF5 read and write through `file`, which it shares. `file` must outlive
// them. The earliest file format, so that every reader opens it; each B-tree node and heap of texts lies
// within a page of memory, so that it is never written in part. Throws Hdf5Error.
Hdf5Handle make_ordered_access(OrderedFile& file);

// Creates an HDF5 file in an ordered one, with room for the seal before it, or opens the one that is there.
Hdf5Handle create_hdf5(OrderedFile& file);
Hdf5Handle open_hdf5(OrderedFile& file);

}  // namespace gxrod
