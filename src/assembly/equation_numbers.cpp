#include "assembly/equation_numbers.hpp"

namespace gxrod {

EquationNumbers::EquationNumbers(const std::vector<FixedComponents>& fixed) : equations_(fixed.size()) {
    for (int node = 0; node < static_cast<int>(fixed.size()); ++node) {
        for (int component = 0; component < 6; ++component) {
            if (fixed[node][component]) {
                equations_[node][component] = -1;
            } else {
                equations_[node][component] = count();
                unknowns_.push_back({node, component});
            }
        }
    }
}

}  // namespace gxrod
