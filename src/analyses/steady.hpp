#pragma once

#include "analyses/stepped_analysis.hpp"
#include "assembly/lanes/frame_columns.hpp"

namespace gxrod {

// Equilibria in a frame that turns steadily, while the load factor t runs from 0 to 1. Supports turn with it.
class SteadyAnalysis : public SteppedAnalysis {
  public:
    // The model must outlive the analysis. Throws std::runtime_error if a load is not steady in the frame.
    SteadyAnalysis(const Model& model,
                   const StaticSettings& settings,
                   const TurningFrame& frame,
                   int threads = 1);

    EquilibriumReport start() override;

    // For matrices about its states.
    const FrameColumns& frame_columns() const { return columns_; }

  protected:
    // What the supports of a turning frame do is not among the work of the loads.
    bool looks_into_load_steps() const override { return false; }

  private:
    FrameColumns columns_;
};

}  // namespace gxrod
