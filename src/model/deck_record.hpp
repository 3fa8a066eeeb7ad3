#pragma once

#include <string>
#include <vector>

namespace gxrod {

// A mesh file that a deck names.
struct MeshRecord {
    std::string file;   // name in the deck
    std::string bytes;  // the whole file
};

// The origin of a model, kept with its results.
struct DeckRecord {
    std::string name;  // file name of the deck
    std::string text;  // the deck as run, after --set; itself a valid deck
    std::string title;
    std::string units;             // only a label
    bool is_static = false;        // no stage has time: t is a load factor
    bool has_statics = false;      // some stage has no time
    bool finds_shapes = false;     // some stage finds modes or other shapes
    bool has_paths = false;        // some stage follows a path: t is a separate column
    bool follows_limits = false;   // some stage follows limit points
    std::string integrators = {};  // integrators in time, "radau-5", or for each stage "move: radau-5"
    std::vector<std::string> stages = {};  // names of stages; none for a deck without [[stage]]
    std::vector<MeshRecord> meshes = {};
};

}  // namespace gxrod
