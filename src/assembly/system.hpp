#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "assembly/element_block.hpp"
#include "assembly/equation_numbers.hpp"
#include "assembly/joints/joint_assembly.hpp"
#include "assembly/lanes/rod_batches.hpp"
#include "assembly/lanes/rotary_batches.hpp"
#include "assembly/node_groups.hpp"
#include "assembly/residual.hpp"
#include "assembly/scale_groups.hpp"
#include "assembly/tendons/tendon_lines.hpp"
#include "constraints/supports.hpp"
#include "linear/sparse_pattern.hpp"
#include "loads/load_values.hpp"
#include "model/model.hpp"
#include "state/state.hpp"
#include "state/values/point_values.hpp"
#include "state/values/section_values.hpp"
#include "state/values/tendon_values.hpp"

namespace gxrod {

class ContactAssembly;
class SurroundingsAssembly;

// Sums over the model, all of the trial motions.
struct Balance {
    double kinetic_energy = 0.0;
    double strain_energy = 0.0;
    double gravity_potential = 0.0;  // 0 where gravity changes with time
    Momentum momentum;

    Balance& operator+=(const Balance& other);
};

// The sum of forces, and of their moments about the origin.
struct Resultant {
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
};

// How far nodes of one element are turned against each other, at most, and a node of that element.
struct RelativeRotation {
    double angle = 0.0;
    int node = -1;
};

// The model as one system of equations: what the parts become together. Holds no state; of the loads it
// remembers what they are at the time last asked for, which changes no result.
class System {
  public:
    // The model must outlive the system, and so must the threads that share its work; their number
    // changes no result.
    explicit System(const Model& model, const ThreadTeam& team = ThreadTeam::alone());
    System(const Model& model, const Kernels& kernels, const ThreadTeam& team = ThreadTeam::alone());
    ~System();
    System(const System&) = delete;  // its parts point at each other
    System& operator=(const System&) = delete;

    const Model& model() const { return *model_; }
    const ThreadTeam& team() const { return *team_; }
    const Supports& supports() const { return supports_; }
    const JointAssembly& joints() const { return joints_; }
    // nullptr where nothing can touch.
    const ContactAssembly* contact() const { return contact_.get(); }
    // nullptr where neither fluid nor ground is.
    const SurroundingsAssembly* surroundings() const { return surroundings_.get(); }
    const EquationNumbers& equations() const { return equations_; }
    const SparsePattern& pattern() const { return pattern_; }
    // The groups of nodes that elements and joints couple; the pattern follows from them.
    std::vector<NodeGroup> list_node_groups() const;
    // The model's length for scaling: the largest of its extent and the bodies' own sizes; 1 if both are
    // zero.
    double length_scale() const { return length_scale_; }
    // The same of the part of the model to which a node belongs.
    double length_scale_at(int node) const { return scale_groups_.length_at(node); }
    const ScaleGroups& scale_groups() const { return scale_groups_; }
    std::size_t element_count() const;
    // Whether any element interpolates rotations of the step, so that these must stay below π.
    bool uses_step_rotations() const { return history_count_ > 0; }
    bool is_damped() const { return is_damped_ || joints_.is_damped(); }
    // Whether resultants of any section are not its stiffness × its strains.
    bool has_laws() const { return has_laws_; }

    // The reference shape with the model's initial velocities, zero where a support fixes; accelerations
    // zero.
    State initial_state() const;
    // Makes the velocities of a node zero where a support holds it.
    void hold_rates(int node, NodeMotion& motion) const;

    // Of the trial motions and multipliers, with loads at `time`.
    void compute_residual(const State& state,
                          double time,
                          Residual& residual,
                          const ConstraintRequest& request = {}) const;
    // The derivative of the residual by the linearizations, as values on the pattern; the mixed tangent
    // instead if the state holds resultants.
    void compute_tangent(const State& state,
                         double time,
                         const std::vector<NodeLinearization>& linearizations,
                         std::vector<double>& values,
                         const ConstraintRequest& request = {}) const;

    // Sets the state's resultants, of the mixed tangent, to those of the strains of the last accepted
    // motions, or to what those of the trial motions become by increments (δr, δφ) of the nodes, to first
    // order.
    void start_resultants(State& state) const;
    void advance_resultants(const std::vector<Vec6>& increments, State& state) const;

    // Makes the trial motions the last accepted step, at `time`.
    void commit(State& state, double time) const;

    // The functions of loads rest on a number that has changed, in addition to the time.
    void forget_loads() const {
        load_values_.forget();
        drive_values_.forget();
        forget_surroundings();
    }

