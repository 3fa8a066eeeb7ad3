#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "assembly/constraint_request.hpp"
#include "assembly/contribution.hpp"
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
#include "loads/drive_values.hpp"
#include "model/model.hpp"
#include "state/memory_slice.hpp"
#include "state/state.hpp"
#include "state/values/point_values.hpp"
#include "state/values/section_values.hpp"
#include "state/values/tendon_values.hpp"

namespace gxrod {

class ContactAssembly;
class SurroundingsAssembly;

// Sums over the model at the trial motions.
struct Balance {
    double kinetic_energy = 0.0;
    double strain_energy = 0.0;
    double gravity_potential = 0.0;  // 0 if gravity changes with time
    Momentum momentum;

    Balance& operator+=(const Balance& other);
};

// The sum of forces, and of their moments about the origin.
struct Resultant {
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
};

// The largest rotation of two nodes of one element against each other, and a node of that element.
struct RelativeRotation {
    double angle = 0.0;
    int node = -1;
};

// The model as one system of equations, assembled from its parts. It holds no state; it caches the loads at
// the last requested time, which does not change results.
class System {
  public:
    // The model must outlive the system, and so must the threads that share its work; their number does not
    // change results.
    explicit System(const Model& model, const ThreadTeam& team = ThreadTeam::alone());
    System(const Model& model, const Kernels& kernels, const ThreadTeam& team = ThreadTeam::alone());
    ~System();
    System(const System&) = delete;  // its parts point at each other
    System& operator=(const System&) = delete;

    const Model& model() const { return *model_; }
    const ThreadTeam& team() const { return *team_; }
    const Supports& supports() const { return supports_; }
    const JointAssembly& joints() const { return joints_; }
    // nullptr if nothing can touch.
    const ContactAssembly* contact() const { return contact_.get(); }
    // nullptr without fluid and ground.
    const SurroundingsAssembly* surroundings() const { return surroundings_; }
    const EquationNumbers& equations() const { return equations_; }
    const SparsePattern& pattern() const { return pattern_; }
    // The groups of nodes that elements and joints couple; the pattern follows from them.
    std::vector<NodeGroup> list_node_groups() const;
    // The model's length for scaling: the largest of its extent and the bodies' own sizes; 1 if both are
    // zero.
    double length_scale() const { return length_scale_; }
    // The length for scaling of the part of the model to which a node belongs.
    double length_scale_at(int node) const { return scale_groups_.length_at(node); }
    const ScaleGroups& scale_groups() const { return scale_groups_; }
    std::size_t element_count() const;
    // Whether any element interpolates rotations of the step; these must then stay below π.
    bool uses_step_rotations() const { return history_count_ > 0; }
    bool is_damped() const { return is_damped_ || joints_.is_damped(); }
    // Whether any section has a law other than stiffness × strain.
    bool has_laws() const { return has_laws_; }

    // Returns the reference shape with the model's initial velocities, zero where a support holds;
    // accelerations are zero.
    State initial_state() const;
    // The memory of laws of sections, and of tendons with friction.
    const MemorySlice& memory_within_rods() const { return memory_within_rods_; }
    // Makes the velocities of a node zero where a support holds it.
    void hold_rates(int node, NodeMotion& motion) const;

    // Computes the residual of the trial motions and multipliers, with loads at `time`.
    void compute_residual(const State& state,
                          double time,
                          Residual& residual,
                          const ConstraintRequest& request = {}) const;
    // Computes the derivative of the residual by the linearizations, as values on the pattern; if the state
    // holds resultants, the mixed tangent instead.
    void compute_tangent(const State& state,
                         double time,
                         const std::vector<NodeLinearization>& linearizations,
                         std::vector<double>& values,
                         const ConstraintRequest& request = {}) const;

    // Set the state's resultants of the mixed tangent: the first from the strains of the last accepted
    // motions, the second by advancing those of the trial motions by increments (δr, δφ) of the nodes, to
    // first order.
    void start_resultants(State& state) const;
    void advance_resultants(const std::vector<Vec6>& increments, State& state) const;

    // Makes the trial motions the last accepted step, at `time`.
    void commit(State& state, double time) const;

    // Forgets cached loads because a number other than the time has changed on which functions of loads
    // depend.
    void forget_loads() const;

