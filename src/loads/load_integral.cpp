#include "loads/load_integral.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "model/evaluation_error.hpp"
#include "numerics/kronrod_rule.hpp"

namespace gxrod {

namespace {

// Of the integral of the load's size over an element: of loads that are integrated once, and of those that
// are integrated again for each time.
constexpr double fixed_tolerance = 1e-8;
constexpr double varying_tolerance = 1e-6;
// Points of one element, after which a load counts as not integrable.
constexpr int most_points = 20000;
// Breaks nearer to each other than this part of an element, and to its ends, are one.
constexpr double shortest_piece = 1e-12;
// Points of Gauss of the rule where an element's own is not enough.
constexpr std::size_t fine_points = 7;
constexpr std::size_t most_moments = most_element_nodes * (most_element_nodes + 1) / 2;

// What the load and an element give at a point.
struct LoadSample {
    Vec6 q;         // of the load
    double weight;  // ds/dξ of the line through the nodes
    std::array<double, most_element_nodes> shape;
};

// Of the size of forces and of moments.
struct Sizes {
    double force = 0.0;
    double moment = 0.0;

    Sizes& operator+=(const Sizes& other) {
        force += other.force;
        moment += other.moment;
        return *this;
    }
};

Sizes sizes_of(const Vec6& value) { return {value.head<3>().norm(), value.tail<3>().norm()}; }

// A part of an element, integrated by one rule.
struct Piece {
    double from;
    double to;
    std::size_t gauss_points;
    std::array<Vec6, most_moments> moments;
    Sizes size;   // ∫ |q| ds
    Sizes error;  // of the moments, at most
};

bool varies_in_time(const DistributedLoad& load) {
    const auto varies = [](const LineFunction& component) {
        return component.form().in_time == InTime::varying;
    };
    return std::any_of(load.force.begin(), load.force.end(), varies) ||
           std::any_of(load.moment.begin(), load.moment.end(), varies);
}

class ElementIntegral {
  public:
    ElementIntegral(const LoadedElement& element, const IntegralPlan& plan)
        : element_(element),
          plan_(plan),
          count_(moment_count(*element.load, element.nodes.size())),
          varies_(varies_in_time(*element.load)) {}

    void run(std::span<Vec6> moments) {
        cut();
        while (!is_exact_enough()) {
            if (points_ > most_points) throw_no_integral();
            refine_worst();
        }
        for (std::size_t k = 0; k < count_; ++k) {
            moments[k].setZero();
            for (const Piece& piece : pieces_) moments[k] += piece.moments[k];
        }
    }

  private:
    std::size_t own_points() const { return element_.nodes.size(); }

    double arc_length_at(double xi) const {
        const ShapeValues shapes = element_.shapes(xi);
        double s = 0.0;
        for (std::size_t i = 0; i < own_points(); ++i) s += shapes.value[i] * element_.arc_lengths[i];
        return s;
    }

    // ξ of an arc length within the element.
    double find_xi(double arc_length) const {
        double from = -1.0;
        double to = 1.0;
        for (double middle = 0.0; middle > from && middle < to; middle = 0.5 * (from + to)) {
            (arc_length_at(middle) < arc_length ? from : to) = middle;
        }
        return to;
    }

    void cut() {
        std::vector<double> cuts;
        for (int i = 1; i < plan_.pieces; ++i) cuts.push_back(-1.0 + 2.0 * i / plan_.pieces);
        const double first = element_.arc_lengths.front();
        const double last = element_.arc_lengths.back();
        const auto begin = std::upper_bound(plan_.breaks.begin(), plan_.breaks.end(), first);
        for (auto at = begin; at != plan_.breaks.end() && *at < last; ++at) cuts.push_back(find_xi(*at));
        std::sort(cuts.begin(), cuts.end());
        cuts.push_back(1.0);
        double from = -1.0;
        for (const double to : cuts) {
            const bool is_last = to == 1.0;
            if (to - from < shortest_piece && !is_last) continue;
            if (!is_last && 1.0 - to < shortest_piece) continue;
            pieces_.push_back(integrate(from, to, own_points()));
            from = to;
        }
    }

