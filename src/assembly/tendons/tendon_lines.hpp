#pragma once

#include <span>
#include <vector>

#include "assembly/joints/joint_assembly.hpp"
#include "assembly/tendons/capstan_tension.hpp"
#include "assembly/tendons/tendon_line.hpp"
#include "loads/drive_values.hpp"
#include "model/model.hpp"
#include "state/values/tendon_values.hpp"

namespace gxrod {

// Recorded values of a model's tendons, for any kind of pull.
class TendonLines {
  public:
    // The model must outlive this.
    explicit TendonLines(const Model& model);

    // Computes values at the trial motions and multipliers, in the order of the model.
    std::vector<TendonValues> compute_values(const State& state,
                                             const JointAssembly& joints,
                                             double time) const;
    // Whether winches pull any tendons.
    bool have_winches() const { return have_winches_; }
    // The tensions of tendons with friction.
    const CapstanTensions& capstans() const { return capstans_; }
    // Returns the drives within sections, tendons with winches included.
    const DriveValues& drives_at(const State& state, const JointAssembly& joints, double time) const;

  private:
    std::vector<double> find_tensions(const std::vector<JointValues>& joints, double time) const;

    const Model* model_;
    bool have_winches_;
    std::vector<TendonLine> lines_;
    CapstanTensions capstans_;
    mutable DriveValues drives_;
};

}  // namespace gxrod
