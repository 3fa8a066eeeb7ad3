#include "linear/coupled/near_inverse.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>

#include "linear/chains/block_partition.hpp"

namespace gxrod {

namespace {

// The blocks of a connected part in levels from `start`; those of `level_of` that are −1 are not yet visited.
std::vector<std::vector<int>> find_levels_from(int start,
                                               const BlockPartition& partition,
                                               std::vector<int>& level_of) {
    std::vector<std::vector<int>> levels{{start}};
    level_of[static_cast<std::size_t>(start)] = 0;
    while (true) {
        std::vector<int> next;
        for (const int block : levels.back()) {
            const auto own = static_cast<std::size_t>(block);
            for (std::size_t i = partition.neighbour_starts[own]; i < partition.neighbour_starts[own + 1];
                 ++i) {
                const int other = partition.neighbours[i];
                if (level_of[static_cast<std::size_t>(other)] >= 0) continue;
                level_of[static_cast<std::size_t>(other)] = static_cast<int>(levels.size());
                next.push_back(other);
            }
        }
        if (next.empty()) return levels;
        levels.push_back(std::move(next));
    }
}

}  // namespace

NearInverse::NearInverse(const SparsePattern& pattern) {
    find_levels(pattern);
    sort_entries(pattern);
}

void NearInverse::find_levels(const SparsePattern& pattern) {
    const BlockPartition partition(pattern);
    places_.resize(static_cast<std::size_t>(pattern.size()));
    std::vector<int> level_of(static_cast<std::size_t>(partition.count()), -1);
    for (int block = 0; block < partition.count(); ++block) {
        if (level_of[static_cast<std::size_t>(block)] >= 0) continue;
        // From the far end of the part, so that levels are narrow.
        const std::vector<std::vector<int>> first = find_levels_from(block, partition, level_of);
        for (const std::vector<int>& level : first)
            for (const int one : level) level_of[static_cast<std::size_t>(one)] = -1;
        const std::vector<std::vector<int>> levels =
            find_levels_from(first.back().front(), partition, level_of);
        parts_.push_back(levels_.size());
        for (const std::vector<int>& blocks : levels) {
            Level level;
            for (const int one : blocks) {
                const auto own = static_cast<std::size_t>(one);
                for (std::int64_t i = partition.starts[own]; i < partition.starts[own + 1]; ++i)
                    places_[static_cast<std::size_t>(i)] = {static_cast<std::int32_t>(levels_.size()),
                                                            static_cast<std::int32_t>(level.size++)};
            }
            widest_ = std::max(widest_, level.size);
            levels_.push_back(std::move(level));
        }
        levels_.back().is_last = true;
    }
    parts_.push_back(levels_.size());
}

void NearInverse::sort_entries(const SparsePattern& pattern) {
    pattern.visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
        const Place r = places_[static_cast<std::size_t>(row)];
        const Place c = places_[static_cast<std::size_t>(column)];
        Level& level = levels_[static_cast<std::size_t>(std::min(r.level, c.level))];
        const auto in_level = [&](const Place& place, const Place& other) {
            return place.level > other.level ? place.index + static_cast<std::int32_t>(level.size)
                                             : place.index;
        };
        level.entries.push_back({slot, in_level(r, c), in_level(c, r)});
    });
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        Level& level = levels_[i];
        const std::int64_t next = level.is_last ? 0 : levels_[i + 1].size;
        level.own.setZero(level.size, level.size);
        level.to_next.setZero(level.size, next);
        level.from_next.setZero(next, level.size);
    }
}

void NearInverse::factorize(const std::vector<double>& values, const ThreadTeam& team) {
    team.for_each(parts_.size() - 1,
                  [&](std::size_t part) { factorize_part(values, parts_[part], parts_[part + 1]); });
}