    LoadSample sample(double xi) const {
        const ShapeValues shapes = element_.shapes(xi);
        LoadSample at{Vec6::Zero(), 0.0, shapes.value};
        double arc_length = 0.0;
        Vec3 tangent = Vec3::Zero();
        for (std::size_t i = 0; i < own_points(); ++i) {
            arc_length += shapes.value[i] * element_.arc_lengths[i];
            tangent += shapes.slope[i] * element_.positions[i];
        }
        at.weight = tangent.norm();
        at.q = compute_load_per_length(*element_.load, plan_.time, arc_length);
        return at;
    }

    double share(const LoadSample& at, std::size_t i, std::size_t j) const {
        return is_turned() ? at.shape[i] * at.shape[j] : at.shape[i];
    }
    bool is_turned() const { return is_interpolated(*element_.load); }

    // Adds the point to the integral and to its difference to Gauss' own.
    void add(const LoadSample& at,
             double half,
             const KronrodPoint& point,
             Piece& piece,
             std::array<Vec6, most_moments>& difference) const {
        const double weight = half * at.weight * point.weight;
        const double excess = half * at.weight * (point.weight - point.gauss_weight);
        std::size_t k = 0;
        for (std::size_t i = 0; i < own_points(); ++i) {
            const std::size_t first = is_turned() ? 0 : i;
            for (std::size_t j = first; j <= i; ++j, ++k) {
                const double part = share(at, i, j);
                piece.moments[k] += (weight * part) * at.q;
                difference[k] += (excess * part) * at.q;
            }
        }
        const Sizes size = sizes_of(at.q);
        piece.size += {weight * size.force, weight * size.moment};
    }

    Piece integrate(double from, double to, std::size_t gauss_points) {
        Piece piece{from, to, gauss_points, {}, {}, {}};
        std::array<Vec6, most_moments> difference;
        for (std::size_t k = 0; k < count_; ++k) {
            piece.moments[k].setZero();
            difference[k].setZero();
        }
        const double half = 0.5 * (to - from);
        const double middle = 0.5 * (to + from);
        for (const KronrodPoint& point : find_kronrod_rule(gauss_points)) {
            add(sample(middle + half * point.xi), half, point, piece, difference);
            if (point.xi != 0.0) add(sample(middle - half * point.xi), half, point, piece, difference);
        }
        points_ += 2 * static_cast<int>(gauss_points) + 1;
        for (std::size_t k = 0; k < count_; ++k) {
            const Sizes own = sizes_of(difference[k]);
            piece.error = {std::max(piece.error.force, own.force), std::max(piece.error.moment, own.moment)};
        }
        if (varies_ && gauss_points != fine_points) {
            piece.error.force = sharpen(piece.error.force, piece.size.force);
            piece.error.moment = sharpen(piece.error.moment, piece.size.moment);
        }
        return piece;
    }

    // The difference of the two integrals is the error of Gauss' one, of the order 2n of the piece's length.
    // Of smooth loads, that of Kronrod's is of the order 3n + 2 for n even and 3n + 3 for n odd: its square
    // for n = 2 and 3, its power 7/4 at least for n = 4 and 5.
    double sharpen(double error, double size) const {
        if (!(size > 0.0 && error < size)) return error;
        constexpr std::size_t most_squared = 3;
        const double ratio = error / size;
        return error * (own_points() <= most_squared ? ratio : std::pow(ratio, 0.75));
    }

    bool is_exact_enough() {
        size_ = error_ = {};
        for (const Piece& piece : pieces_) {
            size_ += piece.size;
            error_ += piece.error;
        }
        if (!std::isfinite(size_.force + size_.moment)) throw_no_integral();
        const double tolerance = varies_ ? varying_tolerance : fixed_tolerance;
        return error_.force <= tolerance * size_.force && error_.moment <= tolerance * size_.moment;
    }

