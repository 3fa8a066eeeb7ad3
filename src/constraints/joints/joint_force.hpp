#pragma once

#include "constraints/joints/joint_coordinate.hpp"
#include "constraints/joints/play/clearance_force.hpp"
#include "state/joint_state.hpp"

// Actions on coordinates that joints leave free, docs/theory/joints.md (J14) to (J17): springs, dampers,
// drives, friction, limits. They do not depend on a time step: friction slips from a given point.
namespace gxrod {

// Whether forces other than a motor's act.
bool is_acted_on(const JointCoordinate& laws);
// Whether any action dissipates energy.
bool is_damped_by(const JointCoordinate& laws);
// Whether any action does external work.
bool is_driven_by(const JointCoordinate& laws);

// The values of a coordinate's functions at the time of an equilibrium.
struct CoordinateInputs {
    double rest = 0.0;
    double drive = 0.0;
    double held = 0.0;  // size of the force that the joint holds, for friction
};

// A force on B along the coordinate (a turn's moment), its opposite on A, and its derivatives.
struct CoordinateForce {
    double value = 0.0;
    double by_coordinate = 0.0;
    double by_rate = 0.0;
    double by_held = 0.0;
};

CoordinateForce compute_coordinate_force(const JointCoordinate& laws,
                                         const ScalarJet& coordinate,
                                         const CoordinateInputs& inputs,
                                         double slip);

// Computes the force of friction alone, on B along the coordinate; `held` is the force that the joint holds.
double compute_friction_force(const Friction& friction, double held, double coordinate, double slip);

// Computes the energy of springs, limits and elastic friction.
double compute_coordinate_energy(const JointCoordinate& laws,
                                 double coordinate,
                                 const CoordinateInputs& inputs,
                                 double slip);

// Computes the power that dampers dissipate, damping of limits included; never negative.
double compute_coordinate_damping_power(const JointCoordinate& laws, const ScalarJet& coordinate);

// Computes the coordinate at which the elastic part of friction is free of force, after all slip.
double compute_slip(const Friction& friction, double coordinate, double slip);

// Computes the initial value of this point: moving joints slip, resting joints exert no friction. `speed` is
// the speed of the two sides; the coordinate rests if its rate, their difference, is round-off of it.
double compute_first_slip(const Friction& friction, const ScalarJet& coordinate, double speed);

// Computes the dissipation of friction for a slip while the joint holds that force.
double compute_slip_dissipation(const Friction& friction, double held, double slip_before, double slip);

// The inputs of both coordinates.
struct JointInputs {
    CoordinateInputs turn, slide;
};
// The forces on the coordinates of one joint, and of contact in its clearance.
class JointForces {
  public:
    explicit JointForces(const Joint& joint);

    // Whether nothing acts on any of them.
    bool is_empty() const { return !turn_ && !slide_ && !clearance_; }

    // Computes forces, and moments about the nodes, on (A, B), by their (δr, δφ).
    PairRow compute_force(const JointMotions& motions,
                          double turn_before,
                          const JointInputs& inputs,
                          const JointSlips& slips) const;
    // Computes the derivative of the transposed force by Newton's unknowns.
    PairMatrix compute_tangent(const JointMotions& motions,
                               const JointLinearizations& linearizations,
                               double turn_before,
                               const JointInputs& inputs,
                               const JointSlips& slips) const;
    // Computes the derivative of the force by the size of the force that the joint holds.
    PairRow compute_held_derivative(const JointMotions& motions,
                                    double turn_before,
                                    const JointInputs& inputs,
                                    const JointSlips& slips) const;
    // Whether friction depends on the force that the joint holds.
    bool follows_held() const { return turn_laws_.friction.lever > 0.0 || slide_laws_.friction.lever > 0.0; }
    double compute_strain_energy(const JointMotions& motions,
                                 double turn_before,
                                 const JointInputs& inputs,
                                 const JointSlips& slips) const;
    double compute_damping_power(const JointMotions& motions, double turn_before) const;
    // The contact in the joint's clearance; nullopt if the joint has none.
    const std::optional<ClearanceForce>& clearance() const { return clearance_; }

    JointSlips compute_slips(const JointMotions& motions, double turn_before, const JointSlips& before) const;
    JointSlips compute_first_slips(const JointMotions& motions, double turn_before) const;
    double compute_dissipation(const JointInputs& inputs,
                               const JointSlips& before,
                               const JointSlips& slips) const;

  private:
    // A coordinate with its value, its laws, and its own inputs and slip.
    template <class Coordinate>
    struct Acting {
        const Coordinate& coordinate;
        const JointCoordinate& laws;
        ScalarJet jet;
        CoordinateInputs JointInputs::*inputs;
        double JointSlips::*slip;
    };

    template <class Visit>
    void visit(const JointFrames& frames, double turn_before, Visit&& visit_one) const;
    JointFrames rates_at(const JointMotions& motions) const {
        return {motions, arms_, ConstraintLevel::velocity};
    }

    JointArms arms_;
    std::optional<JointTurn> turn_;
    std::optional<LinkProduct> slide_;
    std::optional<ClearanceForce> clearance_;
    JointCoordinate turn_laws_, slide_laws_;
};

}  // namespace gxrod
