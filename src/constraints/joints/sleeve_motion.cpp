#include "constraints/joints/sleeve_motion.hpp"

#include <unsupported/Eigen/AutoDiff>

namespace gxrod {

namespace {

using Points = SleeveMotion::Points;

template <class Number>
using Vector = Eigen::Matrix<Number, 3, 1>;

// Numbers with their derivatives by the unknowns.
template <int Unknowns>
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, Unknowns, 1>>;

constexpr int derivative_count = 4;

// Of the weights of all points in d(s), the derivatives by s of all orders.
template <class Number>
using Weights = std::array<std::array<Number, SleeveMotion::most_points>, derivative_count>;

// Motions of points in numbers of any kind.
template <class Number>
struct LineMotions {
    std::array<Vector<Number>, SleeveMotion::most_points> values, rates, accelerations;
};

template <class Number>
Weights<Number> compute_weights(const Points& points, const Number& s) {
    const auto of_line = points.piece->compute_weights<derivative_count>(s);
    Weights<Number> weights;
    for (int order = 0; order < derivative_count; ++order) {
        weights[order][0] = Number(order == 0 ? 1.0 : 0.0);
        for (int i = 0; i < SmoothLine::most_points; ++i) weights[order][1 + i] = -of_line[order][i];
    }
    return weights;
}

template <class Number>
Vector<Number> sum_up(const std::array<Number, SleeveMotion::most_points>& weights,
                      const std::array<Vector<Number>, SleeveMotion::most_points>& vectors,
                      int count) {
    Vector<Number> sum = weights[0] * vectors[0];
    for (int i = 1; i < count; ++i) sum += weights[i] * vectors[i];
    return sum;
}

// The place s, d and its derivatives by s, and how they move where the points do, (J27).
template <class Number>
class Sliding {
  public:
    Sliding(const Points& points, double s, const LineMotions<Number>& motions)
        : motions_(motions), count_(points.count()) {
        // A step of Newton's method from the place itself gives its derivatives.
        set_place(points, Number(s));
        const Number miss = d[0].dot(d[1]);
        place.value = s - miss / scalar(slope());
        set_place(points, place.value);
    }

    void set_rates() {
        for (int order = 0; order < 3; ++order) v[order] = sum_up(weights_[order], motions_.rates, count_);
        place.rate = -(v[0].dot(d[1]) + d[0].dot(v[1])) / slope();
        moved.rate = v[0] + d[1] * place.rate;
    }

    void set_accelerations() {
        const Number& rate = place.rate;
        const Vector<Number> a0 = sum_up(weights_[0], motions_.accelerations, count_);
        const Vector<Number> a1 = sum_up(weights_[1], motions_.accelerations, count_);
        const Vector<Number> turned = v[1] + d[2] * rate;
        const Vector<Number> free0 = a0 + v[1] * (rate * 2.0) + d[2] * (rate * rate);
        const Vector<Number> free1 = a1 + v[2] * (rate * 2.0) + d[3] * (rate * rate);
        place.acceleration = -(free0.dot(d[1]) + moved.rate.dot(turned) * 2.0 + d[0].dot(free1)) / slope();
        moved.acceleration = free0 + d[1] * place.acceleration;
    }

    Number slope() const { return d[1].dot(d[1]) + d[0].dot(d[2]); }
    const Weights<Number>& weights() const { return weights_; }

    struct {
        Number value, rate, acceleration;
    } place;
    std::array<Vector<Number>, derivative_count> d;  // by s
    std::array<Vector<Number>, 3> v;                 // of the motion at a fixed s, by s
    struct {
        Vector<Number> rate, acceleration;
    } moved;  // of d, in all

  private:
    static double scalar(double number) { return number; }
    template <class Derivatives>
    static double scalar(const Eigen::AutoDiffScalar<Derivatives>& number) {
        return number.value();
    }

    void set_place(const Points& points, const Number& s) {
        weights_ = compute_weights(points, s);
        for (int order = 0; order < derivative_count; ++order)
            d[order] = sum_up(weights_[order], motions_.values, count_);
    }

