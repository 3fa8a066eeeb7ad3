#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assembly/tendons/tendon_line.hpp"
#include "loads/drive_values.hpp"
#include "model/model.hpp"
#include "state/memory_slice.hpp"
#include "state/state.hpp"

namespace gxrod {

// The tension along a tendon with friction in its duct, docs/theory/drives.md (D14) to (D18): given where it
// is pulled, and from there as near to the tension of the last accepted step as friction at the tendon's
// turns allows. The values of this class belong to the tendon's force points from the pulled end outwards,
// and then to its anchored end.
class CapstanTension {
  public:
    // Its memory begins at `first`. The model must outlive this.
    CapstanTension(const Model& model, const Tendon& tendon, std::size_t first);

    const std::string& name() const { return name_; }
    const std::vector<int>& nodes() const { return line_.nodes(); }
    // The number of values.
    std::size_t count() const { return start_stretches_.size() + 1; }
    // Throws EvaluationError if the tendon is pulled by a tension below zero.
    std::vector<double> compute(const std::vector<NodeMotion>& motions,
                                const State& state,
                                double time) const;
    // Computes Σ ∂ℓ_i ⊗ ∂T_i over the force points, by the (δr, δφ) of the nodes: the contribution of
    // changing tensions to the derivative of Σ T_i ∂ℓ_i.
    Eigen::MatrixXd compute_coupling(const std::vector<NodeMotion>& motions,
                                     const State& state,
                                     double time) const;
    // The values of the last accepted step.
    MemorySlice memory() const { return {first_memory_, count()}; }
    // Returns the values of force points, from the rod's start to its end.
    std::vector<double> along_rod(std::span<const double> tensions) const;

  private:
    struct Sweep;

    // Finds the tension at the pulled end.
    double find_pull(double time) const;
    // Lists tangents from the pulled to the anchored end, both included.
    std::vector<TendonTangent> list_tangents(const std::vector<NodeMotion>& motions,
                                             const State& state,
                                             bool with_gradients) const;
    Sweep sweep(const std::vector<NodeMotion>& motions,
                const State& state,
                double time,
                bool with_gradients) const;
    // Finds the tensions with which the tendon would stick.
    std::vector<double> find_sticking(const std::vector<TendonTangent>& tangents, const State& state) const;

    std::string name_;
    const Tendon* tendon_;
    TendonLine line_;
    std::vector<double> start_stretches_;  // for the force points
    std::size_t first_memory_;
    double round_off_;  // a force
};

// Lists the tensions of all tendons of a model with friction, in its order.
std::vector<CapstanTension> list_capstan_tensions(const Model& model);

// The tensions with friction by the tendons of the model.
class CapstanTensions {
  public:
    // The model must outlive this.
    explicit CapstanTensions(const Model& model);

    bool empty() const { return entries_.empty(); }
    // The size of their memory, the first of all.
    std::size_t memory_count() const;
    // Sets the tensions in the drives within sections; its tendons are all of the model's or those with given
    // tension.
    void set_tensions(const std::vector<NodeMotion>& motions,
                      const State& state,
                      double time,
                      DriveValues& drives) const;
    // Makes the tensions of the trial motions those of the last accepted step.
    void commit(State& state, double time) const;
    // Finds the tension at the anchored end at the trial motions; nullopt for a tendon without friction.
    std::optional<double> find_end_tension(std::size_t tendon, const State& state, double time) const;

  private:
    struct Entry {
        std::size_t tendon;  // index in Model::tendons
        CapstanTension tension;
    };
    std::vector<Entry> entries_;
};

}  // namespace gxrod
