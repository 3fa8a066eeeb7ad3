#pragma once

#include <Eigen/Core>

#include "assembly/system.hpp"

namespace gxrod {

// A direction of a path of equilibria, or the difference of two of its points, in the unknowns and the load
// factor.
struct PathVector {
    Eigen::VectorXd u;
    double load = 0.0;
};

inline PathVector operator*(double factor, const PathVector& x) { return {factor * x.u, factor * x.load}; }
inline PathVector operator+(const PathVector& x, const PathVector& y) { return {x.u + y.u, x.load + y.load}; }

// The measure of arc lengths of paths, (PA3): displacements over the model's length, rotations times 0.2,
// each node weighted by its share of the rods' length; load factors over a scale.
class PathMetric {
  public:
    explicit PathMetric(const System& system);

    // Scales load factors so that unknowns and load factor make equal parts of a direction in which the load
    // factor grows by 1 and the unknowns by `rate`.
    void scale_load(const Eigen::VectorXd& rate);
    void set_load_scale(double scale) { load_scale_ = scale; }
    double load_scale() const { return load_scale_; }

    const Eigen::VectorXd& weights() const { return weights_; }
    // Returns the row whose product with y, row.u · y.u + row.load y.load, is the scalar product of x and y.
    PathVector row(const PathVector& x) const;
    double multiply(const PathVector& x, const PathVector& y) const;
    double multiply(const Eigen::VectorXd& x, const Eigen::VectorXd& y) const {
        return x.dot(weights_.cwiseProduct(y));
    }
    double norm(const PathVector& x) const;
    double norm(const Eigen::VectorXd& x) const;

  private:
    Eigen::VectorXd weights_;
    double load_scale_ = 1.0;
};

// Computes the step from the last accepted motions to the trial ones, rotations as rotation vectors.
Eigen::VectorXd compute_step(const System& system, const State& state);

}  // namespace gxrod
