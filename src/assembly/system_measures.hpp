#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "assembly/residual.hpp"
#include "assembly/system.hpp"
#include "state/point_drive.hpp"
#include "state/state.hpp"

namespace gxrod {

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

// Measures a system's motion, once a step: energies, momenta, forces and their work.
class SystemMeasures {
  public:
    // The system must outlive it.
    explicit SystemMeasures(const System& system) : system_(&system) {}

    std::size_t count_elements() const;
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
    // Computes the work of tendons and actuation strains within rods from the last accepted step to the
    // trial, at `time`, with the mean of both ends.
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
    // Bounds the relative rotations that elements interpolate: the largest one in `motions`, plus the most
    // that `spins` of the nodes can add to it (exp does not lengthen distances). Below π no relative rotation
    // is mistaken for its complement.
    RelativeRotation bound_relative_rotation(const std::vector<NodeMotion>& motions,
                                             const std::vector<Vec3>& spins) const;

  private:
    std::vector<DrivenPoint> list_driven_points(const std::vector<NodeMotion>& motions,
                                                const State& state,
                                                double time) const;
    // Adds damping forces, one vector for each node, which must be zero before.
    void add_damping_forces(const State& state, std::vector<Vec6>& nodal) const;

    const System* system_;
};

}  // namespace gxrod
