#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cross_section/section_mesh.hpp"
#include "cross_section/walls/layup.hpp"

namespace gxrod {

// A corner of the line of a wall; with a radius an arc, which touches both sides, rounds the line.
struct WallCorner {
    PlanePoint at;
    double radius = 0.0;
};

// Which side of the wall its line is, for who walks along it.
enum class WallSide { left, middle, right };

// A wall along a chain of straight sides, which are mitred where no radius rounds the corner. A closed one is
// walked anticlockwise, so that its plies are listed from outside in.
struct WallOutline {
    std::vector<WallCorner> corners;
    bool is_closed = false;
    WallSide line = WallSide::middle;
    std::vector<int> layups;  // indices of layups: one for all sides, or one for each

    std::size_t side_count() const { return is_closed ? corners.size() : corners.size() - 1; }
    std::size_t layup_of(std::size_t side) const {
        return static_cast<std::size_t>(layups[layups.size() == 1 ? 0 : side]);
    }
};

// A fault of walls: the part of them, such as "corners[3]", and the message.
struct WallFault {
    std::string part;
    std::string message;
};

// Finds what is wrong with a layup: "plies[1]", without thickness.
std::optional<WallFault> find_fault(const Layup& layup);

// Finds what is wrong with walls whose layups have no fault. Sides and corners are counted from 0; side k
// goes from corner k to the next. Without a fault they can be meshed.
std::optional<WallFault> find_fault(const WallOutline& outline, const std::vector<Layup>& layups);

}  // namespace gxrod
