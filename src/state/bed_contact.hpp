#pragma once

#include <cstddef>
#include <span>

#include "rotation/types.hpp"

namespace gxrod {

// Memory of a piece of a rod that lies on the ground: the place to which friction pulls it back.
struct BedContact {
    double touches = 0.0;        // 1 or 0
    Vec3 target = Vec3::Zero();  // a place of the node
};

// As numbers in State::memory.
inline constexpr std::size_t numbers_of_bed_contact = 4;
inline BedContact read_bed_contact(std::span<const double> memory) {
    return {memory[0], Vec3(memory[1], memory[2], memory[3])};
}
inline void write(const BedContact& contact, std::span<double> memory) {
    memory[0] = contact.touches;
    for (std::size_t i = 0; i < 3; ++i) memory[1 + i] = contact.target[static_cast<Eigen::Index>(i)];
}

}  // namespace gxrod
