#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rotation/types.hpp"

// The broad phase: finds the capsules that are near enough to touch.
namespace gxrod {

// All points within a radius of a straight segment.
struct Capsule {
    Vec3 start, end;
    double radius = 0.0;
};

struct CapsulePair {
    std::uint32_t first, second;  // first < second

    bool operator==(const CapsulePair&) const = default;
    auto operator<=>(const CapsulePair&) const = default;
};

// Finds all pairs whose boxes, along the axes, are less than `margin` apart, and which `keep` accepts (each
// is asked for once): no other pair can be nearer than the margin. They are sorted, so independent of the
// cells.
std::vector<CapsulePair> find_near_pairs(std::span<const Capsule> capsules,
                                         double margin,
                                         const std::function<bool(CapsulePair)>& keep);
std::vector<CapsulePair> find_near_pairs(std::span<const Capsule> capsules, double margin);

}  // namespace gxrod
