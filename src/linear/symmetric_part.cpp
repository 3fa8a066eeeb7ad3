#include "linear/symmetric_part.hpp"

#include <algorithm>
#include <cassert>

namespace gxrod {

namespace {

struct Entry {
    std::int64_t row;
    std::int64_t slot;
    bool mirrored;  // of the upper triangle
};

// The entries of each column of the lower triangle, in any order; those of the upper one stand mirrored.
std::vector<std::vector<Entry>> collect_entries(const SparsePattern& pattern) {
    std::vector<std::vector<Entry>> columns(static_cast<std::size_t>(pattern.size()));
    for (std::int64_t j = 0; j < pattern.size(); ++j) columns[j].push_back({j, -1, false});
    pattern.visit_entries([&](std::int64_t i, std::int64_t j, std::int64_t slot) {
        if (i >= j) columns[j].push_back({i, slot, false});
        if (i <= j) columns[i].push_back({j, slot, true});
    });
    return columns;
}

}  // namespace

SymmetricPart::SymmetricPart(const SparsePattern& pattern) {
    for (std::vector<Entry>& column : collect_entries(pattern)) {
        std::stable_sort(
            column.begin(), column.end(), [](const Entry& a, const Entry& b) { return a.row < b.row; });
        std::int64_t last_row = -1;
        for (const Entry& entry : column) {
            if (entry.row != last_row) {
                lower_.rows.push_back(entry.row);
                slots_.push_back(-1);
                mirrored_.push_back(-1);
                last_row = entry.row;
            }
            if (entry.slot >= 0) (entry.mirrored ? mirrored_ : slots_).back() = entry.slot;
        }
        lower_.column_starts.push_back(lower_.nonzeros());
    }
}

void SymmetricPart::compute(const std::vector<double>& values, std::vector<double>& lower) const {
    lower.resize(slots_.size());
    for (std::size_t k = 0; k < slots_.size(); ++k) {
        const double below = slots_[k] < 0 ? 0.0 : values[slots_[k]];
        const double above = mirrored_[k] < 0 ? 0.0 : values[mirrored_[k]];
        lower[k] = 0.5 * (below + above);
    }
}

}  // namespace gxrod
