#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "assembly/constraint_request.hpp"
#include "assembly/contribution.hpp"
#include "assembly/equation_numbers.hpp"
#include "assembly/residual.hpp"
#include "assembly/scale_groups.hpp"
#include "assembly/scatter.hpp"
#include "loads/load_values.hpp"
#include "model/model.hpp"
#include "state/motion.hpp"
#include "state/state.hpp"
#include "state/values/point_values.hpp"

namespace gxrod {

// Loads on nodes and along rods. It caches them at the last requested time, which does not change results.
class LoadAssembly : public Contribution {
  public:
    // The model must outlive it.
    explicit LoadAssembly(const Model& model);

    void lay_out(const Layout& layout) override;
    void subtract_forces(const State& state,
                         double time,
                         const ConstraintRequest& request,
                         Residual& residual) const override;
    void add_tangents(const State& state,
                      double time,
                      const ConstraintRequest& request,
                      const std::vector<NodeLinearization>& linearizations,
                      std::vector<double>& values) const override;
    void forget() const override { values_.forget(); }
    void subtract_element_forces(const State& state,
                                 double time,
                                 const RodPlace& place,
                                 Eigen::Ref<Eigen::VectorXd> forces) const override;

  private:
    const Model* model_;
    const EquationNumbers* equations_ = nullptr;
    const ScaleGroups* groups_ = nullptr;
    double length_ = 1.0;
    mutable LoadValues values_;
    std::vector<ElementPlaces<1>> places_;  // places of each load's node
    std::vector<std::vector<std::int64_t>> element_slots_;
};

}  // namespace gxrod
