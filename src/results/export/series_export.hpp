#pragma once

#include <filesystem>

#include "results/file/output_file.hpp"

namespace gxrod {

// Writes each frame of a results file NAME.vtkhdf as a file of its own, NAME_0000.hdf …, and NAME.hdf.series,
// which gives their times, in a folder that is created if it is missing. For ParaView 5.11 and other programs
// that read VTKHDF 1.0, without times. One frame at a time is in memory, and is copied bit for bit. Of a
// running job, the frames so far. Returns NAME.hdf.series, which is written last. Frames that an earlier
// NAME.hdf.series listed, and the new one does not, are then removed.
//
// Throws FileError if the results cannot be read or have no frame yet, or a file exists and is not to be
// replaced, or cannot be written or removed.
std::filesystem::path export_series(const std::filesystem::path& results,
                                    const std::filesystem::path& folder,
                                    Existing existing);

}  // namespace gxrod
