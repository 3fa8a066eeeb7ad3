#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

// Another shape at t = 0, stress-free as the one before: the start of a structure that is not perfect.
namespace gxrod {

// Says why the start of a model cannot be displaced; "" if it can.
std::string explain_fixed_start(const Model& model);

// A change of the shape at t = 0.
struct StartChange {
    std::vector<Vec3> displacements;  // of each node
    std::vector<Vec3> turns;          // rotation vector of each node: of bodies there, and of arms
    // For each rod, by element_nodes: rotation vectors of its section axes.
    std::vector<std::vector<Vec3>> section_turns;

    explicit StartChange(const Model& model);
};

// Displaces the start. Points on the ground follow what they are tied to, and springs stay as strained as
// they were. Returns the name of a joint whose points it would part; "" if there is none.
std::string displace_start(const StartChange& change, Model& model);

}  // namespace gxrod
