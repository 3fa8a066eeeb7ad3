#include "results/tables/stage_table.hpp"

namespace gxrod {

StageTable::StageTable(const Hdf5Handle& root,
                       const Hdf5Handle& histories,
                       const DeckRecord& deck,
                       hsize_t rows) {
    if (!deck.stages.empty() || deck.finds_shapes || deck.has_paths) group_ = require_group(root, "stages");
    if (deck.has_paths) {
        load_factors_.emplace(
            histories,
            DatasetLabel{
                "load_factor", "t of the stage: on paths and in statics the load factor", "none", "1"},
            scalar_row,
            rows);
        branches_.emplace(
            histories,
            DatasetLabel{
                "branch", "row of the branch in branches of its stage; 0: the main path", "none", "1"},
            scalar_row,
            rows);
    }
    if (deck.follows_limits)
        limit_load_factors_.emplace(
            histories,
            DatasetLabel{"limit_load_factor",
                         "where limit points are followed, that of the limit point; else as load_factor",
                         "none",
                         "1"},
            scalar_row,
            rows);
    if (deck.stages.empty()) return;
    const DatasetLabel label{"stage", "number of the stage of each accepted step, from 0", "none", "1"};
    column_.emplace(histories, label, scalar_row, rows);
}

void StageTable::begin_stage(const StagePlace& stage, hsize_t first_row) {
    if (!group_.is_open()) return;
    const bool is_new = !has_link(group_, stage.name);
    const Hdf5Handle group = require_group(group_, stage.name);
    if (!is_new) return;
    const auto number = static_cast<std::int64_t>(stage.index);
    const auto row = static_cast<std::int64_t>(first_row);
    write_attribute(group.id(), "number", std::span(&number, 1));
    write_attribute(group.id(), "kind", stage.kind);
    write_attribute(group.id(), "first_row", std::span(&row, 1));
}

void StageTable::write_shapes(const StagePlace& stage,
                              const Model& model,
                              const ShapesRecord& record,
                              std::span<const double> scales,
                              hsize_t rows) {
    begin_stage(stage, rows);
    write_shape_table(require_group(group_, stage.name), model, record, scales);
}

void StageTable::write_paths(const StagePlace& stage, const PathRecord& paths, hsize_t rows) {
    begin_stage(stage, rows);
    write_path_tables(require_group(group_, stage.name), paths);
}

void StageTable::append(const Snapshot& snapshot) {
    if (column_) column_->append(snapshot.stage);
    if (!load_factors_) return;
    load_factors_->append(snapshot.load_factor);
    branches_->append(snapshot.branch);
    if (limit_load_factors_) limit_load_factors_->append(snapshot.limit_load_factor);
}

void StageTable::flush() {
    if (column_) column_->flush();
    if (!load_factors_) return;
    load_factors_->flush();
    branches_->flush();
    if (limit_load_factors_) limit_load_factors_->flush();
}

void StageTable::trim() {
    if (column_) column_->trim();
    if (!load_factors_) return;
    load_factors_->trim();
    branches_->trim();
    if (limit_load_factors_) limit_load_factors_->trim();
}

void StageTable::remove_after(std::int64_t stage) {
    if (!group_.is_open()) return;
    for (const std::string& name : list_members(group_.id())) {
        std::int64_t number = 0;
        bool has_shapes = false;  // which are found anew
        {
            const Hdf5Handle group(H5Gopen2(group_.id(), name.c_str(), H5P_DEFAULT), H5Gclose, "a stage");
            const Hdf5Handle attribute(H5Aopen(group.id(), "number", H5P_DEFAULT), H5Aclose, "its number");
            check_hdf5(H5Aread(attribute.id(), H5T_NATIVE_INT64, &number), "reading an attribute");
            has_shapes = has_findings(group);
            if (number == stage) remove_path_tables(group);
        }
        if (number > stage || (number == stage && has_shapes))
            check_hdf5(H5Ldelete(group_.id(), name.c_str(), H5P_DEFAULT), "removing a stage");
    }
}

}  // namespace gxrod
