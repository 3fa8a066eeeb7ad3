#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/settings/settings.hpp"
#include "parallel/thread_team.hpp"
#include "state/constraint_level.hpp"
#include "state/motion_gradient.hpp"
#include "state/state.hpp"

namespace gxrod {

// One equilibrium (or, explicit, one evaluation) of a step.
struct Stage {
    int index;         // 0 … stage_count − 1
    double step_time;  // start of the step
    double time_step;  // Δt of the whole step
    double end_time;   // end of the step: step_time + time_step up to rounding
};

// The length for scaling of the part of the model to which a node belongs.
using NodeLengths = std::function<double(int node)>;

// An estimate of a step's error: the largest of the nodes' errors of displacement, relative to the length of
// their part, of rotation in rad, and likewise of velocity and angular velocity times Δt; with its node and
// its largest component (0 … 5).
struct StepError {
    double size = 0.0;
    int node = -1;
    int component = -1;
};

// Measures the error from each node's estimated errors of (δr, δφ) and of (v, ω) times Δt.
StepError measure_step_error(const std::vector<Vec6>& placements,
                             const std::vector<Vec6>& rates,
                             const NodeLengths& lengths);

// Nodes first … last − 1.
struct NodeRange {
    std::size_t first, last;
};

// The polynomials that interpolate placements in a step, and the power of Δt in their error.
struct Interpolant {
    std::string form;
    int order;
};

class CoupledStages;

// A scheme of integration in time. A step is a sequence of stages; for each, begin_stage places the trial
// motions and the solver then makes them satisfy equilibrium at stage_time: for an implicit scheme by moving
// (r, Λ) and calling update_rates, for an explicit one by finding the accelerations at the given motions. The
// last stage leaves the motion at the end of the step. Integrators hold no state and do not depend on
// elements. Nodes are independent of each other here, so a team of threads shares the work.
class Integrator {
  public:
    virtual ~Integrator() = default;

    virtual int stage_count() const { return 1; }
    // The time of the stage's equilibrium in the step, 0 … 1.
    virtual double stage_fraction(int) const { return 1.0; }
    // Returns the stage's time; at the end of the step exactly end_time, so that a load that switches on the
    // grid of steps does so here too.
    double stage_time(const Stage& stage) const {
        const double fraction = stage_fraction(stage.index);
        return fraction == 1.0 ? stage.end_time : stage.step_time + fraction * stage.time_step;
    }
    // The level of joints' equations in a stage: positions, or accelerations if rates from positions would
    // reduce the scheme's order. The last stage of an implicit scheme uses positions.
    virtual ConstraintLevel constraint_level(int) const { return ConstraintLevel::position; }
    virtual bool is_explicit() const { return false; }
    // Returns the scheme if its stages are solved together; nullptr if they follow each other.
    virtual const CoupledStages* coupled() const { return nullptr; }
    // Whether there are no rates, and rotations of a step can have any size.
    virtual bool is_static() const { return false; }

    // Contact forces are impulses of a step, apart from the scheme: w = Δt M⁻¹ f is added to velocities, Δt w
    // / 2 to positions (docs/theory/contact.md, (C16)). An equilibrium with this multiple of f places nodes
    // accordingly; 0 if the scheme does not support it.
    virtual double contact_weight() const { return is_static() ? 1.0 : 0.0; }
    // Whether contact acts at the stages like any other force instead, with the weight 1: a stiff spring,
    // which short steps resolve and damped stages damp.
    virtual bool resolves_contact() const { return is_static(); }
    // Takes impulses out of the accelerations of a step, when its equilibrium is found and the trial has the
    // accelerations without contact: sets what the scheme carries from these, and changes `shocked`, (a, α)
    // of each node in the equilibrium, to the mean over the step, impulses included.
    virtual void split_impulses(State&, const Stage&, std::vector<Vec6>& /*shocked*/) const {}

