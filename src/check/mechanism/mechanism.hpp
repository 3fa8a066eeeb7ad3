#pragma once

#include <string>
#include <vector>

#include "check/summaries/item_list.hpp"
#include "model/model.hpp"

namespace gxrod {

// Rigid bodies that joints connect without rods in between, with the degrees of freedom that joints leave at
// t = 0.
struct Mechanism {
    std::vector<int> bodies;  // indices in Model::bodies
    std::vector<int> joints;  // joints between these bodies and the ground, in Model::joints
    int joints_to_rods = 0;   // other joints, which the numbers below leave out
    std::vector<int> gears;   // gears between these joints, in Model::gears
    int motors = 0;
    bool is_counted = false;  // whether it is small enough for the numbers below

    int equations =
        0;  // equations of its joints, motors left out, without those that a plane of the deck meets anyway
    int redundant = 0;                    // equations that follow from the others and from supports
    int free_motions = 0;                 // motions that joints and supports leave; motors move some of them
    int unmoved = 0;                      // motions that motors leave
    std::vector<int> redundant_joints;    // joints with these equations, in Model::joints; gears follow them
    std::vector<int> conflicting_motors;  // joints whose motors move something held or moved otherwise
    bool has_redundant_supports = false;  // whether supports are part of the redundancy
};

std::vector<Mechanism> find_mechanisms(const Model& model);

// Lists a line for each: "mechanism: 5 bodies, 6 joints, 30 equations of rank 29: 1 free motion; …".
ItemList list_mechanisms(const Model& model);

// Lists a sentence for each mechanism in which motors contradict its supports, joints or other motors.
std::vector<std::string> find_motor_conflicts(const Model& model);

}  // namespace gxrod
