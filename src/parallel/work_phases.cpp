#include "parallel/work_phases.hpp"

#include <bit>

namespace gxrod {

std::uint64_t WorkPhases::add(std::size_t part, std::uint64_t taken) {
    const auto phase = static_cast<std::size_t>(std::countr_one(taken));
    if (phase == most_phases) {
        alone_.push_back(part);
        return 0;
    }
    if (phase == phases_.size()) phases_.emplace_back();
    phases_[phase].push_back(part);
    return std::uint64_t{1} << phase;
}

}  // namespace gxrod
