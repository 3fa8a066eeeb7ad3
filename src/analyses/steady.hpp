#pragma once

#include "analyses/stepped_analysis.hpp"
#include "assembly/lanes/frame_columns.hpp"

namespace gxrod {

// Finds equilibria in steady rotation, while the load factor t runs from 0 to 1: in a frame that turns, with
// which supports turn, or of parts that spin about their own axes in a frame at rest.
class SteadyAnalysis : public SteppedAnalysis {
  public:
    // The model must outlive the analysis. Throws std::runtime_error if a load is not steady in the frame.
    SteadyAnalysis(const Model& model,
                   const StaticSettings& settings,
                   const TurningFrame& frame,
                   int threads = 1);

    EquilibriumReport start() override;

    // The columns for matrices about its states.
    const FrameColumns& frame_columns() const { return columns_; }

  protected:
    // False: the work of the loads does not include the supports of a turning frame.
    bool looks_into_load_steps() const override { return false; }

  private:
    FrameColumns columns_;
};

}  // namespace gxrod
