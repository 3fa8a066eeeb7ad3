#pragma once

#include <string>
#include <vector>

#include "report/report_plan.hpp"

namespace gxrod {

// Datasets of /VTKHDF/PointData and CellData.
struct ListedQuantities {
    std::vector<std::string> node_data, cell_data;
};

// Lists what a plan leaves out, a sentence each. `is_sampled`: whether elements are missing, not only joined.
std::vector<std::string> list_left_out(const ReportPlan& plan,
                                       const ListedQuantities& all,
                                       const ReportContent& content,
                                       bool is_sampled);

}  // namespace gxrod
