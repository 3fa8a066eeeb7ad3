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

// The results of the stages of a run: paths of equilibria, modes, eigenvalues, buckling shapes, responses to
// harmonic forces. A run without any adds nothing to its page.
class Findings {
  public:
    // Reads what fits into `bytes` of data: paths and responses take at most a tenth each, and shapes three
    // tenths, or more if frames are few. Throws Hdf5Error.
    Findings(const Hdf5Reader& file,
             const std::filesystem::path& results,
             const std::vector<StepChart>& charts,
             const ReportContent& content,
             std::size_t bytes);

    // Counts all except the shapes, with the text around blocks.
    std::size_t count_bytes() const;
    // Counts the vectors of the shapes for each node of the plan.
    std::size_t count_shape_vectors() const;
    std::vector<std::string> left_out() const;
    // Adds "stages", "paths", "modes", "responses" and "sweeps", if there are any.
    void describe(nlohmann::ordered_json& json) const;
    // Writes the blocks. Throws Hdf5Error.
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
    std::vector<double> times_;  // times of the rows of the histories, if there are stages
    PathData path_;
    std::vector<ResponseData> responses_;
    std::vector<ShapesOfStage> shapes_;
};

}  // namespace gxrod
