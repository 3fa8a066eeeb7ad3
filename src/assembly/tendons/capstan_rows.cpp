#include "assembly/tendons/capstan_rows.hpp"

namespace gxrod {

Eigen::MatrixXd CapstanRows::compute_law_tangent(const WidePlace& place,
                                                 const std::vector<NodeLinearization>& linearizations) const {
    const double placement = linearizations.front().placement;
    if (placement == 0.0) return Eigen::MatrixXd::Zero(size(), size());
    return -placement * tension_.compute_coupling(place.nodes, place.state, place.time);
}

std::vector<std::unique_ptr<const WideRows>> list_capstan_rows(const Model& model) {
    std::vector<std::unique_ptr<const WideRows>> rows;
    for (CapstanTension& tension : list_capstan_tensions(model))
        rows.push_back(std::make_unique<CapstanRows>(std::move(tension)));
    return rows;
}

}  // namespace gxrod
