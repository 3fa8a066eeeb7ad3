#pragma once

#include "results/file/hdf5_handle.hpp"
#include "results/file/ordered_file.hpp"

namespace gxrod {

// The smallest size of HDF5's heap of texts (a "global heap collection").
inline constexpr std::size_t text_heap_bytes = 4096;

// Makes file access properties with which HDF5 reads and writes through `file`, which it shares and which
// must outlive them. They choose the earliest file format, which every reader opens, and place each B-tree
// node and heap of texts within a page of memory, so that none is ever written in part. Throws Hdf5Error.
Hdf5Handle make_ordered_access(OrderedFile& file);

// Creates an HDF5 file in an ordered file, with room for the seal before it, or opens the existing one.
Hdf5Handle create_hdf5(OrderedFile& file);
Hdf5Handle open_hdf5(OrderedFile& file);

}  // namespace gxrod