    // With gravity at `time`.
    Balance compute_balance(const State& state, double time) const;
    // Forces and moments per node that do work, of the trial motions: loads, and gravity where it changes
    // with time; and what moving supports exert, added to `forces`. `residual` is that of the trial.
    std::vector<Vec6> compute_load_forces(const State& state, double time) const;
    // The part of these that water, air and the ground exert; empty where nothing is around.
    std::vector<Vec6> compute_surrounding_forces(const State& state, double time) const;
    void add_support_forces(const Residual& residual, std::vector<Vec6>& forces) const;
    // The power of damping at the trial's rates; and the sum of the elements' damping_action in the step from
    // the previous motions to the trial ones. Neither is negative.
    double compute_damping_power(const State& state) const;
    double compute_damping_action(const State& state) const;
    // Whether tendons or strains of their own act within any rod.
    bool is_driven() const { return !drive_values_.empty(); }
    // The work of these from the last accepted step to the trial, at `time`: of the mean of both ends.
    double compute_drive_work(const State& state, double time) const;
    // What sections dissipate by their laws from the last accepted step to the trial, at `time`.
    double compute_law_dissipation(const State& state, double time) const;
    // Of these motions, which need only rotations and rates.
    double compute_kinetic_energy(const std::vector<NodeMotion>& motions) const;
    Momentum compute_momentum(const std::vector<NodeMotion>& motions) const;
    // The residual of held components, those that supports exert; global axes.
    std::vector<Vec6> compute_reactions(const Residual& residual) const;
    // Of all that acts from outside: loads, gravity, damping and what supports exert; of the trial motions.
    // It is the rate of the momenta.
    Resultant compute_outer_resultant(const State& state, double time, std::span<const Vec6> reactions) const;
    // Of all rod elements, rods in the order of the model, from start to end; of the trial motions.
    std::vector<SectionValues> compute_section_values(const State& state) const;
    // Of all tendons, in the order of the model; of the trial motions and multipliers.
    std::vector<TendonValues> compute_tendon_values(const State& state, double time) const;
    // For each rod ∫ δE (C δE) ds, component by component (Γx Γy Γz Kx Ky Kz), of the strains δE that
    // increments (δr, δφ) of the nodes add to those of the trial motions, to first order.
    std::vector<Vec6> compute_strain_work(const State& state, const std::vector<Vec6>& increments) const;
    // Of points of rods, of the trial motions; section forces are those of an equilibrium at `time`.
    std::vector<PointValues> compute_point_values(const State& state,
                                                  double time,
                                                  const std::vector<RodPlace>& places) const;
    // Of Model::bodies, of the trial motions; empty where nothing is around.
    std::vector<PointSurroundings> compute_body_surroundings(const State& state, double time) const;
    // Of elements that interpolate relative rotations: the largest one in `motions`, plus what `spins` of the
    // nodes can add to it at most (exp does not lengthen distances). Below π no relative rotation is mistaken
    // for its complement.
    RelativeRotation bound_relative_rotation(const std::vector<NodeMotion>& motions,
                                             const std::vector<Vec3>& spins) const;

  private:
    void build_blocks();
    std::vector<DrivenPoint> list_driven_points(const std::vector<NodeMotion>& motions,
                                                const State& state,
                                                double time) const;
    template <class E>
    void lay_out_memory(ElementBlock<E>& block);
    Instant instant(const State& state, double time, const std::vector<NodeMotion>& motions) const;
    Instant instant(const State& state, double time) const { return instant(state, time, state.trial); }
    Instant instant(const State& state) const { return instant(state, state.trial_time); }
    void build_pattern();
    void find_cleared();
    void build_batches();
    void measure();
    // To those of the strains of these motions after the increments, to first order.
    void set_resultants(const std::vector<NodeMotion>& motions,
                        double time,
                        const std::vector<Vec6>& increments,
                        State& state) const;
    template <class E>
    const RodBatches<E::node_count>& batches_of(const ElementBlock<E>&) const {
        return std::get<RodBatches<E::node_count>>(rod_batches_);
    }
    // Of one part of a block's elements.
    template <class E>
    void add_forces(const ElementBlock<E>& block,
                    std::size_t part,
                    const State& state,
                    const Instant& instant,
                    const Vec3& gravity,
                    std::vector<Vec6>& nodal,
                    const PartScales& scales) const;
    template <class E>
    void add_tangents(const ElementBlock<E>& block,
                      std::size_t part,
                      const State& state,
                      const Instant& instant,
                      const Vec3& gravity,
                      const std::vector<NodeLinearization>& linearizations,
                      std::vector<double>& values) const;
    // One vector for each node, zero where there was none.
    void add_damping_forces(const State& state, std::vector<Vec6>& nodal) const;
    void forget_surroundings() const;
    void add_loads(const State& state, double time, Residual& residual) const;
    void add_load_tangents(const State& state,
                           double time,
                           const std::vector<NodeLinearization>& linearizations,
                           std::vector<double>& values) const;
    // With the tensions of all tendons, for what is recorded of sections.
    Instant instant_of_sections(const State& state, double time) const;
    const LoadValues& loads_at(double time) const;
    PointValues compute_point_value(const State& state, double time, const RodPlace& place) const;

    const Model* model_;
    const ThreadTeam* team_;
    Supports supports_;
    JointAssembly joints_;
    EquationNumbers equations_;
    ScaleGroups scale_groups_;
    ElementBlocks blocks_;
    AllRodBatches rod_batches_;
    RotaryBatches rotary_batches_;
    RotaryBatches rotary_damping_batches_;
    mutable LoadValues load_values_;
    mutable DriveValues drive_values_;
    std::unique_ptr<const SurroundingsAssembly> surroundings_;  // nullptr where nothing is around
    std::unique_ptr<const ContactAssembly> contact_;            // nullptr where nothing can touch
    TendonLines tendon_lines_;
    SparsePattern pattern_;
    std::vector<EntryRange> cleared_alone_;      // of nodes without elements
    std::vector<ElementPlaces<1>> load_places_;  // of each load's node
    std::vector<std::vector<std::int64_t>> loaded_element_slots_;
    double length_scale_ = 1.0;
    std::size_t history_count_ = 0;
    std::size_t point_count_ = 0;
    std::size_t memory_count_ = 0;
    int rod_element_count_ = 0;
    bool is_damped_ = false;
    bool has_laws_ = false;
};

}  // namespace gxrod
