#include "constraints/joints/sleeve_motion.hpp"
#include "tools/catch.hpp"

#include <functional>
#include <random>

using namespace gxrod;

namespace {

using Points = SleeveMotion::Points;
using Across = Eigen::Matrix<double, 3, 2>;

// A bent line that moves and a point beside it, not on it: all terms count.
struct Sample {
    SmoothLine line{{0.0, 0.4, 1.1, 1.5, 2.0, 2.7, 3.0}};
    Points points;
    Across across;
    double guess = 1.7;

    Sample() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> number(-1.0, 1.0);
        const auto vector = [&] { return Eigen::Vector3d(number(random), number(random), number(random)); };
        points.piece = &line.pieces()[static_cast<std::size_t>(line.find_piece(guess))];
        for (int i = 0; i < points.count(); ++i) {
            const double s = 0.5 * (i + points.piece->first);
            const Eigen::Vector3d straight =
                i == 0 ? Eigen::Vector3d(1.6, 0.1, -0.1) : Eigen::Vector3d(s - 0.5, 0.0, 0.0);
            points.jets[i] = {straight + 0.1 * vector(), vector(), vector()};
        }
        across << 0.1, 0.0, 1.0, 0.2, 0.0, 0.9;
    }

    // The points after the time t.
    Points moved(double t) const {
        Points later = points;
        for (VectorJet& jet : later.jets) {
            jet.value += t * jet.rate + 0.5 * t * t * jet.acceleration;
            jet.rate += t * jet.acceleration;
        }
        return later;
    }

    double place_of(const Points& at) const {
        double s = guess;
        for (int k = 0; k < 60; ++k) {
            const PlaceMiss miss = compute_place_miss(at, s);
            s -= miss.value / miss.slope;
        }
        return s;
    }
    SleeveMotion motion(const Points& at) const { return {at, place_of(at), across}; }
};

double& unknown(Points& points, int index) {
    return points.jets[static_cast<std::size_t>(index / 3)].value[index % 3];
}
double& unknown_rate(Points& points, int index) {
    return points.jets[static_cast<std::size_t>(index / 3)].rate[index % 3];
}
double& unknown_acceleration(Points& points, int index) {
    return points.jets[static_cast<std::size_t>(index / 3)].acceleration[index % 3];
}

// Differences of order 4.
double differentiate(const std::function<double(double)>& f, double h) {
    return (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h);
}

}  // namespace

TEST_CASE("The nearest place of a line is where the point is across it", "[constraints][joints][sleeve]") {
    const Sample sample;
    const double s = sample.place_of(sample.points);
    const Eigen::Vector3d tangent = compute_tangent(sample.points, s);
    const Across& b = sample.across;
    // d of which b₁ · d, b₂ · d and d · r' = 0 are known.
    Eigen::Matrix3d rows;
    rows << b.transpose(), tangent.transpose();
    const auto jets = sample.motion(sample.points).compute_jets(ConstraintLevel::position);
    const Eigen::Vector3d d = rows.inverse() * Eigen::Vector3d(jets[0].value, jets[1].value, 0.0);
    // Nothing near is nearer.
    const auto distance = [&](double at) {
        Eigen::Vector3d r = Eigen::Vector3d::Zero();
        const auto weights = sample.points.piece->compute_weights<1>(at)[0];
        for (std::size_t i = 0; i < SmoothLine::most_points; ++i)
            r += weights[i] * sample.points.jets[1 + i].value;
        return (sample.points.jets[0].value - r).norm();
    };
    CHECK(distance(s) == Approx(d.norm()).epsilon(1e-12));
    CHECK(distance(s) < distance(s + 1e-3));
    CHECK(distance(s) < distance(s - 1e-3));
    CHECK(d.norm() > 0.05);
}

TEST_CASE("Rates of what a sleeve holds and leaves are derivatives by time",
          "[constraints][joints][sleeve]") {
    const Sample sample;
    const auto jets = sample.motion(sample.points).compute_jets(ConstraintLevel::acceleration);
    for (std::size_t k = 0; k < 3; ++k) {
        const double rate = differentiate(
            [&](double t) {
                return sample.motion(sample.moved(t)).compute_jets(ConstraintLevel::position)[k].value;
            },
            1e-3);
        const double acceleration = differentiate(
            [&](double t) {
                return sample.motion(sample.moved(t)).compute_jets(ConstraintLevel::velocity)[k].rate;
            },
            1e-3);
        CHECK(jets[k].rate == Approx(rate).epsilon(1e-9));
        CHECK(jets[k].acceleration == Approx(acceleration).epsilon(1e-8));
    }
}

TEST_CASE("Gradients and second derivatives of a sleeve are those of its functions",
          "[constraints][joints][sleeve]") {
    const Sample sample;
    const SleeveMotion motion = sample.motion(sample.points);
    const SleeveMotion::Gradient gradient = motion.compute_gradient();
    const SleeveMotion::Weights weights(0.3, -1.2, 0.7);
    const SleeveMotion::Hessian hessian = motion.compute_hessian(weights);
    CHECK((hessian - hessian.transpose()).norm() < 1e-12 * hessian.norm());
    for (int j = 0; j < sample.points.unknowns(); ++j) {
        const auto vary = [&](double h) {
            Points varied = sample.points;
            unknown(varied, j) += h;
            return varied;
        };
        for (int k = 0; k < 3; ++k) {
            const double by_j = differentiate(
                [&](double h) {
                    return sample.motion(vary(h))
                        .compute_jets(ConstraintLevel::position)[static_cast<std::size_t>(k)]
                        .value;
                },
                1e-3);
            CHECK(gradient(k, j) == Approx(by_j).epsilon(1e-8).margin(1e-10));
        }
        for (int i = 0; i < sample.points.unknowns(); ++i) {
            const double by_both = differentiate(
                [&](double h) { return sample.motion(vary(h)).compute_gradient().col(i).dot(weights); },
                1e-3);
            CHECK(hessian(i, j) == Approx(by_both).epsilon(1e-7).margin(1e-9));
        }
    }
}

TEST_CASE("Changes of a sleeve's rates are those of its points' positions and rates",
          "[constraints][joints][sleeve]") {
    const Sample sample;
    const int unknowns = sample.points.unknowns();
    const bool is_of_rates = GENERATE(false, true);
    const ConstraintLevel level = is_of_rates ? ConstraintLevel::velocity : ConstraintLevel::acceleration;
    const SleeveMotion::Change change = sample.motion(sample.points).compute_change(level);
    for (int j = 0; j < 3 * unknowns; ++j) {
        const auto by_j = [&](std::size_t k) {
            return differentiate(
                [&](double h) {
                    Points varied = sample.points;
                    const int own = j % unknowns;
                    (j < unknowns       ? unknown(varied, own)
                     : j < 2 * unknowns ? unknown_rate(varied, own)
                                        : unknown_acceleration(varied, own)) += h;
                    const ScalarJet jet = sample.motion(varied).compute_jets(level)[k];
                    return is_of_rates ? jet.rate : jet.acceleration;
                },
                1e-3);
        };
        for (std::size_t k = 0; k < 3; ++k)
            CHECK(change(static_cast<int>(k), j) == Approx(by_j(k)).epsilon(1e-7).margin(1e-8));
    }
}
