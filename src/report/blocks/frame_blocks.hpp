#pragma once

#include <iosfwd>
#include <vector>

#include "report/model/load_arrows.hpp"
#include "report/report_plan.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// Writes the data of the 3D view as blocks: fixed data (reference, connectivity, offsets, axes, radii), the
// times, and all kept frames of each quantity, read a few at a time. Where the function of an arrow fails,
// its values are NaN. Throws Hdf5Error.
void write_frame_blocks(const Hdf5Reader& file,
                        const ReportPlan& plan,
                        const ReportContent& content,
                        const std::vector<LoadArrow>& arrows,
                        std::ostream& out);

}  // namespace gxrod
