#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/checked_deck.hpp"
#include "deck/fault_list.hpp"
#include "deck/point.hpp"
#include "model/model.hpp"

namespace gxrod {

// A point that has a node.
struct PlacedPoint {
    int node = 0;
    int rod = -1;             // index in Model::rods, or -1
    int position_in_rod = 0;  // index in Rod::nodes
    int body = -1;            // index in Model::bodies, or -1
};

// What the builders of a model share. Tables of rods and bodies have the order of Model::rods and
// Model::bodies. A builder adds what is wrong to `faults` and goes on with the rest; where a rod or body
// could not be built, its place in the model is kept and its points have no node.
struct BuildContext {
    const CheckedTable& deck;
    const PointNames& names;
    FaultList& faults;
    std::vector<std::string>& notes;
    Model& model;
    std::vector<std::vector<double>> rod_fractions;  // of each rod's nodes; empty for a rod without a mesh
    std::vector<int> body_nodes;                     // of each body; -1 for one without

    void add_fault(const CheckedTable& table, std::string_view key, std::string message) const {
        faults.add(table.place_of(key), table.path_of(key), std::move(message));
    }

    // The node of a point that the deck names; nullopt if there is none, without a fault.
    std::optional<PlacedPoint> place(const std::string& point) const;
};

}  // namespace gxrod
