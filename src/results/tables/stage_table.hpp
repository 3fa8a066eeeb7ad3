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

// Returns whether a member of /histories is a history.
inline constexpr bool is_history_name(std::string_view name) {
    return name != "time" && name != "stage" && name != "load_factor" && name != "limit_load_factor" &&
           name != "branch";
}

// The tables of a deck with stages: /histories/stage, the number of each row's stage from 0, and
// /stages/<name>, with the kind of the stage and the shapes or critical points that it found. Also
// /histories/load_factor and branch if the deck has a path, and limit_load_factor if limit points are
// followed. Throws Hdf5Error.
class StageTable {
  public:
    // Appends after `rows` rows.
    StageTable(const Hdf5Handle& root, const Hdf5Handle& histories, const DeckRecord& deck, hsize_t rows);

    // Assigns the rows from `first_row` on to this stage.
    void begin_stage(const StagePlace& stage, hsize_t first_row);
    // Writes the results of a stage without steps.
    void write_shapes(const StagePlace& stage,
                      const Model& model,
                      const ShapesRecord& record,
                      std::span<const double> scales,
                      hsize_t rows);
    // Writes the results of a stage that follows a path.
    void write_paths(const StagePlace& stage, const PathRecord& paths, hsize_t rows);
    void append(const Snapshot& snapshot);
    void flush();
    void trim();
    // Removes the tables of stages after this one, and its own results.
    void remove_after(std::int64_t stage);

  private:
    Hdf5Handle group_;  // none if the deck has neither stages nor shapes
    std::optional<AppendDataset<std::int64_t>> column_, branches_;
    std::optional<AppendDataset<double>> load_factors_, limit_load_factors_;
};

}  // namespace gxrod
