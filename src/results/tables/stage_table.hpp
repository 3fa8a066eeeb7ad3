#pragma once

#include <optional>
#include <string_view>

#include "model/deck_record.hpp"
#include "results/file/append_dataset.hpp"
#include "results/stage_place.hpp"
#include "results/tables/shape_table.hpp"

namespace gxrod {

// Datasets of /histories that are no histories.
inline constexpr bool is_history_name(std::string_view name) { return name != "time" && name != "stage"; }

// Of a deck with stages: /histories/stage, the number of each row's stage from 0, and /stages/<name>, which
// says what the stage is and has the shapes that it found. Throws Hdf5Error.
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
    void append(int stage);
    void flush();
    void trim();
    // Takes away what stages after this one have left, and shapes of its own.
    void remove_after(std::int64_t stage);

  private:
    Hdf5Handle group_;  // none of a deck that has neither stages nor shapes
    std::optional<AppendDataset<std::int64_t>> column_;
};

}  // namespace gxrod
