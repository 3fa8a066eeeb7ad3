#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
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

namespace gxrod {

class ContactAssembly;
class SurroundingsAssembly;
class System;

// Properties that a system has if any of its parts has them.
struct SystemTraits {
    bool uses_step_rotations = false;  // elements that interpolate rotations of the step, which stay below π
    bool is_damped = false;
    bool has_laws = false;   // sections with a law other than stiffness × strain
    bool is_driven = false;  // tendons or actuation strains within rods
    bool has_surroundings = false;
};

// Returns nullptr if nothing can touch.
const ContactAssembly* contact_assembly_of(const System& system);
// Returns the groups of nodes that contact couples in a system of small motions; nullopt in all others.
const std::optional<std::vector<NodeGroup>>& touching_groups_of(const System& system);
// Lets contact act at the stages of a scheme like any other force, and not as an impulse of each step. Call
// it before anything is computed.
void resolve_contact(System& system);

// The model as one system of equations, assembled from its parts. It holds no state; it caches the loads at
// the last requested time, which does not change results.
class System {
  public:
    // The model must outlive the system, and so must the threads that share its work; their number does not
    // change results.
    explicit System(const Model& model, const ThreadTeam& team = ThreadTeam::alone());
    System(const Model& model, const Kernels& kernels, const ThreadTeam& team = ThreadTeam::alone());
    // Makes the system of small motions about a state in which contact of rods couples these groups of nodes
    // (TouchingSystem): pattern and tangent have them, and no contact has impulses.
    System(const Model& model, const ThreadTeam& team, std::optional<std::vector<NodeGroup>> touching);
    ~System();
    System(const System&) = delete;  // its parts point at each other
    System& operator=(const System&) = delete;

    const Model& model() const { return *model_; }
    const ThreadTeam& team() const { return *team_; }
    const Supports& supports() const { return supports_; }
    const JointAssembly& joints() const { return joints_; }
    const EquationNumbers& equations() const { return equations_; }
    const SparsePattern& pattern() const { return pattern_; }
    // The groups of nodes that elements and joints couple; the pattern follows from them.
    std::vector<NodeGroup> list_node_groups() const;
    // The model's length for scaling: the largest of its extent and the bodies' own sizes; 1 if both are
    // zero.
    double length_scale() const { return length_scale_; }
    const ScaleGroups& scale_groups() const { return scale_groups_; }
    const SystemTraits& traits() const { return traits_; }

    // Returns the reference shape with the model's initial velocities, zero where a support holds;
    // accelerations are zero.
    State initial_state() const;
    // The memory of laws of sections, and of tendons with friction.
    const MemorySlice& memory_within_rods() const { return memory_within_rods_; }

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

  private:
    System(const Model& model,
           const Kernels& kernels,
           const ThreadTeam& team,
           std::optional<std::vector<NodeGroup>> touching);
    friend class SystemMeasures;
    friend class SystemValues;
    friend const ContactAssembly* contact_assembly_of(const System& system);
    friend const std::optional<std::vector<NodeGroup>>& touching_groups_of(const System& system);
    friend void resolve_contact(System& system);

    void build_blocks();
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
    void subtract_loads(const State& state, double time, Residual& residual) const;
    // Returns the instant with the tensions of all tendons, for records of sections.
    Instant instant_of_sections(const State& state, double time) const;

    const Model* model_;
    const ThreadTeam* team_;
    std::optional<std::vector<NodeGroup>> touching_;
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
    std::unique_ptr<ContactAssembly> contact_;            // nullptr if nothing can touch
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
    SystemTraits traits_;
};

}  // namespace gxrod
