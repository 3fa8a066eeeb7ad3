#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "model/deck_record.hpp"
#include "model/model.hpp"
#include "state/motion.hpp"
#include "state/records/mode_record.hpp"

namespace gxrod {

// What makes the largest displacement of each shape a tenth of the model's extent; of a shape that displaces
// nothing, the largest rotation 0.3 rad.
std::vector<double> find_shape_scales(const Model& model, const std::vector<const Shape*>& shapes);

// NAME.STAGE.vtkhdf beside the results file of this path, whose shapes it has.
std::filesystem::path shape_file_path(const std::filesystem::path& results, const std::string& stage);

// Shapes for ParaView, a step each, numbered from 1: points where the equilibrium has them, which is one of
// all shapes or one of each, PointData displacement and rotation_vector of the shape, multiplied by its
// scale; of complex shapes displacement_imaginary and rotation_vector_imaginary, too. Replaces a file of this
// path, written whole. Throws FileError or WriteError.
void write_shape_file(const std::filesystem::path& path,
                      const DeckRecord& deck,
                      const Model& model,
                      std::span<const std::span<const NodeMotion>> equilibria,
                      const std::vector<const Shape*>& shapes,
                      std::span<const double> scales,
                      const std::vector<const std::vector<Vec6>*>& imaginary = {});

}  // namespace gxrod
