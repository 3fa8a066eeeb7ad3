#include "laws/syrope_law.hpp"

#include <algorithm>
#include <cmath>

// Numbers of equations: docs/theory/laws.md.
namespace gxrod {
namespace {

// Of an implicit scheme of two stages and second order, which damps what is fast: its diagonal.
const double stage_weight = 1.0 - std::sqrt(0.5);
// From here on a step is as long as any: the dashpot has come to rest.
constexpr double at_rest = 1e14;
constexpr int most_stage_iterations = 200;
constexpr double strain_round_off = 4e-16;

// The working curve over its length, from (0, 0) to (1, 1): value, slope and integral. (L37)
struct ShapeValue {
    double value, slope, integral;
};

ShapeValue value_of_shape(const SyropeRope& rope, double x) {
    const double k = rope.k2;
    switch (rope.shape) {
        case WorkingShape::linear:
            break;
        case WorkingShape::quadratic:
            return {x * (k * x + 1.0 - k), 2.0 * k * x + 1.0 - k, x * x * (k * x / 3.0 + 0.5 * (1.0 - k))};
        case WorkingShape::exponential: {
            const double whole = std::expm1(k);
            return {
                std::expm1(k * x) / whole, k * std::exp(k * x) / whole, (std::expm1(k * x) / k - x) / whole};
        }
    }
    return {x, 1.0, 0.5 * x * x};
}

Mat6 without_stretch(Mat6 C) {
    C.row(0).setZero();
    C.col(0).setZero();
    return C;
}

double slack_of(const SyropeRope& rope, double largest) {
    const bool is_slope = rope.shape == WorkingShape::linear && rope.k1 >= 1.0;
    return is_slope ? largest - rope.original.at(largest).value / rope.k1 : rope.k1 * largest;
}

double stiffness_of(const SyropeRope& rope, double tension) {
    return rope.stiffness + rope.per_tension * std::max(tension, 0.0);
}

}  // namespace

SyropeLaw::SyropeLaw(const Mat6& C, SyropeRope rope) : others_(without_stretch(C)), rope_(std::move(rope)) {
    scale_ = 1.0 + find_slack(rope_.largest);
}

double SyropeLaw::find_slack(double largest) const { return slack_of(rope_, largest); }

double SyropeLaw::fast_stiffness(double tension) const { return stiffness_of(rope_, tension); }

// (L35)
double SyropeLaw::fast_strain(double tension) const {
    const double growth = rope_.per_tension / rope_.stiffness;
    if (tension <= 0.0 || growth == 0.0) return tension / rope_.stiffness;
    return std::log1p(growth * tension) / rope_.per_tension;
}

// (L36), (L37)
SyropeLaw::Point SyropeLaw::find_point(double at, double largest) const {
    const ShapeValue whole = value_of_shape(rope_, 1.0);
    if (at >= largest && at >= 0.0) {
        const auto [tension, slope, area] = rope_.original.at(at);
        return {tension, slope, tension * (at - find_slack(at)) * whole.integral};
    }
    const double slack = find_slack(largest), length = largest - slack;
    const double tension = rope_.original.at(largest).value;
    if (at >= slack) {
        const ShapeValue shape = value_of_shape(rope_, (at - slack) / length);
        return {tension * shape.value, tension * shape.slope / length, tension * length * shape.integral};
    }
    const double slope =
        length > 0.0 ? tension * value_of_shape(rope_, 0.0).slope / length : rope_.original.slope(0);
    const double beyond = at - slack;
    return {slope * beyond, slope, 0.5 * slope * beyond * beyond};
}

// The residual grows with the strain on the curves: Newton's method within bounds. (L38)
SyropeLaw::RopeStage SyropeLaw::solve_stage(
    double strain, double start, double weight, double from, double largest) const {
    const double q = weight / rope_.damping;
    const auto residual = [&](double at, Point& point, double& slope) {
        point = find_point(at, largest);
        const double K = fast_stiffness(point.tension);
        const double grown = point.tension > 0.0 ? rope_.per_tension * point.slope : 0.0;
        slope = 1.0 - point.slope / K + q * (K - grown * (strain - at));
        return at - fast_strain(point.tension) - start - q * K * (strain - at);
    };
    Point point{};
    double slope = 1.0;
    double low = std::min(from, strain), high = std::max(from, strain);
    double width = std::max(high - low, 1e-12);
    while (residual(low, point, slope) > 0.0) low -= width, width *= 2.0;
    while (residual(high, point, slope) < 0.0) high += width, width *= 2.0;
    RopeStage stage;
    stage.at = std::clamp(from, low, high);
    for (int i = 0; i < most_stage_iterations; ++i) {
        const double error = residual(stage.at, point, slope);
        if (error == 0.0) break;
        (error > 0.0 ? high : low) = stage.at;
        double next = stage.at - error / slope;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const double change = std::abs(next - stage.at);
        stage.at = next;
        if (std::min(change, high - low) <= strain_round_off * std::abs(next)) break;
    }
    residual(stage.at, point, slope);
    const double K = fast_stiffness(point.tension), gap = strain - stage.at;
    const double grown = point.tension > 0.0 ? rope_.per_tension * point.slope : 0.0;
    stage.rate = K * gap / rope_.damping;
    // By the strain of the stage; respond() adds what comes from the start.
    stage.by_strain = 1.0 / slope;
    stage.rate_by_strain = (grown * gap - K) / rope_.damping;
    const double slow_slope = point.slope / (1.0 - point.slope / K);
    stage.lost = rope_.damping * stage.rate * stage.rate;
    if (point.tension > 0.0) stage.lost -= 0.5 * rope_.per_tension * slow_slope * gap * gap * stage.rate;
    return stage;
}

// (L36) to (L39)
SectionResponse SyropeLaw::respond(const Vec6& strain,
                                   std::span<const double> memory,
                                   double elapsed,
                                   std::span<double> after) const {
    const double first_slack = find_slack(rope_.largest);
    const double before = scale_ * memory[0] + first_slack, now = scale_ * strain[0] + first_slack;
    const double from = memory[1] + first_slack, largest = memory[2] + rope_.largest;
    const double step = elapsed * fast_stiffness(0.0) / rope_.damping;
    double at = now, by_strain = 1.0, lost = 0.0;
    if (step < at_rest) {
        const double g = stage_weight, h = elapsed;
        const double start = from - fast_strain(find_point(from, largest).tension);
        const double middle = before + g * (now - before);
        const RopeStage one = solve_stage(middle, start, g * h, from, largest);
        const double K_one = fast_stiffness(find_point(one.at, largest).tension) / rope_.damping;
        const double one_by = one.by_strain * g * h * K_one * g;
        const double rate_by = K_one * g + one.rate_by_strain * one_by;
        const RopeStage two = solve_stage(now, start + (1.0 - g) * h * one.rate, g * h, one.at, largest);
        const double K_two = fast_stiffness(find_point(two.at, largest).tension) / rope_.damping;
        at = two.at;
        by_strain = two.by_strain * (g * h * K_two + (1.0 - g) * h * rate_by);
        lost = h * ((1.0 - g) * one.lost + g * two.lost);
    }
    const Point point = find_point(at, largest);
    const double K = fast_stiffness(point.tension), gap = now - at;
    const double grown = point.tension > 0.0 ? rope_.per_tension * point.slope : 0.0;
    const double force = point.tension + K * gap;
    if (at > largest) {
        const double area = rope_.original.at(at).integral - rope_.original.at(largest).integral;
        lost += area - (point.energy - find_point(largest, largest).energy);
    }
    SectionResponse response;
    response.resultants = others_ * strain;
    response.tangent = others_;
    response.stored = 0.5 * strain.dot(response.resultants);
    response.resultants[0] += force;
    response.tangent(0, 0) += scale_ * (K + (point.slope + grown * gap - K) * by_strain);
    response.stored += (point.energy + 0.5 * (force + point.tension) * gap) / scale_;
    response.dissipated = std::max(lost, 0.0) / scale_;
    if (!after.empty()) {
        after[0] = strain[0];
        after[1] = at - first_slack;
        after[2] = std::max(at, largest) - rope_.largest;
    }
    return response;
}

Mat6 SyropeLaw::elastic_tangent(const Vec6& strain, std::span<const double> memory) const {
    const double first_slack = find_slack(rope_.largest);
    const double at = scale_ * strain[0] + first_slack;
    const double largest = std::max(memory[2] + rope_.largest, at);
    const double slack = find_slack(largest);
    Mat6 tangent = others_;
    if (at < largest || at <= 0.0)
        tangent(0, 0) = scale_ * find_point(at, largest).slope;
    else
        tangent(0, 0) =
            scale_ * rope_.original.at(largest).value * value_of_shape(rope_, 1.0).slope / (largest - slack);
    return tangent;
}

bool SyropeLaw::is_at_limit(const Vec6& strain, std::span<const double> memory) const {
    constexpr double near = 1e-9;
    const double at = scale_ * strain[0] + find_slack(rope_.largest);
    return at > 0.0 && at >= (memory[2] + rope_.largest) * (1.0 - near);
}

std::optional<SteepCurve> find_steep_curve(const SyropeRope& rope) {
    constexpr int parts = 200;
    const auto& points = rope.original.points();
    for (std::size_t i = 0; i < rope.original.piece_count(); ++i) {
        const auto& [at, tension] = points[i];
        if (at >= rope.largest && rope.original.slope(i) >= stiffness_of(rope, tension))
            return SteepCurve{at, rope.original.slope(i), stiffness_of(rope, tension)};
    }
    constexpr double least = 1e-3;  // of the first piece
    const double from = std::max(rope.largest, least * points[1].first);
    const double to = std::max(2.0 * points.back().first, from);  // beyond it ropes are broken
    for (int i = 0; i <= parts; ++i) {
        const double largest = from + (to - from) * i / parts;
        const double tension = rope.original.at(largest).value;
        const double length = largest - slack_of(rope, largest);
        for (const double x : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const ShapeValue shape = value_of_shape(rope, x);
            const double slope = tension * shape.slope / length;
            const double stiffness = stiffness_of(rope, tension * shape.value);
            if (!(length > 0.0 && length <= largest && slope < stiffness))
                return SteepCurve{largest, slope, stiffness};
        }
    }
    return std::nullopt;
}

}  // namespace gxrod
