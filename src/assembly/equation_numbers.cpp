#include "assembly/equation_numbers.hpp"

#include <algorithm>

namespace gxrod {

EquationNumbers::EquationNumbers(const Supports& supports)
    : supports_(&supports), equations_(supports.node_count()) {
    for (int node = 0; node < static_cast<int>(equations_.size()); ++node) {
        for (int component = 0; component < 6; ++component) {
            if (supports.held(node)[component]) {
                equations_[node][component] = -1;
            } else {
                equations_[node][component] = count();
                unknowns_.push_back({node, component});
            }
        }
    }
}

bool EquationNumbers::is_free(int node) const {
    const auto& numbers = equations_[node];
    return !supports_->has_own_axes(node) &&
           std::all_of(numbers.begin(), numbers.end(), [](std::int64_t number) { return number >= 0; });
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
    Vec6 own;
    for (int i = 0; i < 6; ++i) own[i] = equations_[node][i] < 0 ? 0.0 : solution[equations_[node][i]];
    return to_global_axes(node, own);
}

}  // namespace gxrod
