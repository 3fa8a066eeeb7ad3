#pragma once

#include "results/hdf5_handle.hpp"
#include "results/ordered_file.hpp"

namespace gxrod {

// File access properties that make HDF5 read and write through `file`, which it shares. `file` must outlive
// these. Earliest file format, so that every reader opens it; a B-tree node, or a heap
// of texts, is within a page of memory, so that it is never written in part. Throws Hdf5Error.
Hdf5Handle make_ordered_access(OrderedFile& file);

}  // namespace gxrod
