#pragma once

#include <span>
#include <string>

#include "model/model.hpp"
#include "results/file/hdf5_objects.hpp"
#include "state/mode_record.hpp"

namespace gxrod {

// A dataset of the table that has a number for each shape, and one of words for each.
inline constexpr const char* shape_words_name = "words";

// What a stage of shapes has found, into its group of /stages; docs/guide/results.md lists the datasets.
// `scales` are what the shapes of its own file are multiplied by. Throws Hdf5Error.
void write_shape_table(const Hdf5Handle& group,
                       const Model& model,
                       const ShapesRecord& record,
                       std::span<const double> scales);

// The shapes, in the order of the table.
std::vector<const Shape*> list_shapes_of(const ShapesRecord& record);

}  // namespace gxrod
