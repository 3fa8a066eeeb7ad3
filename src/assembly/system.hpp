#pragma once

#include <Eigen/Core>
#include <vector>

#include "assembly/element_block.hpp"
#include "assembly/equation_numbers.hpp"
#include "assembly/sparse_pattern.hpp"
#include "model/model.hpp"
#include "state/section_values.hpp"
#include "state/state.hpp"

namespace gxrod {

// What is out of balance at every node: internal + inertial − external.
struct Residual {
    std::vector<Vec6> nodal;  // supported components hold the force that the support exerts
    // The largest force and moment that one element or load puts on a node, and of bodies the part due to
    // accelerations; a residual is small against these.
    double force_scale = 0.0;
    double moment_scale = 0.0;
};

// Sums over the model, all of the trial motions.
struct Balance {
    double kinetic_energy = 0.0;
    double strain_energy = 0.0;
    double gravity_potential = 0.0;
    Momentum momentum;
};

// The model as one system of equations: what the parts become together. Holds no state.
class System {
  public:
    // The model must outlive the system.
    explicit System(const Model& model);

    const Model& model() const { return *model_; }
    const EquationNumbers& equations() const { return equations_; }
    const SparsePattern& pattern() const { return pattern_; }
    // The model's length for scaling: the largest of its extent and the bodies' own sizes; 1 if both are
    // zero.
    double length_scale() const { return length_scale_; }
    std::size_t element_count() const;

    // The reference shape with the model's initial velocities, zero where a support holds; accelerations
    // zero.
    State initial_state() const;

    // Of the trial motions, with loads at `time`.
    void compute_residual(const State& state, double time, Residual& residual) const;
    // The derivative of the residual by the linearizations, as values on the pattern.
    void compute_tangent(const State& state,
                         double time,
                         const std::vector<NodeLinearization>& linearizations,
                         std::vector<double>& values) const;

    // Makes the trial motions the last accepted step, at `time`.
    void commit(State& state, double time) const;

    Balance compute_balance(const State& state) const;
    // Σ f · v + m · ω of the loads, gravity aside.
    double compute_load_power(const std::vector<NodeMotion>& motions, double time) const;
    // The mean load of the step times displacement and rotation from `previous` to `trial`, gravity aside.
    double compute_load_work(const State& state, double time) const;
    // Of all rod elements, rods in the order of the model, from start to end; of the trial motions.
    std::vector<SectionValues> compute_section_values(const State& state) const;

  private:
    void build_blocks();
    void build_pattern();
    void measure();

    const Model* model_;
    ElementBlocks blocks_;
    EquationNumbers equations_;
    SparsePattern pattern_;
    std::vector<ElementSlots<1>> load_slots_;  // of each load's node
    double length_scale_ = 1.0;
    std::size_t history_count_ = 0;
    int rod_element_count_ = 0;
};

}  // namespace gxrod