    const LineMotions<Number>& motions_;
    int count_;
    Weights<Number> weights_;
};

template <class Number>
Vector<Number> lift(const Eigen::Vector3d& vector) {
    return vector.template cast<Number>();
}

// Unknowns from `first` on.
template <int Unknowns>
Vector<Dual<Unknowns>> vary(const Eigen::Vector3d& vector, int first) {
    Vector<Dual<Unknowns>> varied;
    for (int k = 0; k < 3; ++k) varied[k] = Dual<Unknowns>(vector[k], Unknowns, first + k);
    return varied;
}

template <class Number>
LineMotions<Number> lift_motions(const Points& points) {
    LineMotions<Number> motions;
    for (int i = 0; i < points.count(); ++i) {
        motions.values[i] = lift<Number>(points.jets[i].value);
        motions.rates[i] = lift<Number>(points.jets[i].rate);
        motions.accelerations[i] = lift<Number>(points.jets[i].acceleration);
    }
    return motions;
}

// ∂s/∂(position of point i), (J28).
template <class Number>
Vector<Number> compute_place_gradient(const Sliding<Number>& sliding, int i) {
    const auto& weights = sliding.weights();
    const Number by_tangent = -weights[0][i] / sliding.slope();
    const Number by_distance = -weights[1][i] / sliding.slope();
    return sliding.d[1] * by_tangent + sliding.d[0] * by_distance;
}

}  // namespace

SleeveMotion::Functions SleeveMotion::compute_jets(ConstraintLevel level) const {
    const LineMotions<double> motions = lift_motions<double>(*points_);
    Sliding<double> sliding(*points_, s_, motions);
    const bool has_rates = level != ConstraintLevel::position;
    const bool has_accelerations = level == ConstraintLevel::acceleration;
    if (has_rates) sliding.set_rates();
    if (has_accelerations) sliding.set_accelerations();
    Functions functions{};
    for (int k = 0; k < 2; ++k) {
        const auto b = across_->col(k);
        functions[k].value = b.dot(sliding.d[0]);
        if (has_rates) functions[k].rate = b.dot(sliding.moved.rate);
        if (has_accelerations) functions[k].acceleration = b.dot(sliding.moved.acceleration);
    }
    functions[slide].value = sliding.place.value;
    if (has_rates) functions[slide].rate = sliding.place.rate;
    if (has_accelerations) functions[slide].acceleration = sliding.place.acceleration;
    return functions;
}

SleeveMotion::Gradient SleeveMotion::compute_gradient() const {
    const LineMotions<double> motions = lift_motions<double>(*points_);
    const Sliding<double> sliding(*points_, s_, motions);
    Gradient gradient(function_count, points_->unknowns());
    for (int i = 0; i < points_->count(); ++i) {
        const Eigen::Vector3d of_place = compute_place_gradient(sliding, i);
        gradient.block<1, 3>(slide, 3 * i) = of_place.transpose();
        for (int k = 0; k < 2; ++k) {
            const auto b = across_->col(k);
            gradient.block<1, 3>(k, 3 * i) =
                (sliding.weights()[0][i] * b + b.dot(sliding.d[1]) * of_place).transpose();
        }
    }
    return gradient;
}

SleeveMotion::Hessian SleeveMotion::compute_hessian(const Weights& weights) const {
    using Number = Dual<most_unknowns>;
    LineMotions<Number> motions = lift_motions<Number>(*points_);
    for (int i = 0; i < points_->count(); ++i)
        motions.values[i] = vary<most_unknowns>(points_->jets[i].value, 3 * i);
    const Sliding<Number> sliding(*points_, s_, motions);
    const Vector<Number> force = lift<Number>(*across_ * weights.head<2>());
    const Number on_place = force.dot(sliding.d[1]) + weights[slide];
    const int unknowns = points_->unknowns();
    Hessian hessian(unknowns, unknowns);
    for (int i = 0; i < points_->count(); ++i) {
        const Vector<Number> on_point =
            force * sliding.weights()[0][i] + compute_place_gradient(sliding, i) * on_place;
        for (int k = 0; k < 3; ++k)
            hessian.row(3 * i + k) = on_point[k].derivatives().head(unknowns).transpose();
    }
    return hessian;
}

SleeveMotion::Change SleeveMotion::compute_change(ConstraintLevel level) const {
    constexpr int all = 3 * most_unknowns;
    using Number = Dual<all>;
    const int unknowns = points_->unknowns();
    LineMotions<Number> motions;
    for (int i = 0; i < points_->count(); ++i) {
        motions.values[i] = vary<all>(points_->jets[i].value, 3 * i);
        motions.rates[i] = vary<all>(points_->jets[i].rate, unknowns + 3 * i);
        motions.accelerations[i] = vary<all>(points_->jets[i].acceleration, 2 * unknowns + 3 * i);
    }
    Sliding<Number> sliding(*points_, s_, motions);
    sliding.set_rates();
    const bool is_of_rates = level == ConstraintLevel::velocity;
    if (!is_of_rates) sliding.set_accelerations();
    const Vector<Number>& moved = is_of_rates ? sliding.moved.rate : sliding.moved.acceleration;
    Change change(function_count, 3 * unknowns);
    for (int k = 0; k < 2; ++k) {
        const Number along = lift<Number>(across_->col(k)).dot(moved);
        change.row(k) = along.derivatives().head(3 * unknowns).transpose();
    }
    const Number& place = is_of_rates ? sliding.place.rate : sliding.place.acceleration;
    change.row(slide) = place.derivatives().head(3 * unknowns).transpose();
    return change;
}

PlaceMiss compute_place_miss(const SleeveMotion::Points& points, double s) {
    const Weights<double> weights = compute_weights(points, s);
    const LineMotions<double> motions = lift_motions<double>(points);
    std::array<Eigen::Vector3d, 3> d;
    for (int order = 0; order < 3; ++order) d[order] = sum_up(weights[order], motions.values, points.count());
    return {d[0].dot(d[1]), d[1].dot(d[1]) + d[0].dot(d[2])};
}

Eigen::Vector3d compute_tangent(const SleeveMotion::Points& points, double s) {
    return -sum_up(compute_weights(points, s)[1], lift_motions<double>(points).values, points.count());
}

}  // namespace gxrod
