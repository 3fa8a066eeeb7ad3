#include "solvers/coupled/stages.hpp"

#include <Eigen/LU>

namespace gxrod {

// Accelerations follow placements by B²/Δt²: Σ_k (B²)_jk p_k is the row of stage j.
std::vector<std::vector<double>> StagesOfStep::convert_rows(const std::vector<Residual>& residuals) const {
    std::vector<std::vector<double>> rows;
    for (const Residual& residual : residuals) rows.push_back(residual.rows);
    if (asks_for_positions) return rows;
    const Eigen::MatrixXd A2 = (scheme.inverse() * scheme.inverse()).inverse();
    for (std::size_t j = 0; j < count(); ++j) {
        for (std::size_t row = 0; row < rows[j].size(); ++row) {
            rows[j][row] = 0.0;
            for (std::size_t k = 0; k < count(); ++k)
                rows[j][row] +=
                    A2(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) * residuals[k].rows[row];
        }
    }
    return rows;
}

}  // namespace gxrod
