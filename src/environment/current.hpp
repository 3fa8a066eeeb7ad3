#pragma once

#include <optional>
#include <string>

#include "environment/flow_at.hpp"
#include "environment/stretching.hpp"
#include "model/surroundings.hpp"

namespace gxrod {

// The flow of a fluid without waves at a time: a profile times its factor, plus a velocity field.
class Current {
  public:
    // `length` is the model's length, `fluid` the name in messages. The flow must outlive this.
    Current(const Flow& flow, double length, std::string fluid);

    // Throws EvaluationError if a function has no finite value.
    void move_to(double time);
    bool is_still() const { return flow_->is_still(); }
    // Whether several threads may ask for places at once.
    bool is_shareable() const { return !flow_->field; }

    // Returns the flow; `height` is the height for the profile. Rates are central differences of the
    // functions by time, gradients of the field central differences by place. The gradient of the field's
    // rate is left out, and without `gradients` the gradient of its velocity too.
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
