#pragma once

#include "constraints/joints/joint_coordinate.hpp"

namespace gxrod {

// The distance D of B's point from a cam's curve, measured in the plane of the curve to the side of the
// roller, docs/theory/joints.md (J37) to (J40). It is a function of x and y, the coordinates of the point in
// that plane; D less the roller's radius is the gap.
class CamDistance {
  public:
    // Takes a joint with a cam.
    explicit CamDistance(const Joint& joint);

    const JointCam& cam() const { return cam_; }
    // Finds the place of the curve nearest to B's point.
    PlaneCurve::Place find_place(const JointFrames& frames) const;
    // Returns the direction of increasing distance, spatial.
    Vec3 find_normal(const JointFrames& frames) const;

    // These do the same as in LinkProduct.
    ScalarJet compute_jet(const JointFrames& frames) const;
    void add_gradient(const JointFrames& frames, double factor, PairRow& row) const;
    void add_change(const JointFrames& frames,
                    const JointLinearizations& linearizations,
                    const ScalarJet& weights,
                    PairRow& row) const;
    void add_reaction(const JointFrames& frames, double multiplier, JointReaction& reaction) const;

  private:
    using Point = PlaneCurve::Point;

    // The distance with its derivatives by x and y: ∇D = n, ∇∇D = k t tᵀ, and that of k along t.
    struct Local {
        double distance;
        Point n, t;
        double k, k_along;
    };
    Point compute_point(const JointFrames& frames) const;
    Local measure(const Point& point) const;
    Jet<Point> compute_jets(const JointFrames& frames) const;
    Vec3 carry(const JointFrames& frames, const Point& direction) const;

    JointCam cam_;
    std::array<Vec3, 2> axes_;          // of x and y, in the global axes of t = 0
    std::array<LinkProduct, 2> along_;  // x and y
};

}  // namespace gxrod
