#pragma once

#include "integrators/load_stepping.hpp"
#include "model/settings/turning_frame.hpp"

namespace gxrod {

// Equilibria in steady rotation: like LoadStepping, but every node moves with the frame, or spins in it. It
// linearizes placements only; FrameColumns adds the terms of the rates.
class SteadyRotation : public LoadStepping {
  public:
    explicit SteadyRotation(TurningFrame frame) : frame_(std::move(frame)) {}

  protected:
    void place_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void update_nodes(State& state, const Stage& stage, NodeRange nodes) const override;

  private:
    TurningFrame frame_;
};

// Sets v = Ω × (r − o), a = Ω × v, ω = Ω, α = 0.
void turn_with(const Vec3& spin, const Vec3& through, NodeMotion& motion);
// Sets the rates of a node of a frame that turns, or of one that spins in a frame at rest: v = a = α = 0, and
// ω is Ω along the axis that the node carries.
void set_steady_rates(const TurningFrame& frame, double load_factor, std::size_t node, NodeMotion& motion);

}  // namespace gxrod
