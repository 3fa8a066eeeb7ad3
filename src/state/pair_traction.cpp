#include "state/pair_traction.hpp"

#include <bit>

namespace gxrod {

std::vector<PairTractionRow> pack(const std::vector<PairTraction>& pairs) {
    std::vector<PairTractionRow> rows;
    for (const PairTraction& pair : pairs) {
        rows.emplace_back();
        rows.back() << pair.pieces.first, pair.pieces.second, pair.traction;
    }
    if (!rows.empty()) rows.resize(std::bit_ceil(rows.size()), PairTractionRow::Zero());
    return rows;
}

std::vector<PairTraction> unpack(const std::vector<PairTractionRow>& rows) {
    std::vector<PairTraction> pairs;
    for (const PairTractionRow& row : rows) {
        // No piece touches itself.
        if (row[0] == row[1]) break;
        pairs.push_back(
            {{static_cast<std::uint32_t>(row[0]), static_cast<std::uint32_t>(row[1])}, row.tail<3>()});
    }
    return pairs;
}

}  // namespace gxrod
