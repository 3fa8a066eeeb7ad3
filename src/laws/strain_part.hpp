#pragma once

#include <array>
#include <span>

#include "rotation/types.hpp"

namespace gxrod {

// The part of the strains E = (Γ, K) on which a mechanism of a section acts.
enum class StrainPart { tension, shear, shear_y, shear_z, torsion, bending, bending_y, bending_z };

// Entries of E, one or two of them.
struct StrainEntries {
    std::array<int, 2> index{};
    int count = 1;

    std::span<const int> list() const& { return {index.data(), static_cast<std::size_t>(count)}; }
    std::span<const int> list() const&& = delete;  // it would outlive what it lists
};

// Returns the entries of a part, which live as long as the program.
const StrainEntries& entries_of(StrainPart part);

// Whether C couples one of the entries with any other entry.
bool couples(const Mat6& C, std::span<const int> entries);
// Whether C couples two of the entries.
bool couples_within(const Mat6& C, std::span<const int> entries);

}  // namespace gxrod
