#pragma once

#include <filesystem>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/blocks/step_blocks.hpp"
#include "report/findings/path_data.hpp"
#include "report/findings/response_data.hpp"
#include "report/findings/stage_list.hpp"
#include "report/findings/stage_shapes.hpp"
#include "report/report_plan.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// What the stages of a run have found: paths of equilibria, modes, eigenvalues, shapes of buckling, answers
// to forces that swing. A run without any adds nothing to its page.
class Findings {
  public:
    // What of it fits into `bytes` of data: paths and answers take a tenth of it each, at most, and shapes
    // three tenths, or more where frames are few. Throws Hdf5Error.
    Findings(const Hdf5Reader& file,
             const std::filesystem::path& results,
             const std::vector<StepChart>& charts,
             const ReportContent& content,
             std::size_t bytes);

    // All but the shapes, and what surrounds blocks.
    std::size_t count_bytes() const;
    // Of the shapes, for each node of the plan.
    std::size_t count_shape_vectors() const;
    std::vector<std::string> left_out() const;
    // Adds "stages", "paths", "modes", "responses" and "sweeps", as far as there are any.
    void describe(nlohmann::ordered_json& json) const;
    // Throws Hdf5Error.
    void write(const ReportPlan& plan, std::ostream& out) const;

  private:
    void add_shapes(const std::filesystem::path& results, const ReportContent& content, std::size_t bytes);
    void limit_shapes(const ReportContent& content, std::size_t bytes);
    nlohmann::ordered_json describe_swing(const std::string& stage) const;

    struct ShapesOfStage {
        std::string stage;
        StageShapes shapes;
    };

    const Hdf5Reader& file_;
    std::vector<FoundStage> stages_;
    std::vector<double> times_;  // of the rows of the histories, if there are stages
    PathData path_;
    std::vector<ResponseData> responses_;
    std::vector<ShapesOfStage> shapes_;
};

}  // namespace gxrod
