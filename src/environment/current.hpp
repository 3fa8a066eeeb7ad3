#pragma once

#include <optional>
#include <string>

#include "environment/flow_at.hpp"
#include "environment/stretching.hpp"
#include "model/surroundings.hpp"

namespace gxrod {

// How a fluid flows without waves, at a time: a profile times its factor, and a velocity field.
class Current {
  public:
    // `length`: of the model. `fluid`: its name in messages. The flow must outlive this.
    Current(const Flow& flow, double length, std::string fluid);

    // Throws EvaluationError, of a function without a finite value.
    void move_to(double time);
    bool is_still() const { return flow_->is_still(); }
    // Whether places can be asked for by several threads at once.
    bool is_shareable() const { return !flow_->field; }

    // `height` is that at which the profile is asked. Rates are central differences of the functions by the
    // time, as are gradients of the field by the place; the gradient of its rate is left out, and without
    // `gradients` that of its velocity too.
    FlowAt at(const Vec3& place, const FormulaHeight& height, bool gradients) const;

  private:
    FlowAt find_profile(const FormulaHeight& height) const;
    FlowAt find_field(const Vec3& place, bool gradients) const;
    Vec3 evaluate_field(double time, const Vec3& place) const;

    const Flow* flow_;
    double step_;
    std::string fluid_;
    double time_ = 0.0;
    double factor_ = 1.0, factor_rate_ = 0.0;
};

}  // namespace gxrod
