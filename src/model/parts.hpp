#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace gxrod {

// Nodes that elements tie to each other, directly or by others; and what they carry.
struct ModelPart {
    std::vector<int> nodes;  // ascending
    std::vector<int> rods;  // likewise; indices in Model::rods, bodies, springs, bushings, joints and sleeves
    std::vector<int> bodies;
    std::vector<int> springs = {};   // also those that tie it to another part
    std::vector<int> bushings = {};  // likewise
    std::vector<int> joints = {};    // likewise
    std::vector<int> sleeves = {};   // likewise
};

// What ties nodes to each other: springs, bushings and joints leave some motions of two nodes free, rods
// none.
enum class Ties { rods, all };

// Every node is in one part; parts in the order of their first nodes. A mesh of several lines that do not
// touch makes one rod part of several.
std::vector<ModelPart> find_parts(const Model& model, Ties ties = Ties::all);

// As a sentence says it: "rod cable", "body gyroscope", "the part with rods arm and leg, body tip".
std::string name_part(const ModelPart& part, const Model& model);

}  // namespace gxrod
