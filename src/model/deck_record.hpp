#pragma once

#include <string>
#include <vector>

namespace gxrod {

// A mesh file that a deck names.
struct MeshRecord {
    std::string file;   // as the deck names it
    std::string bytes;  // the whole file
};

// Where a model came from, kept with its results.
struct DeckRecord {
    std::string name;  // file name of the deck
    std::string text;  // the deck as run, after --set; itself a valid deck
    std::string title;
    std::string units;                     // a label only
    bool is_static = false;                // no stage has time: t is a load factor
    bool has_statics = false;              // some stage has none
    bool finds_shapes = false;             // some stage finds modes or the like
    bool has_paths = false;                // some stage goes along a path: t is a column of its own
    bool follows_limits = false;           // some stage follows limit points
    std::string integrators = {};          // that advance time: "radau-5", or "move: radau-5" of each stage
    std::vector<std::string> stages = {};  // their names; none of a deck without [[stage]]
    std::vector<MeshRecord> meshes = {};
};

}  // namespace gxrod
