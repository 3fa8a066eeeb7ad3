#pragma once

#include <filesystem>

#include "results/file/output_file.hpp"

namespace gxrod {

// Writes each frame of a results file NAME.vtkhdf as a separate file, NAME_0000.hdf and so on, and
// NAME.hdf.series, which gives their times. Creates the folder if it is missing. For ParaView 5.11 and other
// programs that read VTKHDF 1.0, without times. One frame at a time is in memory, and is copied bit for bit.
// If the job is still running, writes the frames so far. Returns NAME.hdf.series, which is written last. Then
// removes frames that an earlier NAME.hdf.series listed and the new one does not.
//
// Throws FileError if the results cannot be read or have no frame yet, or if a file exists and must not be
// replaced, or cannot be written or removed.
std::filesystem::path export_series(const std::filesystem::path& results,
                                    const std::filesystem::path& folder,
                                    Existing existing);

}  // namespace gxrod