    // The number of entries of State::carried_previous for each node; start() sets them.
    virtual int carried_count() const { return 0; }
    // Whether the rates at the end of a step are corrected so that energy and momenta change only by the work
    // and the impulses of the step.
    virtual bool conserves() const { return false; }
    // Starts the scheme, once, when the trial motions have the initial accelerations.
    virtual void start(State&) const {}
    // Places the trial motions anew: an implicit scheme predicts them, an explicit one sets the motions at
    // which accelerations are needed.
    void begin_stage(State& state, const Stage& stage, const ThreadTeam& team = ThreadTeam::alone()) const;
    // Computes velocities and accelerations of the trial from its r, Λ and θ, for implicit schemes only.
    void update_rates(State& state, const Stage& stage, const ThreadTeam& team = ThreadTeam::alone()) const;
    // Computes the derivatives of the trial motions by (δr, δφ).
    void linearize(const State& state,
                   const Stage& stage,
                   std::vector<NodeLinearization>& linearizations,
                   const ThreadTeam& team = ThreadTeam::alone()) const;
    // Transposes the derivatives of update_rates at the trial motions, only if has_transposed_rates. Of a
    // scalar that changes by `rates` with the rates of the trial and what is carried from there, adds how it
    // changes with the trial's placements, and with the motions and what was carried before the step.
    virtual bool has_transposed_rates() const { return false; }
    virtual void transpose_rates(const State&,
                                 double /*time_step*/,
                                 const MotionGradient& /*rates*/,
                                 MotionGradient& /*trial*/,
                                 MotionGradient& /*previous*/) const {}
    // Computes the paper's linearization (5.6), in δθ with T(θ) taken as I; only if has_paper_tangent.
    virtual bool has_paper_tangent() const { return false; }
    void linearize_as_paper(const State& state,
                            const Stage& stage,
                            std::vector<NodeLinearization>& linearizations,
                            const ThreadTeam& team = ThreadTeam::alone()) const;
    // Finishes a stage after its equilibrium is found.
    void end_stage(State& state, const Stage& stage, const ThreadTeam& team = ThreadTeam::alone()) const;

    // The power of Δt in estimate_error; 0 for a scheme without an estimate.
    virtual int error_order() const { return 0; }
    // Estimates the error of the step whose last stage was just solved, before it is committed; `lengths`
    // scale displacements.
    virtual StepError estimate_error(const State&,
                                     double /*time_step*/,
                                     const NodeLengths& /*lengths*/) const {
        return {};
    }

    // The number of terms of the scheme's own dissipation in a step, apart from damping. Each term is twice
    // the kinetic energy at certain rates of the nodes, so never negative (docs/theory/energy.md).
    virtual int dissipation_terms() const { return 0; }
    // Sets v and ω of `rates`, otherwise the trial motions, to the rates of one term, for the step just
    // solved, before it is committed.
    virtual void set_dissipated_rates(const State&,
                                      double /*time_step*/,
                                      int /*term*/,
                                      std::vector<NodeMotion>& /*rates*/) const {}

    // Sets `motions` at this fraction of a solved step that is not committed. Placements follow cubic Hermite
    // polynomials in (r, v) and (θ, T(θ)⁻¹ ω), velocities their derivatives; accelerations are linear
    // (docs/theory/newmark.md, (D1)).
    virtual void interpolate(const State& state,
                             double time_step,
                             double fraction,
                             std::vector<NodeMotion>& motions,
                             const ThreadTeam& team = ThreadTeam::alone()) const;
    virtual Interpolant interpolant() const { return {"cubic Hermite polynomials", 4}; }
    // Fractions of the step, between 0 and 1, at which State::stage_motions is in equilibrium.
    virtual std::vector<double> inner_fractions() const { return {}; }
    // Returns the weights of values at the start, at these fractions and at the end, for interpolation.
    std::vector<double> interpolation_weights(double fraction) const;

    // Weights of the power of loads over a step, in order: at its start, then at each stage. They integrate
    // the work of the loads to the scheme's order. Empty for one-stage schemes, whose work is the mean load
    // times displacement.
    virtual std::vector<double> power_weights() const { return {}; }

  protected:
    // The number of stages whose rates State::stages keeps in a step.
    virtual int kept_stages() const { return 0; }
    // These do the same for some of the nodes; the vectors already have their sizes.
    virtual void place_nodes(State& state, const Stage& stage, NodeRange nodes) const = 0;
    virtual void update_nodes(State& state, const Stage& stage, NodeRange nodes) const = 0;
    virtual void linearize_nodes(const State& state,
                                 const Stage& stage,
                                 NodeRange nodes,
                                 std::vector<NodeLinearization>& linearizations) const = 0;
    virtual void linearize_nodes_as_paper(const State&,
                                          const Stage&,
                                          NodeRange,
                                          std::vector<NodeLinearization>&) const {}
    virtual void finish_nodes(State&, const Stage&, NodeRange) const {}
};

// Makes the integrator that the settings name, with their parameters.
std::unique_ptr<Integrator> make_integrator(const DynamicSettings& settings);

// Returns the linearization that leaves a mass matrix: accelerations alone.
NodeLinearization mass_linearization();
std::vector<NodeLinearization> mass_linearizations(std::size_t node_count);

}  // namespace gxrod
