#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assembly/tendons/tendon_line.hpp"
#include "loads/drive_values.hpp"
#include "model/model.hpp"
#include "state/state.hpp"

namespace gxrod {

// The tension along a tendon that rubs in its path, docs/theory/drives.md (D14) to (D18): given where it is
// pulled, and from there as near to that of the last accepted step as the turning of the tendon allows. The
// numbers of this class are those of the tendon's force points from where it is pulled outwards, and then
// that of its anchored end.
class CapstanTension {
  public:
    // In State::law_memory `behind` entries are behind its own. The model must outlive this.
    CapstanTension(const Model& model, const Tendon& tendon, std::size_t behind);

    const std::string& name() const { return name_; }
    const std::vector<int>& nodes() const { return line_.nodes(); }
    // How many numbers.
    std::size_t count() const { return start_stretches_.size() + 1; }
    // Throws EvaluationError where it is pulled by a tension below zero.
    std::vector<double> compute(const std::vector<NodeMotion>& motions,
                                const State& state,
                                double time) const;
    // Σ ∂ℓ_i ⊗ ∂T_i over the force points, by the (δr, δφ) of the nodes: what the change of the tensions adds
    // to the derivative of Σ T_i ∂ℓ_i.
    Eigen::MatrixXd compute_coupling(const std::vector<NodeMotion>& motions,
                                     const State& state,
                                     double time) const;
    // Of the last accepted step.
    std::span<const double> memory(const State& state) const {
        return std::span(state.law_memory).last(from_end_).first(count());
    }
    std::span<double> memory(State& state) const {
        return std::span(state.law_memory).last(from_end_).first(count());
    }
    // The numbers of force points, from the rod's start to its end.
    std::vector<double> along_rod(std::span<const double> tensions) const;

  private:
    struct Sweep;

    // Where it is pulled.
    double find_pull(double time) const;
    // From where it is pulled to where it is anchored, both of these included.
    std::vector<TendonTangent> list_tangents(const std::vector<NodeMotion>& motions,
                                             const State& state,
                                             bool with_gradients) const;
    Sweep sweep(const std::vector<NodeMotion>& motions,
                const State& state,
                double time,
                bool with_gradients) const;
    // What the tensions are where the tendon sticks.
    std::vector<double> find_sticking(const std::vector<TendonTangent>& tangents, const State& state) const;

    std::string name_;
    const Tendon* tendon_;
    TendonLine line_;
    std::vector<double> start_stretches_;  // of the force points
    std::size_t from_end_;                 // of State::law_memory, where its own begin
    double round_off_;                     // a force
};

// Of all tendons of a model with friction, in its order.
std::vector<CapstanTension> list_capstan_tensions(const Model& model);

// These, by the tendons of the model.
class CapstanTensions {
  public:
    // The model must outlive this.
    explicit CapstanTensions(const Model& model);

    bool empty() const { return entries_.empty(); }
    // Entries of State::law_memory, the last ones.
    std::size_t memory_count() const;
    // Into what acts within sections, whose tendons are all of the model's or those whose tension is given.
    void set_tensions(const std::vector<NodeMotion>& motions,
                      const State& state,
                      double time,
                      DriveValues& drives) const;
    // Those of the trial motions become those of the last accepted step.
    void commit(State& state, double time) const;
    // At its anchored end, of the trial motions; nullopt of a tendon without friction.
    std::optional<double> find_end_tension(std::size_t tendon, const State& state, double time) const;

  private:
    struct Entry {
        std::size_t tendon;  // in Model::tendons
        CapstanTension tension;
    };
    std::vector<Entry> entries_;
};

}  // namespace gxrod