void NearInverse::factorize_part(const std::vector<double>& values, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
        Level& level = levels_[i];
        for (const Entry& entry : level.entries) {
            const double value = values[static_cast<std::size_t>(entry.slot)];
            if (entry.row >= level.size) {
                level.from_next(entry.row - level.size, entry.column) = value;
            } else if (entry.column >= level.size) {
                level.to_next(entry.row, entry.column - level.size) = value;
            } else {
                level.own(entry.row, entry.column) = value;
            }
        }
    }
    levels_[first].before = levels_[first].own;
    for (std::size_t i = first + 1; i < end; ++i) {
        const Level& last = levels_[i - 1];
        levels_[i].before = levels_[i].own;
        levels_[i].before.noalias() -= last.from_next * last.before.partialPivLu().solve(last.to_next);
    }
    levels_[end - 1].behind = levels_[end - 1].own;
    for (std::size_t i = end - 1; i > first; --i) {
        Level& level = levels_[i - 1];
        level.behind = level.own;
        level.behind.noalias() -= level.to_next * levels_[i].behind.partialPivLu().solve(level.from_next);
    }
}

// Of levels that follow each other: columns of the inverse.
Eigen::MatrixXd NearInverse::invert_levels(std::size_t first,
                                           std::size_t last,
                                           std::span<const std::int64_t> columns) const {
    std::int64_t size = 0;
    for (std::size_t i = first; i <= last; ++i) size += levels_[i].size;
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size, size);
    std::int64_t at = 0;
    for (std::size_t i = first; i <= last; ++i) {
        const Level& level = levels_[i];
        auto own = all.block(at, at, level.size, level.size);
        own = level.own;
        if (i == first) own += level.before - level.own;
        if (i == last) own += level.behind - level.own;
        if (i < last) {
            const std::int64_t next = levels_[i + 1].size;
            all.block(at, at + level.size, level.size, next) = level.to_next;
            all.block(at + level.size, at, next, level.size) = level.from_next;
        }
        at += level.size;
    }
    Eigen::MatrixXd units = Eigen::MatrixXd::Zero(size, static_cast<Eigen::Index>(columns.size()));
    for (std::size_t i = 0; i < columns.size(); ++i) units(columns[i], static_cast<Eigen::Index>(i)) = 1.0;
    return all.partialPivLu().solve(units);
}

Eigen::MatrixXd NearInverse::invert(std::span<const std::int64_t> unknowns) const {
    const auto count = static_cast<Eigen::Index>(unknowns.size());
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(count, count);
    const auto place_of = [&](Eigen::Index i) {
        return places_[static_cast<std::size_t>(unknowns[static_cast<std::size_t>(i)])];
    };
    std::vector<Eigen::Index> sorted(unknowns.size());
    std::iota(sorted.begin(), sorted.end(), Eigen::Index{0});
    std::ranges::stable_sort(sorted, {}, [&](Eigen::Index i) { return place_of(i).level; });
    for (auto group = sorted.begin(); group != sorted.end();) {
        const auto first = static_cast<std::size_t>(place_of(*group).level);
        std::size_t last = first;
        std::vector<std::int64_t> columns;
        std::int64_t before = 0;  // unknowns of levels before `last`
        auto end = group;
        for (; end != sorted.end(); ++end) {
            const auto level = static_cast<std::size_t>(place_of(*end).level);
            if (level > last && (level > last + 1 || levels_[last].is_last)) break;
            if (level > last) before += levels_[last++].size;
            columns.push_back(before + place_of(*end).index);
        }
        const Eigen::MatrixXd found = invert_levels(first, last, columns);
        for (std::size_t c = 0; c < columns.size(); ++c)
            for (std::size_t r = 0; r < columns.size(); ++r)
                inverse(group[static_cast<std::ptrdiff_t>(r)], group[static_cast<std::ptrdiff_t>(c)]) =
                    found(columns[r], static_cast<Eigen::Index>(c));
        group = end;
    }
    return inverse;
}

}  // namespace gxrod
