#include "linear/eigen/smallest_factors.hpp"

#include "linear/eigen/random_pencil.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// K + λ S singular at these λ; infinite ones are what S leaves alone.
SmallestFactors find_factors(const Eigen::VectorXd& factors, int count) {
    Eigen::VectorXd thetas = -factors.array().inverse();
    const RandomPencil pencil = make_pencil(thetas);
    return find_smallest_factors(pencil.pattern, pencil.M, pencil.K, count);
}

Eigen::VectorXd make_factors(const std::vector<double>& smallest, int size) {
    Eigen::VectorXd factors = Eigen::VectorXd::LinSpaced(size, 100.0, 200.0);
    for (std::size_t i = 0; i < smallest.size(); ++i) factors[static_cast<Eigen::Index>(i)] = smallest[i];
    return factors;
}

void check_factors(const SmallestFactors& found, const std::vector<double>& expected) {
    REQUIRE(found.values.size() == static_cast<Eigen::Index>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(found.values[static_cast<Eigen::Index>(i)] == Approx(expected[i]).epsilon(1e-11));
    CHECK(found.complete());
    CHECK(found.residuals.maxCoeff() < 1e-8);
}

}  // namespace

TEST_CASE("the smallest factors of either sign, copies too", "[linear]") {
    const SmallestFactors found =
        find_factors(make_factors({2.0, -2.5, 3.0, 3.0, 3.0, -4.0, 7.0, 9.0}, 60), 5);
    check_factors(found, {2.0, -2.5, 3.0, 3.0, 3.0, -4.0, 7.0});
    CHECK(found.counted_positive == 5);
    CHECK(found.counted_negative == 2);
}

TEST_CASE("positive factors are sought behind many negative ones", "[linear]") {
    std::vector<double> smallest;
    for (int i = 0; i < 12; ++i) smallest.push_back(-1.0 - 0.1 * i);
    std::vector<double> all = smallest;
    all.push_back(5.0);
    check_factors(find_factors(make_factors(all, 60), 1), all);
}

TEST_CASE("loads that only stiffen have negative factors alone", "[linear]") {
    const Eigen::VectorXd factors = -Eigen::VectorXd::LinSpaced(8, 1.0, 8.0);
    const SmallestFactors found = find_factors(factors, 2);
    CHECK((found.values.array() < 0.0).all());
    REQUIRE(found.values.size() >= 2);
    CHECK(found.values[0] == Approx(-1.0));
    CHECK(found.complete());
    CHECK(found.counted_positive == 0);
}

TEST_CASE("what loads leave alone has no factor", "[linear]") {
    Eigen::VectorXd factors = Eigen::VectorXd::Constant(40, std::numeric_limits<double>::infinity());
    factors.head(3) << 1.0, -2.0, 4.0;
    check_factors(find_factors(factors, 5), {1.0, -2.0, 4.0});
}

TEST_CASE("factors of an unstable state are not sought", "[linear]") {
    const RandomPencil pencil = make_pencil(Eigen::VectorXd::LinSpaced(20, -0.5, 3.0));
    CHECK_FALSE(find_smallest_factors(pencil.pattern, pencil.K, pencil.M, 2).is_definite);
}
