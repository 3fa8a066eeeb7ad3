#include "laws/strain_part.hpp"

#include <algorithm>

namespace gxrod {

StrainEntries entries_of(StrainPart part) {
    switch (part) {
        case StrainPart::tension:
            return {{0}, 1};
        case StrainPart::shear:
            return {{1, 2}, 2};
        case StrainPart::shear_y:
            return {{1}, 1};
        case StrainPart::shear_z:
            return {{2}, 1};
        case StrainPart::torsion:
            return {{3}, 1};
        case StrainPart::bending:
            return {{4, 5}, 2};
        case StrainPart::bending_y:
            return {{4}, 1};
        case StrainPart::bending_z:
            return {{5}, 1};
    }
    return {};
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
