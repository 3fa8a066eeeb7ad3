#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "model/deck_record.hpp"
#include "model/model.hpp"
#include "state/motion.hpp"
#include "state/records/mode_record.hpp"

namespace gxrod {

// Finds factors that make the largest displacement of each shape a tenth of the model's extent, or, if a
// shape displaces nothing, its largest rotation 0.3 rad.
std::vector<double> find_shape_scales(const Model& model, const std::vector<const Shape*>& shapes);

// Returns the path NAME.STAGE.vtkhdf, next to the results file, for the shapes of a stage.
std::filesystem::path shape_file_path(const std::filesystem::path& results, const std::string& stage);

// Writes shapes for ParaView, a step each, numbered from 1: points as in the equilibrium, one for all shapes
// or one for each; PointData displacement and rotation_vector of the shape times its scale; for complex
// shapes also displacement_imaginary and rotation_vector_imaginary. An existing file is replaced once the new
// one is whole. Throws FileError or WriteError.
void write_shape_file(const std::filesystem::path& path,
                      const DeckRecord& deck,
                      const Model& model,
                      std::span<const std::span<const NodeMotion>> equilibria,
                      const std::vector<const Shape*>& shapes,
                      std::span<const double> scales,
                      const std::vector<const std::vector<Vec6>*>& imaginary = {});

}  // namespace gxrod
