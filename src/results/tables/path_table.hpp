#pragma once

#include "results/file/hdf5_objects.hpp"
#include "state/records/path_record.hpp"

namespace gxrod {

// Groups of a stage that goes along a path: its critical points, and the main path with its branches.
inline constexpr const char* critical_points_name = "critical_points";
inline constexpr const char* branches_name = "branches";

// What a path has found, into the group of its stage; docs/guide/results.md lists the datasets. Throws
// Hdf5Error.
void write_path_tables(const Hdf5Handle& group, const PathRecord& paths);

// What is found anew.
void remove_path_tables(const Hdf5Handle& group);

}  // namespace gxrod
