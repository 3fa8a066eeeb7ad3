#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace gxrod {

// Nodes that elements couple to each other, directly or through others, with their bodies and elements.
struct ModelPart {
    std::vector<int> nodes;  // ascending
    std::vector<int> rods;  // likewise; indices in Model::rods, bodies, springs, bushings, joints and sleeves
    std::vector<int> bodies;
    std::vector<int> springs = {};   // including those to another part
    std::vector<int> bushings = {};  // likewise
    std::vector<int> joints = {};    // likewise
    std::vector<int> sleeves = {};   // likewise
};

// The couplings that make a part: rods alone, or also springs, bushings and joints, which leave some motions
// of two nodes free.
enum class Ties { rods, all };

// Finds the parts, in the order of their first nodes; every node is in one part. A mesh of several separate
// lines makes one rod part of several.
std::vector<ModelPart> find_parts(const Model& model, Ties ties = Ties::all);

// Names a part in a sentence: "rod cable", "body gyroscope", "the part with rods arm and leg, body tip".
std::string name_part(const ModelPart& part, const Model& model);

}  // namespace gxrod
