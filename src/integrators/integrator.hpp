#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/settings/settings.hpp"
#include "parallel/thread_team.hpp"
#include "state/constraint_level.hpp"
#include "state/state.hpp"

namespace gxrod {

// One equilibrium (or, explicit, one evaluation) of a step.
struct Stage {
    int index;         // 0 … stage_count − 1
    double step_time;  // where the step starts
    double time_step;  // Δt of the whole step
    double end_time;   // where the step ends: step_time + time_step but for rounding
};

// The length for scaling of the part of the model to which a node belongs.
using NodeLengths = std::function<double(int node)>;

// An estimate of a step's error: the length of that of a node's displacement relative to its part's length,
// of its rotation in rad, and of its velocity and angular velocity, times Δt, alike. The largest, and the
// node that has it, with the largest component (0 … 5).
struct StepError {
    double size = 0.0;
    int node = -1;
    int component = -1;
};

// Of each node's estimated errors (δr, δφ) and those of (v, ω) times Δt.
StepError measure_step_error(const std::vector<Vec6>& placements,
                             const std::vector<Vec6>& rates,
                             const NodeLengths& lengths);

// Nodes first … last − 1.
struct NodeRange {
    std::size_t first, last;
};

// Which polynomials carry placements through a step, and the power of Δt by which what they leave out falls.
struct Interpolant {
    std::string form;
    int order;
};

class CoupledStages;

// How time advances. A step is a sequence of stages; for each, begin_stage places the trial motions and the
// solver then makes them satisfy equilibrium at stage_time: an implicit scheme by moving (r, Λ) and calling
// update_rates, an explicit one by finding the accelerations at the given motions. The last stage leaves the
// motion at the end of the step. Integrators hold no state and never see an element. What they do to one node
// depends on no other, so the work is shared by a team of threads.
class Integrator {
  public:
    virtual ~Integrator() = default;

    virtual int stage_count() const { return 1; }
    // Where in the step the stage's equilibrium lies, 0 … 1.
    virtual double stage_fraction(int) const { return 1.0; }
    // The end of the step to the last bit, so that a load that switches on the grid of steps does so here
    // too.
    double stage_time(const Stage& stage) const {
        const double fraction = stage_fraction(stage.index);
        return fraction == 1.0 ? stage.end_time : stage.step_time + fraction * stage.time_step;
    }
    // Where the equations of joints are asked for in a stage: of positions, or of accelerations, where rates
    // of a stage that followed from positions would lose the scheme's order. The last stage of an implicit
    // scheme asks for positions.
    virtual ConstraintLevel constraint_level(int) const { return ConstraintLevel::position; }
    virtual bool is_explicit() const { return false; }
    // Of a scheme whose stages are found together; nullptr if they follow each other.
    virtual const CoupledStages* coupled() const { return nullptr; }
    // Whether there are no rates, and rotations of a step of any size.
    virtual bool is_static() const { return false; }

    // Forces of contact are impulses of a step, apart from the scheme: w = Δt M⁻¹ f is added to velocities,
    // Δt w / 2 to positions (docs/theory/contact.md, (C16)). An equilibrium with this multiple of f places
    // nodes so; 0: the scheme cannot.
    virtual double contact_weight() const { return is_static() ? 1.0 : 0.0; }
    // After the step's equilibrium, when the trial has the accelerations without contact: `shocked`, (a, α)
    // of each node of the equilibrium, become those of the mean over the step, impulses included.
    virtual void average_impulses(const State&, std::vector<Vec6>& /*shocked*/) const {}

    // How many of State::carried_previous belong to each node; set by start().
    virtual int carried_count() const { return 0; }
    // Whether the rates at the end of a step are corrected so that energy and momenta change by the work and
    // the impulses of the step alone.
    virtual bool conserves() const { return false; }
    // Once, when the trial motions have the initial accelerations.
    virtual void start(State&) const {}
    // Places the trial motions, whatever they were: an implicit scheme predicts, an explicit one sets what
    // the accelerations are for.
    void begin_stage(State& state, const Stage& stage, const ThreadTeam& team = ThreadTeam::alone()) const;
    // Velocities and accelerations of the trial from its r, Λ and θ. Implicit schemes only.
    void update_rates(State& state, const Stage& stage, const ThreadTeam& team = ThreadTeam::alone()) const;
    // How the trial motions follow (δr, δφ).
    void linearize(const State& state,
                   const Stage& stage,
                   std::vector<NodeLinearization>& linearizations,
                   const ThreadTeam& team = ThreadTeam::alone()) const;
    // The paper's linearization (5.6), in δθ with T(θ) taken as I; only where has_paper_tangent.
    virtual bool has_paper_tangent() const { return false; }
    void linearize_as_paper(const State& state,
                            const Stage& stage,
                            std::vector<NodeLinearization>& linearizations,
                            const ThreadTeam& team = ThreadTeam::alone()) const;
    // After the stage's equilibrium is found.
    void end_stage(State& state, const Stage& stage, const ThreadTeam& team = ThreadTeam::alone()) const;

    // The power of Δt by which estimate_error falls; 0 for a scheme that has no estimate.
    virtual int error_order() const { return 0; }
    // Of the step whose last stage was just solved, before it is committed. `length` is the model's.
    virtual StepError estimate_error(const State&,
                                     double /*time_step*/,
                                     const NodeLengths& /*lengths*/) const {
        return {};
    }

    // What the scheme itself dissipates in a step, apart from damping: the sum over so many terms of twice
    // the kinetic energy at certain rates of the nodes, so never negative (docs/theory/energy.md).
    virtual int dissipation_terms() const { return 0; }
    // Sets v and ω of `rates`, which are otherwise the trial motions, to those of one term. Of the step just
    // solved, before it is committed.
    virtual void set_dissipated_rates(const State&,
                                      double /*time_step*/,
                                      int /*term*/,
                                      std::vector<NodeMotion>& /*rates*/) const {}

    // Between the ends of a step that was solved and is not committed, at this fraction of it: sets
    // `motions`. Placements by cubic Hermite polynomials in (r, v) and (θ, T(θ)⁻¹ ω), velocities by their
    // derivatives; accelerations linear (docs/theory/newmark.md, (D1)).
    virtual void interpolate(const State& state,
                             double time_step,
                             double fraction,
                             std::vector<NodeMotion>& motions,
                             const ThreadTeam& team = ThreadTeam::alone()) const;
    virtual Interpolant interpolant() const { return {"cubic Hermite polynomials", 4}; }
    // Fractions of the step, between 0 and 1, at which State::stage_motions has the motions of an
    // equilibrium …
    virtual std::vector<double> inner_fractions() const { return {}; }
    // … and the weights of values at the start, at these and at the end, that interpolate them.
    std::vector<double> interpolation_weights(double fraction) const;

    // Weights of the power of loads over a step, in order: at its start, then at each stage. They integrate
    // the work of the loads to the scheme's order. Empty for one-stage schemes, whose work is the mean load
    // times displacement.
    virtual std::vector<double> power_weights() const { return {}; }

  protected:
    // How many stages' rates of a step State::stages holds.
    virtual int kept_stages() const { return 0; }
    // The same for some of the nodes; the vectors have their sizes.
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

// The integrator that the settings name, with their parameters.
std::unique_ptr<Integrator> make_integrator(const DynamicSettings& settings);

// The linearization that leaves a mass matrix: accelerations alone.
NodeLinearization mass_linearization();
std::vector<NodeLinearization> mass_linearizations(std::size_t node_count);

}  // namespace gxrod
