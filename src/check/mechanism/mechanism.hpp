#pragma once

#include <string>
#include <vector>

#include "check/summaries/item_list.hpp"
#include "model/model.hpp"

namespace gxrod {

// Rigid bodies that joints connect without rods between, and how their joints hold them at t = 0.
struct Mechanism {
    std::vector<int> bodies;  // indices in Model::bodies
    std::vector<int> joints;  // in Model::joints: those between these bodies and the ground
    int joints_to_rods = 0;   // others, which the numbers below leave out
    std::vector<int> gears;   // in Model::gears: those between these joints
    int motors = 0;
    bool is_counted = false;  // whether it is small enough for what follows

    int equations = 0;     // of its joints, motors left out, but those that a plane of the deck meets anyway
    int redundant = 0;     // equations that follow from the others and from supports
    int free_motions = 0;  // that joints and supports leave; motors move some of them
    int unmoved = 0;       // those that motors leave
    std::vector<int> redundant_joints;    // whose equations these are, in Model::joints; gears behind them
    std::vector<int> conflicting_motors;  // joints whose motors move what is held or moved otherwise
    bool has_redundant_supports = false;  // whether supports are among what holds several times
};

std::vector<Mechanism> find_mechanisms(const Model& model);

// A line for each: "mechanism: 5 bodies, 6 joints, 30 equations of rank 29: 1 free motion; …".
ItemList list_mechanisms(const Model& model);

// What motors cannot do, as a sentence for each mechanism in which they contradict what holds or moves it.
std::vector<std::string> find_motor_conflicts(const Model& model);

}  // namespace gxrod
