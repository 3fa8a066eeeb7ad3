#include "assembly/equation_numbers.hpp"

#include <algorithm>

namespace gxrod {

EquationNumbers::EquationNumbers(const Supports& supports, std::span<const AttachedUnknowns> attached)
    : supports_(&supports), attached_(attached.begin(), attached.end()), attached_firsts_(attached.size()) {
    const int nodes = static_cast<int>(supports.node_count());
    std::vector<std::vector<std::size_t>> behind(attached.empty() ? 0 : supports.node_count());
    for (std::size_t i = 0; i < attached.size(); ++i) behind[attached[i].node].push_back(i);
    firsts_.reserve(supports.node_count() + 1);
    firsts_.push_back(0);
    for (int node = 0; node < nodes; ++node) {
        std::int64_t next = firsts_.back() + free_count(node);
        if (!behind.empty()) {
            for (const std::size_t i : behind[node]) {
                attached_firsts_[i] = next;
                next += attached[i].count;
                attached_count_ += attached[i].count;
            }
        }
        firsts_.push_back(next);
    }
}

std::int64_t EquationNumbers::free_count(int node) const {
    const HeldComponents& held = supports_->held(node);
    return std::count(held.begin(), held.end(), false);
}

EquationNumbers::Unknown EquationNumbers::unknown(std::int64_t equation) const {
    const auto after = std::upper_bound(firsts_.begin(), firsts_.end(), equation);
    const int node = static_cast<int>(after - firsts_.begin()) - 1;
    const std::array<std::int64_t, 6> numbers = of_node(node);
    const auto found = std::find(numbers.begin(), numbers.end(), equation);
    if (found != numbers.end()) return {node, static_cast<int>(found - numbers.begin())};
    std::size_t index = 0;
    while (equation < attached_firsts_[index] || equation >= attached_firsts_[index] + attached_[index].count)
        ++index;
    return {node, -1, static_cast<int>(index), static_cast<int>(equation - attached_firsts_[index])};
}

Vec6 EquationNumbers::to_own_axes(int node, const Vec6& global) const {
    if (!supports_->has_own_axes(node)) return global;
    const Mat3& Q = supports_->axes(node);
    Vec6 own;
    own << Q.transpose() * global.head<3>(), Q.transpose() * global.tail<3>();
    return own;
}

Vec6 EquationNumbers::to_global_axes(int node, const Vec6& own) const {
    if (!supports_->has_own_axes(node)) return own;
    const Mat3& Q = supports_->axes(node);
    Vec6 global;
    global << Q * own.head<3>(), Q * own.tail<3>();
    return global;
}

Vec6 EquationNumbers::increment_of(int node, const Eigen::VectorXd& solution) const {
    const std::array<std::int64_t, 6> numbers = of_node(node);
    Vec6 own;
    for (int i = 0; i < 6; ++i) own[i] = numbers[i] < 0 ? 0.0 : solution[numbers[i]];
    return to_global_axes(node, own);
}

void EquationNumbers::hold_rates(int node, NodeMotion& motion) const {
    Vec6 rates;
    rates << motion.v, motion.omega;
    rates = to_own_axes(node, rates);
    for (int k = 0; k < 6; ++k) {
        if (of_node(node)[k] < 0) rates[k] = 0.0;
    }
    rates = to_global_axes(node, rates);
    motion.v = rates.head<3>();
    motion.omega = rates.tail<3>();
}

}  // namespace gxrod
