#pragma once

#include <optional>
#include <string_view>

#include "model/deck_record.hpp"
#include "results/file/append_dataset.hpp"
#include "results/stage_place.hpp"
#include "results/tables/path_table.hpp"
#include "results/tables/shape_table.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// Datasets of /histories that are no histories.
inline constexpr bool is_history_name(std::string_view name) {
    return name != "time" && name != "stage" && name != "load_factor" && name != "limit_load_factor" &&
           name != "branch";
}

// Of a deck with stages: /histories/stage, the number of each row's stage from 0, and /stages/<name>, which
// says what the stage is and has the shapes or critical points that it found. Of a deck with a path,
// /histories/load_factor and branch, too; where limit points are followed, limit_load_factor. Throws
// Hdf5Error.
class StageTable {
  public:
    // Appends after so many rows.
    StageTable(const Hdf5Handle& root, const Hdf5Handle& histories, const DeckRecord& deck, hsize_t rows);

    // The rows from `first_row` on are of this stage.
    void begin_stage(const StagePlace& stage, hsize_t first_row);
    // What a stage has found that takes no steps.
    void write_shapes(const StagePlace& stage,
                      const Model& model,
                      const ShapesRecord& record,
                      std::span<const double> scales,
                      hsize_t rows);
    // What a stage has found that goes along a path.
    void write_paths(const StagePlace& stage, const PathRecord& paths, hsize_t rows);
    void append(const Snapshot& snapshot);
    void flush();
    void trim();
    // Takes away what stages after this one have left, and what it has found itself.
    void remove_after(std::int64_t stage);

  private:
    Hdf5Handle group_;  // none of a deck that has neither stages nor shapes
    std::optional<AppendDataset<std::int64_t>> column_, branches_;
    std::optional<AppendDataset<double>> load_factors_, limit_load_factors_;
};

}  // namespace gxrod