    // Computes the balance with gravity at `time`.
    Balance compute_balance(const State& state, double time) const;
    // Compute the forces and moments per node that do work at the trial motions: loads, and gravity if it
    // changes with time; the other function adds the forces of moving supports. `residual` belongs to the
    // trial.
    std::vector<Vec6> compute_load_forces(const State& state, double time) const;
    // Computes the share of water, air and the ground in these forces; empty without surroundings.
    std::vector<Vec6> compute_surrounding_forces(const State& state, double time) const;
    void add_support_forces(const Residual& residual, std::vector<Vec6>& forces) const;
    // Compute the power of damping at the trial's rates, and the sum of the elements' damping_action in the
    // step from the previous motions to the trial ones. Neither is negative.
    double compute_damping_power(const State& state) const;
    double compute_damping_action(const State& state) const;
    // Whether tendons or actuation strains act within any rod.
    bool is_driven() const { return !drive_values_.empty(); }
    // Computes the work of these from the last accepted step to the trial, at `time`, with the mean of both
    // ends.
    double compute_drive_work(const State& state, double time) const;
    // Computes the dissipation of section laws from the last accepted step to the trial, at `time`.
    double compute_law_dissipation(const State& state, double time) const;
    // Compute kinetic energy and momentum of these motions, of which only rotations and rates matter.
    double compute_kinetic_energy(const std::vector<NodeMotion>& motions) const;
    Momentum compute_momentum(const std::vector<NodeMotion>& motions) const;
    // Returns the residual of held components, which is what supports exert, in global axes.
    std::vector<Vec6> compute_reactions(const Residual& residual) const;
    // Computes the resultant of all external actions at the trial motions: loads, gravity, damping and
    // supports. It is the rate of the momenta.
    Resultant compute_outer_resultant(const State& state, double time, std::span<const Vec6> reactions) const;
    // Computes values of all rod elements at the trial motions, rods in the order of the model, from start to
    // end.
    std::vector<SectionValues> compute_section_values(const State& state) const;
    // Computes values of all tendons at the trial motions and multipliers, in the order of the model.
    std::vector<TendonValues> compute_tendon_values(const State& state, double time) const;
    // Computes for each rod ∫ δE (C δE) ds, component by component (Γx Γy Γz Kx Ky Kz), where δE are the
    // first-order strain increments for increments (δr, δφ) of the nodes at the trial motions.
    std::vector<Vec6> compute_strain_work(const State& state, const std::vector<Vec6>& increments) const;
    // Computes values of points of rods at the trial motions; section forces belong to an equilibrium at
    // `time`.
    std::vector<PointValues> compute_point_values(const State& state,
                                                  double time,
                                                  const std::vector<RodPlace>& places) const;
    // Computes the surroundings of Model::bodies at the trial motions; empty without surroundings.
    std::vector<PointSurroundings> compute_body_surroundings(const State& state, double time) const;
    // Bounds the relative rotations that elements interpolate: the largest one in `motions`, plus the most
    // that `spins` of the nodes can add to it (exp does not lengthen distances). Below π no relative rotation
    // is mistaken for its complement.
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
    void build_contributions();
    void find_cleared();
    void build_batches();
    void measure();
    // Sets resultants from the strains of these motions after the increments, to first order.
    void set_resultants(const std::vector<NodeMotion>& motions,
                        double time,
                        const std::vector<Vec6>& increments,
                        State& state) const;
    template <class E>
    const RodBatches<E::node_count>& batches_of(const ElementBlock<E>&) const {
        return std::get<RodBatches<E::node_count>>(rod_batches_);
    }
    // Add the contributions of one part of a block's elements.
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
    // Adds damping forces, one vector for each node, which must be zero before.
    void add_damping_forces(const State& state, std::vector<Vec6>& nodal) const;
    void subtract_loads(const State& state, double time, Residual& residual) const;
    // Returns the instant with the tensions of all tendons, for records of sections.
    Instant instant_of_sections(const State& state, double time) const;
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
    mutable DriveValues drive_values_;
    TendonLines tendon_lines_;
    std::vector<std::unique_ptr<Contribution>> loads_;    // contributions whose work is external
    const SurroundingsAssembly* surroundings_ = nullptr;  // one of them; nullptr without surroundings
    std::unique_ptr<const ContactAssembly> contact_;      // nullptr if nothing can touch
    std::vector<const Contribution*> contributions_;      // all, in the order in which they add
    SparsePattern pattern_;
    std::vector<EntryRange> cleared_alone_;  // entries of nodes without elements
    double length_scale_ = 1.0;
    std::size_t history_count_ = 0;
    std::size_t point_count_ = 0;
    std::size_t memory_count_ = 0;
    MemorySlice memory_within_rods_;
    int rod_element_count_ = 0;
    bool is_damped_ = false;
    bool has_laws_ = false;
};

}  // namespace gxrod
