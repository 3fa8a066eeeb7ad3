#pragma once

#include <iosfwd>
#include <vector>

#include "report/model/load_arrows.hpp"
#include "report/report_plan.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Writes what the 3D view shows, as blocks of data: what does not move (reference, connectivity, offsets,
// axes, radii), the times, and of each quantity all kept frames, read a few at a time. The arrows' values
// where a function fails are not numbers. Throws Hdf5Error.
void write_frame_blocks(const Hdf5Reader& file,
                        const ReportPlan& plan,
                        const ReportContent& content,
                        const std::vector<LoadArrow>& arrows,
                        std::ostream& out);

}  // namespace gxrod
