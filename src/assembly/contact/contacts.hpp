#pragma once

#include <string>
#include <vector>

#include "assembly/contact/contact_limits.hpp"
#include "assembly/contact/contact_work.hpp"
#include "assembly/node_groups.hpp"
#include "assembly/system.hpp"
#include "state/contact_touch.hpp"
#include "state/state.hpp"
#include "state/values/obstacle_values.hpp"

namespace gxrod {

struct PairBlock;

// The contact of a system, for solvers, analyses and checks. A system in which nothing can touch answers too:
// there are no forces, touches or energy.
class Contacts {
  public:
    // The system must outlive it.
    explicit Contacts(const System& system) : contact_(contact_assembly_of(system)) {}

    // Whether anything can touch in this model.
    bool are_possible() const { return contact_ != nullptr; }
    // Whether rods or bodies can touch each other; their tangent is then blocks of pairs.
    bool couple_rods() const;

    // Finds pieces near the trial; before forces are asked for there outside of an equilibrium.
    void search(State& state) const;
    // Whether contact is an impulse of each step, apart from the scheme; if not, it acts at each stage, or in
    // statics, like any other force.
    bool are_impulses() const;
    // Whether anything pushes at the trial motions, also in a step that leaves an obstacle.
    bool have_forces(const State& state, double time) const;
    // Lists the groups of nodes that rods couple, or are likely to couple, where they touch each other.
    std::vector<NodeGroup> list_groups(const State& state) const;
    // Adds the tangents of contact with obstacles, on the system's pattern.
    void add_tangents(const State& state,
                      double time,
                      const ConstraintRequest& request,
                      const std::vector<NodeLinearization>& linearizations,
                      std::vector<double>& values) const;
    // Computes one block for each two elements of rods that touch.
    std::vector<PairBlock> compute_tangents(const State& state,
                                            double weight,
                                            const std::vector<NodeLinearization>& linearizations) const;

    double compute_energy(const State& state, double time) const;
    // Computes the power of a motion in which contact acts at the stages of a scheme; else it is 0.
    ContactPower compute_power(const State& state, double time) const;
    // Computes the work in the step from the last accepted motions to the trial, at `time`; the energy at its
    // start was `energy_before`.
    ContactWork compute_work(const State& state, double time, double energy_before) const;

    // The functions of ContactAssembly of these names.
    ContactCount count(const State& state, double time) const;
    std::string describe_overlap(const State& state, double time) const;
    std::vector<ContactTouch> list_touches(const State& state, double time) const;
    std::vector<ObstacleValues> compute_obstacle_values(const State& state, double time) const;
    ObstacleValues compute_watched(const ContactWatch& watch,
                                   const std::vector<ContactTouch>& touches,
                                   const State& state,
                                   double time) const;
    std::vector<Vec6> compute_forces(const State& state, double time) const;
    std::vector<double> compute_gaps(const State& state, double time) const;

  private:
    const ContactAssembly* contact_;  // nullptr if nothing can touch
};

}  // namespace gxrod
