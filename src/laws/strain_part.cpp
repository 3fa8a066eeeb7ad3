#include "laws/strain_part.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace gxrod {

const StrainEntries& entries_of(StrainPart part) {
    // In the order of StrainPart.
    static constexpr std::array<StrainEntries, 8> entries{
        {{{0}, 1}, {{1, 2}, 2}, {{1}, 1}, {{2}, 1}, {{3}, 1}, {{4, 5}, 2}, {{4}, 1}, {{5}, 1}}};
    return entries[static_cast<std::size_t>(part)];
}

bool couples(const Mat6& C, std::span<const int> entries) {
    return std::ranges::any_of(
        entries, [&](int i) { return (C.row(i).array() != 0.0).count() > (C(i, i) != 0.0 ? 1 : 0); });
}

bool couples_within(const Mat6& C, std::span<const int> entries) {
    return std::ranges::any_of(entries, [&](int i) {
        return std::ranges::any_of(entries, [&](int j) { return i != j && C(i, j) != 0.0; });
    });
}

}  // namespace gxrod
