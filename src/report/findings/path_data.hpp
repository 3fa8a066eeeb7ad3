#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "report/blocks/step_blocks.hpp"
#include "report/findings/stage_list.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// The points of a page's charts over the load factor: rows of the histories of all stages that follow a path.
class PathData {
  public:
    // Reads the first `steps` rows. If they take more than `bytes`, thins them evenly; the ends of branches
    // and the critical points stay. Throws Hdf5Error.
    PathData(const Hdf5Reader& file,
             const std::vector<FoundStage>& stages,
             const std::vector<StepChart>& charts,
             std::size_t steps,
             std::size_t bytes);

    bool is_empty() const { return rows_.empty(); }
    // Returns the bytes in the page, as base64.
    std::size_t count_bytes() const;
    // Returns a sentence on what was left out, or "".
    std::string left_out() const;
    // Lists, for each shape in the file of a stage's shapes, the row of the histories of its critical point.
    std::vector<std::size_t> list_rows_of_shapes(const FoundStage& stage) const;
    // Returns [{stage, first, count, paths: [{name, parent, critical_point, cause}], points: [{kind, …}]}];
    // rows are rows of the blocks.
    nlohmann::ordered_json describe() const;
    // Writes the blocks "path-times", "path-loads", "path-branches", "path-pivots" and, column after column
    // of the histories' charts, "path-values".
    void write(std::ostream& out) const;

  private:
    struct Stretch {
        FoundStage stage;
        std::size_t first, end;  // rows of the histories
    };
    void choose_rows(std::size_t bytes);
    std::size_t place_of(double row) const;
    std::size_t bytes_of_row() const;
    nlohmann::ordered_json describe_points(const FoundStage& stage) const;
    nlohmann::ordered_json describe_paths(const FoundStage& stage) const;

    const Hdf5Reader& file_;
    std::vector<StepChart> charts_;  // charts of the histories
    std::size_t columns_ = 0;
    std::vector<Stretch> stretches_;
    std::vector<double> branches_, pivots_;  // for all rows
    std::vector<std::size_t> rows_;          // rows that are kept
    std::size_t all_rows_ = 0;               // on paths
};

}  // namespace gxrod
