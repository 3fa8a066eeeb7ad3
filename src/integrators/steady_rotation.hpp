#pragma once

#include "integrators/load_stepping.hpp"
#include "model/settings/turning_frame.hpp"

namespace gxrod {

// Equilibria in a frame that turns steadily: like LoadStepping, but every node moves with the frame. It
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

}  // namespace gxrod