    // Of a size, a part of the element's; 0 if both are.
    static double part_of(double error, double size) { return error > 0.0 ? error / size : 0.0; }
    double badness(const Piece& piece) const {
        return std::max(part_of(piece.error.force, size_.force), part_of(piece.error.moment, size_.moment));
    }

    void refine_worst() {
        const auto worst =
            std::max_element(pieces_.begin(), pieces_.end(), [this](const Piece& a, const Piece& b) {
                return badness(a) < badness(b);
            });
        if (worst->gauss_points != fine_points) {
            *worst = integrate(worst->from, worst->to, fine_points);
            return;
        }
        const double from = worst->from;
        const double to = worst->to;
        const double middle = 0.5 * (from + to);
        if (middle <= from || middle >= to) throw_no_integral();
        *worst = integrate(from, middle, fine_points);
        pieces_.push_back(integrate(middle, to, fine_points));
    }

    [[noreturn]] void throw_no_integral() const {
        const double error =
            std::max(part_of(error_.force, size_.force), part_of(error_.moment, size_.moment));
        throw EvaluationError(fmt::format(
            "{}: the load per length has no integral that can be found from s = {:.6g} to s = {:.6g} "
            "at t = {:.6g}: after {} points it is still uncertain by {:.2g} of the load's size; "
            "expected a load that is bounded and does not turn to and fro so often",
            element_.load->key,
            element_.arc_lengths.front(),
            element_.arc_lengths.back(),
            plan_.time,
            points_,
            error));
    }

    const LoadedElement& element_;
    const IntegralPlan& plan_;
    std::size_t count_;
    bool varies_;
    std::vector<Piece> pieces_;
    Sizes size_, error_;
    int points_ = 0;
};

}  // namespace

std::size_t moment_count(const DistributedLoad& load, std::size_t nodes) {
    return is_interpolated(load) ? nodes * (nodes + 1) / 2 : nodes;
}

Vec6 compute_load_per_length(const DistributedLoad& load, double time, double arc_length) {
    Vec6 value;
    for (int i = 0; i < 3; ++i) {
        value[i] = load.force[i](time, arc_length);
        value[i + 3] = load.moment[i](time, arc_length);
    }
    return value;
}

void integrate_load(const LoadedElement& element, const IntegralPlan& plan, std::span<Vec6> moments) {
    ElementIntegral(element, plan).run(moments);
}

void integrate_even_load(const LoadedElement& element, const Vec6& q, std::span<Vec6> moments) {
    const std::size_t nodes = element.nodes.size();
    const bool is_turned = is_interpolated(*element.load);
    std::array<double, most_moments> lengths{};
    const auto add_point = [&](double xi, double weight) {
        const ShapeValues shapes = element.shapes(xi);
        Vec3 tangent = Vec3::Zero();
        for (std::size_t i = 0; i < nodes; ++i) tangent += shapes.slope[i] * element.positions[i];
        const double length = weight * tangent.norm();
        std::size_t k = 0;
        for (std::size_t i = 0; i < nodes; ++i) {
            for (std::size_t j = is_turned ? 0 : i; j <= i; ++j, ++k) {
                lengths[k] += length * shapes.value[i] * (is_turned ? shapes.value[j] : 1.0);
            }
        }
    };
    for (const KronrodPoint& point : find_kronrod_rule(nodes)) {
        if (point.gauss_weight == 0.0) continue;
        add_point(point.xi, point.gauss_weight);
        if (point.xi != 0.0) add_point(-point.xi, point.gauss_weight);
    }
    for (std::size_t k = 0; k < moments.size(); ++k) moments[k] = lengths[k] * q;
}

}  // namespace gxrod
