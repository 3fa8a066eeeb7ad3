#pragma once

#include <cstddef>
#include <vector>

#include "constraints/joints/joint_rows.hpp"
#include "model/model.hpp"
#include "state/state.hpp"

namespace gxrod {

// The one-sided equations of a model's joints: ropes and stops. Those hold whose multipliers are not 0.
class HeldStops {
  public:
    // The model must outlive it.
    explicit HeldStops(const Model& model);

    bool empty() const { return places_.empty(); }
    // Whether the same ones hold.
    bool are_equal(const std::vector<JointState>& a, const std::vector<JointState>& b) const;
    // Lets those hold in `to` that hold in `from`, by their multipliers.
    void copy(const std::vector<JointState>& from, std::vector<JointState>& to) const;
    // Whether one is closed at the trial motions and does not hold: it is at its limit without a force.
    bool are_at_limit(const State& state, double length) const;

  private:
    struct Place {
        std::size_t joint, row;
        JointRows rows;
    };

    const Model* model_;
    std::vector<Place> places_;
};

}  // namespace gxrod
