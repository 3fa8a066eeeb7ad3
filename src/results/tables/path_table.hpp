#pragma once

#include "results/file/hdf5_objects.hpp"
#include "state/records/path_record.hpp"

namespace gxrod {

// Groups of a stage that follows a path: its critical points, and the main path with its branches.
inline constexpr const char* critical_points_name = "critical_points";
inline constexpr const char* branches_name = "branches";

// Writes the paths of a stage into its group; docs/guide/results.md lists the datasets. Throws Hdf5Error.
void write_path_tables(const Hdf5Handle& group, const PathRecord& paths);

// Removes these tables, before they are found anew.
void remove_path_tables(const Hdf5Handle& group);

}  // namespace gxrod
