#pragma once

#include "constraints/joints/joint_coordinate.hpp"

// What acts on coordinates that joints leave free, docs/theory/joints.md (J14) to (J17): springs, dampers,
// drives, friction, limits. Nothing here knows a time step: friction slips from a point that is given.
namespace gxrod {

// Whether forces other than a motor's act.
bool is_acted_on(const JointCoordinate& laws);
// Whether something can take energy.
bool is_damped_by(const JointCoordinate& laws);
// Whether something can do work from outside.
bool is_driven_by(const JointCoordinate& laws);

// The values of a coordinate's functions at the time of an equilibrium.
struct CoordinateInputs {
    double rest = 0.0;
    double drive = 0.0;
    double held = 0.0;  // the size of the force that the joint holds, for friction
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

// Of friction alone, on B along the coordinate, while the joint holds that force.
double compute_friction_force(const Friction& friction, double held, double coordinate, double slip);

// Of springs, of limits, and of friction's elastic part.
double compute_coordinate_energy(const JointCoordinate& laws,
                                 double coordinate,
                                 const CoordinateInputs& inputs,
                                 double slip);

// What dampers take, those of limits too; never negative.
double compute_coordinate_damping_power(const JointCoordinate& laws, const ScalarJet& coordinate);

// Where friction's elastic part is without force, after it has slipped as far as it must.
double compute_slip(const Friction& friction, double coordinate, double slip);

// The same at the start: what moves slips, what rests exerts nothing. `speed`: of the two sides, whose
// difference the coordinate's rate is; where that is round-off of them, the coordinate rests.
double compute_first_slip(const Friction& friction, const ScalarJet& coordinate, double speed);

// What friction takes as it slips while the joint holds that force.
double compute_slip_dissipation(const Friction& friction, double held, double slip_before, double slip);

// Of both coordinates.
struct JointInputs {
    CoordinateInputs turn, slide;
};
struct JointSlips {
    double turn = 0.0;
    double slide = 0.0;
};

// The forces on the coordinates of one joint.
class JointForces {
  public:
    explicit JointForces(const Joint& joint);

    // Whether nothing acts on any of them.
    bool is_empty() const { return !turn_ && !slide_; }

    // On (A, B) by their (δr, δφ): forces, and moments about the nodes.
    PairRow compute_force(const JointMotions& motions,
                          double turn_before,
                          const JointInputs& inputs,
                          const JointSlips& slips) const;
    // The derivative of its transpose by Newton's unknowns.
    PairMatrix compute_tangent(const JointMotions& motions,
                               const JointLinearizations& linearizations,
                               double turn_before,
                               const JointInputs& inputs,
                               const JointSlips& slips) const;
    // The derivative of the force by the size of the force that the joint holds.
    PairRow compute_held_derivative(const JointMotions& motions,
                                    double turn_before,
                                    const JointInputs& inputs,
                                    const JointSlips& slips) const;
    // Whether friction follows the force that the joint holds.
    bool follows_held() const { return turn_laws_.friction.lever > 0.0 || slide_laws_.friction.lever > 0.0; }
    double compute_strain_energy(const JointMotions& motions,
                                 double turn_before,
                                 const JointInputs& inputs,
                                 const JointSlips& slips) const;
    double compute_damping_power(const JointMotions& motions, double turn_before) const;

    JointSlips compute_slips(const JointMotions& motions, double turn_before, const JointSlips& before) const;
    JointSlips compute_first_slips(const JointMotions& motions, double turn_before) const;
    double compute_dissipation(const JointInputs& inputs,
                               const JointSlips& before,
                               const JointSlips& slips) const;

  private:
    // A coordinate where it is, what acts on it, and which inputs and slip are its own.
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
    JointCoordinate turn_laws_, slide_laws_;
};

}  // namespace gxrod
