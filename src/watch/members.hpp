#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/model.hpp"

// Members of a frame: pieces of rods between their ends, corners, branches, and points at which something
// else is.
namespace gxrod {

struct Member {
    std::string name;                // the rod's name, with a number if it has several: "columns/3"
    std::array<RodPlace, 2> ends{};  // its start and its end
    std::array<int, 2> nodes{};      // there
};

// Lists the members of all rods, in the order of their elements.
std::vector<Member> list_members(const Model& model);

}  // namespace gxrod
