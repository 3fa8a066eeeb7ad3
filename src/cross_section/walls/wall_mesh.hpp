#pragma once

#include <vector>

#include "cross_section/walls/wall_outline.hpp"

namespace gxrod {

struct WallMeshSettings {
    int order = 3;
    double refinement = 1.0;  // 2 halves the elements
};

// Meshes walls without a fault by quadrilaterals: rows of them through the plies, graded along the wall to
// its corners, free edges and changes of layup. Where layups differ the rows follow the interfaces of all of
// them, as fractions of the thickness, so that a ply can have several rows. Layers are named after layup and
// ply: "skin ply 0", counted as in a deck.
SectionMesh mesh_walls(const WallOutline& outline,
                       const std::vector<Layup>& layups,
                       const WallMeshSettings& settings = {});

}  // namespace gxrod
