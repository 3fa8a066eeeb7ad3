#include "batch/cases/case_slices.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gxrod {
namespace {

bool is_any_between(const std::vector<CaseRange>& ranges, long first, long last) {
    return std::any_of(ranges.begin(), ranges.end(), [&](const CaseRange& range) {
        return range.first < last && range.last > first;
    });
}

}  // namespace

std::string write_range(const CaseRange& range) {
    return range.first == range.last ? fmt::format("{}", range.first)
                                     : fmt::format("{}..{}", range.first, range.last);
}

std::vector<CaseRange> join_numbers(const std::vector<long>& numbers) {
    std::vector<CaseRange> ranges;
    for (const long number : numbers) {
        if (!ranges.empty() && ranges.back().last + 1 == number) {
            ranges.back().last = number;
        } else {
            ranges.push_back({number, number});
        }
    }
    return ranges;
}

bool contain(const std::vector<CaseRange>& ranges, long number) {
    return std::any_of(
        ranges.begin(), ranges.end(), [&](const CaseRange& range) { return range.contains(number); });
}

std::vector<CaseRange> divide_cases(const std::vector<long>& cases,
                                    const std::vector<CaseRange>& taken,
                                    long slices) {
    std::vector<CaseRange> ranges;
    const long count = static_cast<long>(cases.size());
    const long wanted = std::clamp(slices, 1L, std::max(count, 1L));
    for (long slice = 0; slice < wanted; ++slice) {
        const long begin = slice * count / wanted;
        const long end = (slice + 1) * count / wanted;
        for (long i = begin; i < end; ++i) {
            const long number = cases[static_cast<std::size_t>(i)];
            const bool goes_on = i > begin && (ranges.back().last + 1 == number ||
                                               !is_any_between(taken, ranges.back().last, number));
            if (goes_on) {
                ranges.back().last = number;
            } else {
                ranges.push_back({number, number});
            }
        }
    }
    return ranges;
}

}  // namespace gxrod
