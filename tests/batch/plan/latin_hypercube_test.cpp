#include "batch/plan/latin_hypercube.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// Mean and deviation of a distribution, by the midpoint rule over probabilities.
struct Moments {
    double mean = 0.0;
    double deviation = 0.0;
};

Moments moments_of(const Spread& spread) {
    constexpr int count = 200'000;
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < count; ++i) {
        const double value = quantile(spread, (i + 0.5) / count);
        sum += value;
        squares += value * value;
    }
    const double mean = sum / count;
    return {mean, std::sqrt(squares / count - mean * mean)};
}

}  // namespace

TEST_CASE("A Latin hypercube has one sample in each of the equally likely parts", "[batch]") {
    constexpr long count = 1000;
    std::vector<double> samples = draw_probabilities("parameters.EI", 1, count);
    CHECK_FALSE(std::is_sorted(samples.begin(), samples.end()));
    std::sort(samples.begin(), samples.end());
    for (long i = 0; i < count; ++i) {
        CHECK(std::floor(samples[static_cast<std::size_t>(i)] * count) == static_cast<double>(i));
    }
}

TEST_CASE("Samples depend on key, seed and count, and are the same on any machine", "[batch]") {
    const std::vector<double> samples = draw_probabilities("parameters.EI", 1, 5);
    CHECK(draw_probabilities("parameters.EI", 1, 5) == samples);
    CHECK(draw_probabilities("parameters.EI", 2, 5) != samples);
    CHECK(draw_probabilities("parameters.EI", 1ULL << 32, 5) != draw_probabilities("parameters.EI", 0, 5));
    CHECK(draw_probabilities("parameters.EJ", 1, 5) != samples);
    // By another implementation of seed_seq and mt19937_64; a change would make other batches of the same
    // plan.
    CHECK(samples == std::vector<double>{0.3004110196926539,
                                         0.05794687595459991,
                                         0.8842909889148574,
                                         0.6786981796551128,
                                         0.5135743292341485});
}

TEST_CASE("Samples of two keys are not correlated", "[batch]") {
    constexpr long count = 4000;
    const std::vector<double> a = draw_probabilities("a", 1, count);
    const std::vector<double> b = draw_probabilities("b", 1, count);
    double product = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) product += (a[i] - 0.5) * (b[i] - 0.5);
    // Of independent samples the correlation has the deviation 1/sqrt(count) = 0.016.
    CHECK(std::abs(product / count * 12.0) < 0.06);
}

TEST_CASE("Quantiles are those of the distributions", "[batch]") {
    const Spread uniform{.kind = Spread::Kind::uniform, .from = 2.0, .to = 6.0};
    CHECK(quantile(uniform, 0.25) == 3.0);
    const Spread normal{.kind = Spread::Kind::normal, .mean = 10.0, .deviation = 2.0};
    // Tables of the normal distribution.
    CHECK(quantile(normal, 0.5) == Approx(10.0).epsilon(1e-15));
    CHECK(quantile(normal, 0.975) == Approx(10.0 + 2.0 * 1.959963984540054).epsilon(1e-14));
    CHECK(quantile(normal, 0.001) == Approx(10.0 - 2.0 * 3.090232306167813).epsilon(1e-14));
    const Spread lognormal{.kind = Spread::Kind::lognormal, .mean = 3.0, .deviation = 1.5};
    // The median of exp(N(m, s^2)) is exp(m), its mean exp(m + s^2/2).
    CHECK(quantile(lognormal, 0.5) == Approx(3.0 / std::sqrt(1.25)).epsilon(1e-14));
}

TEST_CASE("Mean and deviation are those of the values", "[batch]") {
    for (const Spread::Kind kind : {Spread::Kind::normal, Spread::Kind::lognormal}) {
        const Moments moments = moments_of({.kind = kind, .mean = 3.0, .deviation = 0.5});
        CHECK(moments.mean == Approx(3.0).epsilon(1e-4));
        CHECK(moments.deviation == Approx(0.5).epsilon(1e-3));
    }
    const Moments uniform = moments_of({.kind = Spread::Kind::uniform, .from = 1.0, .to = 2.0});
    CHECK(uniform.mean == Approx(1.5).epsilon(1e-9));
    CHECK(uniform.deviation == Approx(1.0 / std::sqrt(12.0)).epsilon(1e-6));
}

TEST_CASE("A truncated distribution keeps within its limits, the rest scaled up", "[batch]") {
    const Spread spread{.kind = Spread::Kind::normal, .from = 0.0, .to = 2.0, .mean = 0.0, .deviation = 1.0};
    CHECK(quantile(spread, 1e-12) >= 0.0);
    CHECK(quantile(spread, 1.0 - 1e-12) <= 2.0);
    // P(0 < x < m) = half of P(0 < x < 2) = 0.4772498680518208 / 2, m = 0.6395...: by the normal distribution
    // itself.
    const double middle = quantile(spread, 0.5);
    CHECK(0.5 * std::erf(middle / std::sqrt(2.0)) == Approx(0.4772498680518208 / 2.0).epsilon(1e-13));
    // The mean of the half normal distribution is sqrt(2/pi).
    const Moments half =
        moments_of({.kind = Spread::Kind::normal, .from = 0.0, .mean = 0.0, .deviation = 1.0});
    CHECK(half.mean == Approx(std::sqrt(2.0 / 3.14159265358979)).epsilon(1e-4));
    const Spread positive{
        .kind = Spread::Kind::lognormal, .from = -1.0, .to = 5.0, .mean = 1.0, .deviation = 2.0};
    CHECK(quantile(positive, 1e-9) > 0.0);
    CHECK(quantile(positive, 1.0 - 1e-9) <= 5.0);
}

TEST_CASE("What lies far out is drawn as exactly as what lies near", "[batch]") {
    const double infinity = std::numeric_limits<double>::infinity();
    const Spread upper{
        .kind = Spread::Kind::normal, .from = 9.0, .to = infinity, .mean = 0.0, .deviation = 1.0};
    const Spread lower{
        .kind = Spread::Kind::normal, .from = -infinity, .to = -9.0, .mean = 0.0, .deviation = 1.0};
    for (const double probability : {0.01, 0.5, 0.99}) {
        const double value = quantile(upper, probability);
        CHECK(std::erfc(value / std::sqrt(2.0)) / std::erfc(9.0 / std::sqrt(2.0)) ==
              Approx(1.0 - probability).epsilon(1e-10));
        CHECK(quantile(lower, 1.0 - probability) == Approx(-value).epsilon(1e-14));
    }
    CHECK(probability_within(upper) == Approx(1.1285884059538406e-19).epsilon(1e-12));
    CHECK(probability_within({.kind = Spread::Kind::normal, .from = 50.0}) == 0.0);
}

}  // namespace gxrod::test
