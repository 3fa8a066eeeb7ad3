#pragma once

#include <cstddef>
#include <span>

#include "state/state.hpp"

namespace gxrod {

// The numbers of State::memory that belong to one part of a system.
struct MemorySlice {
    std::size_t first = 0, count = 0;

    std::size_t end() const { return first + count; }
    std::span<const double> of(const State& state) const {
        return std::span(state.memory).subspan(first, count);
    }
    std::span<double> of(State& state) const { return std::span(state.memory).subspan(first, count); }
    // Returns the numbers of one of several equal pieces.
    MemorySlice piece(std::size_t index, std::size_t size) const { return {first + index * size, size}; }
};

}  // namespace gxrod
