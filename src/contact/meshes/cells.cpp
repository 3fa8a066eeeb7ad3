#include "contact/meshes/cells.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

// Each box is entered in all cells of a grid that it meets; entries are sorted by cell, and boxes are
// compared within cells. Two boxes can meet in several cells: they are reported in the one that holds the
// lower corner of what they have in common. In each direction, that corner's cell is the lower one of one of
// the boxes.
namespace gxrod {
namespace {

struct CapsuleBox {
    std::array<double, 3> low, high;
};

struct CellEntry {
    std::uint64_t cell;
    std::uint32_t capsule;
    std::uint32_t is_lowest;  // bit k: the cell is the lowest of the box in direction k
};

constexpr std::uint64_t most_cells_a_direction = std::uint64_t{1} << 21U;
constexpr std::uint32_t lowest_in_all = 7;

std::vector<CapsuleBox> make_boxes(std::span<const Capsule> capsules, double margin) {
    std::vector<CapsuleBox> boxes(capsules.size());
    for (std::size_t i = 0; i < capsules.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const double reach = capsules[i].radius + 0.5 * margin;
            boxes[i].low[k] = std::min(capsules[i].start[k], capsules[i].end[k]) - reach;
            boxes[i].high[k] = std::max(capsules[i].start[k], capsules[i].end[k]) + reach;
        }
    return boxes;
}

bool do_overlap(const CapsuleBox& a, const CapsuleBox& b) {
    return a.low[0] < b.high[0] && b.low[0] < a.high[0] && a.low[1] < b.high[1] && b.low[1] < a.high[1] &&
           a.low[2] < b.high[2] && b.low[2] < a.high[2];
}

class CellGrid {
  public:
    explicit CellGrid(const std::vector<CapsuleBox>& boxes) : boxes_(boxes), origin_(boxes.front().low) {
        double extents = 0.0, greatest = 0.0;
        std::array<double, 3> top = boxes.front().high;
        for (const CapsuleBox& box : boxes)
            for (int k = 0; k < 3; ++k) {
                origin_[k] = std::min(origin_[k], box.low[k]);
                top[k] = std::max(top[k], box.high[k]);
                extents += box.high[k] - box.low[k];
            }
        for (int k = 0; k < 3; ++k) greatest = std::max(greatest, top[k] - origin_[k]);
        size_ = std::max(extents / (3.0 * static_cast<double>(boxes.size())),
                         greatest / static_cast<double>(most_cells_a_direction - 2));
        if (!(size_ > 0.0)) size_ = 1.0;
        // Long boxes fill many small cells.
        while (count_entries() > 8.0 * static_cast<double>(boxes.size())) size_ *= 1.5;
    }

    std::vector<CellEntry> list_entries() const {
        std::vector<CellEntry> entries;
        entries.reserve(static_cast<std::size_t>(count_entries()));
        for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
            std::array<std::uint64_t, 3> low{}, high{};
            for (int k = 0; k < 3; ++k) {
                low[k] = find_cell(boxes_[i].low[k], k);
                high[k] = find_cell(boxes_[i].high[k], k);
            }
            for (std::uint64_t z = low[2]; z <= high[2]; ++z)
                for (std::uint64_t y = low[1]; y <= high[1]; ++y)
                    for (std::uint64_t x = low[0]; x <= high[0]; ++x)
                        entries.push_back(
                            {(z * most_cells_a_direction + y) * most_cells_a_direction + x,
                             i,
                             (x == low[0] ? 1U : 0U) | (y == low[1] ? 2U : 0U) | (z == low[2] ? 4U : 0U)});
        }
        return entries;
    }

  private:
    const std::vector<CapsuleBox>& boxes_;
    std::array<double, 3> origin_;
    double size_ = 1.0;

    std::uint64_t find_cell(double place, int k) const {
        return static_cast<std::uint64_t>((place - origin_[k]) / size_);
    }

    double count_entries() const {
        double count = 0.0;
        for (const CapsuleBox& box : boxes_) {
            double cells = 1.0;
            for (int k = 0; k < 3; ++k)
                cells *= static_cast<double>(find_cell(box.high[k], k) - find_cell(box.low[k], k) + 1);
            count += cells;
        }
        return count;
    }
};

// By the first index, then each of the short runs by the second.
void sort_pairs(std::vector<CapsulePair>& pairs, std::size_t capsules) {
    std::vector<std::size_t> starts(capsules + 1, 0);
    for (const CapsulePair& pair : pairs) ++starts[pair.first + 1];
    for (std::size_t i = 0; i < capsules; ++i) starts[i + 1] += starts[i];
    std::vector<CapsulePair> sorted(pairs.size());
    std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
    for (const CapsulePair& pair : pairs) sorted[next[pair.first]++] = pair;
    for (std::size_t i = 0; i < capsules; ++i)
        std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(starts[i]),
                  sorted.begin() + static_cast<std::ptrdiff_t>(starts[i + 1]));
    pairs = std::move(sorted);
}

template <class Keep>
std::vector<CapsulePair> find_pairs_of_boxes(std::span<const Capsule> capsules,
                                             double margin,
                                             const Keep& keep) {
    std::vector<CapsulePair> pairs;
    if (capsules.empty()) return pairs;
    const std::vector<CapsuleBox> boxes = make_boxes(capsules, margin);
    std::vector<CellEntry> entries = CellGrid(boxes).list_entries();
    std::sort(entries.begin(), entries.end(), [](const CellEntry& a, const CellEntry& b) {
        return a.cell != b.cell ? a.cell < b.cell : a.capsule < b.capsule;
    });
    for (std::size_t start = 0, end = 0; start < entries.size(); start = end) {
        while (end < entries.size() && entries[end].cell == entries[start].cell) ++end;
        for (std::size_t i = start; i < end; ++i)
            for (std::size_t j = i + 1; j < end; ++j) {
                if ((entries[i].is_lowest | entries[j].is_lowest) != lowest_in_all) continue;
                const CapsulePair pair{entries[i].capsule, entries[j].capsule};
                if (do_overlap(boxes[pair.first], boxes[pair.second]) && keep(pair)) pairs.push_back(pair);
            }
    }
    sort_pairs(pairs, capsules.size());
    return pairs;
}

}  // namespace

std::vector<CapsulePair> find_near_pairs(std::span<const Capsule> capsules,
                                         double margin,
                                         const std::function<bool(CapsulePair)>& keep) {
    return find_pairs_of_boxes(capsules, margin, keep);
}

std::vector<CapsulePair> find_near_pairs(std::span<const Capsule> capsules, double margin) {
    return find_pairs_of_boxes(capsules, margin, [](CapsulePair) { return true; });
}

}  // namespace gxrod
