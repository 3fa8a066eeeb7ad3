#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {

// Nodes that elements couple to each other, directly or through others, with their bodies and elements.
struct ModelPart {
    std::vector<int> nodes;  // ascending
    std::vector<int> rods;   // likewise; indices in Model::rods and bodies
    std::vector<int> bodies;
    std::array<std::vector<int>, tie_kind_count> ties_by_kind = {};  // including ties to another part

    // Lists the ties of a kind, by their indices in the model's list of it.
    const std::vector<int>& ties(TieKind kind) const { return ties_by_kind[static_cast<std::size_t>(kind)]; }
    bool has(TieKind kind) const { return !ties(kind).empty(); }
};

// The couplings that make a part: rods alone, or also all ties, which leave some motions of two nodes free.
enum class Ties { rods, all };

// Finds the parts, in the order of their first nodes; every node is in one part. A mesh of several separate
// lines makes one rod part of several.
std::vector<ModelPart> find_parts(const Model& model, Ties ties = Ties::all);

// Returns whether supports or joints to the ground keep the model from moving as one rigid body.
bool is_held(const Model& model);
// Whether a joint or a sleeve ties something to the ground.
bool is_joined_to_ground(const Model& model);

// Names a part in a sentence: "rod cable", "body gyroscope", "the part with rods arm and leg, body tip".
std::string name_part(const ModelPart& part, const Model& model);

}  // namespace gxrod
