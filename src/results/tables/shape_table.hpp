#pragma once

#include <span>
#include <string>

#include "model/model.hpp"
#include "results/file/hdf5_objects.hpp"
#include "state/records/shapes_record.hpp"

namespace gxrod {

// The dataset of words for each shape.
inline constexpr const char* shape_words_name = "words";
// The dataset of the values of a sweep.
inline constexpr const char* sweep_values_name = "value";
// The dataset of words for each mode of a sweep, value by value.
inline constexpr const char* sweep_words_name = "words_at_values";
inline constexpr const char* onsets_name = "onset";
// Returns whether a group of /stages belongs to a stage that took no steps.
inline bool has_findings(const Hdf5Handle& group) {
    return has_link(group, shape_words_name) || has_link(group, "omega");
}

// Writes the results of a stage of shapes into its group of /stages; docs/guide/results.md lists the
// datasets. `scales` are the factors of the shapes in their own file. Throws Hdf5Error.
void write_shape_table(const Hdf5Handle& group,
                       const Model& model,
                       const ShapesRecord& record,
                       std::span<const double> scales);

// Lists the shapes in the order of the table.
std::vector<const Shape*> list_shapes_of(const ShapesRecord& record);
// Lists the equilibria about which they are: of a sweep one for each shape, else `own` for all.
std::vector<std::span<const NodeMotion>> list_equilibria_of(const ShapesRecord& record,
                                                            std::span<const NodeMotion> own);
// Lists their imaginary parts; empty if they are real.
std::vector<const std::vector<Vec6>*> list_imaginary_parts(const ShapesRecord& record);

}  // namespace gxrod
