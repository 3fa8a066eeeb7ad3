#include "linear/eigen/lowest_pairs.hpp"

#include <cmath>
#include <limits>

#include "linear/eigen/eigenvalue_count.hpp"
#include "linear/eigen/random_pencil.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// 1, 2, 3, … but for the first ones.
Eigen::VectorXd make_eigenvalues(int size, std::vector<double> first) {
    Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(size, 1.0, size);
    std::sort(first.begin(), first.end());
    const auto count = static_cast<Eigen::Index>(first.size());
    values.array() += static_cast<double>(size);
    values.head(count) = Eigen::VectorXd::Map(first.data(), count);
    return values;
}

void check_pairs(const RandomPencil& pencil, const LowestPairs& pairs, const std::vector<double>& expected) {
    REQUIRE(pairs.values.size() == static_cast<Eigen::Index>(expected.size()));
    const double scale = pairs.limit - pairs.shift;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        INFO("eigenvalue " << i);
        CHECK(std::abs(pairs.values[static_cast<Eigen::Index>(i)] - expected[i]) < 1e-11 * scale);
        CHECK(pairs.residuals[static_cast<Eigen::Index>(i)] < 1e-8);
    }
    const Eigen::MatrixXd& X = pairs.vectors;
    CHECK((X.transpose() * pencil.dense_M * X - Eigen::MatrixXd::Identity(X.cols(), X.cols())).norm() < 1e-9);
    CHECK((pencil.dense_K * X - pencil.dense_M * X * pairs.values.asDiagonal()).norm() <=
          1e-8 * (pencil.dense_K - pairs.shift * pencil.dense_M).norm());
    CHECK(pairs.complete());
}

}  // namespace

TEST_CASE("the lowest eigenvalues are found, copies of multiple ones too", "[linear]") {
    const std::vector<double> first{1.0, 2.0, 2.0, 2.0, 2.0, 2.0, 3.0, 3.0};
    const RandomPencil pencil = make_pencil(make_eigenvalues(60, first));
    const auto pairs = find_lowest_pairs(pencil.pattern, pencil.K, pencil.M, 8);
    REQUIRE(pairs);
    check_pairs(pencil, *pairs, first);
    CHECK(pairs->counted == 8);
    CHECK_FALSE(pairs->is_all);
    // The limit lies beyond all copies, even where fewer are wanted.
    const auto fewer = find_lowest_pairs(pencil.pattern, pencil.K, pencil.M, 3);
    REQUIRE(fewer);
    CHECK(fewer->values.size() == 3);
    CHECK(fewer->counted == 6);
    CHECK(fewer->complete());
}

TEST_CASE("one start vector misses copies; pivots count them", "[linear]") {
    const std::vector<double> first{1.0, 2.0, 2.0, 2.0, 4.0, 7.0};
    // All others so far away that Lanczos' method has converged before round-off brings copies in.
    Eigen::VectorXd values = make_eigenvalues(60, first);
    values.tail(54) *= 1e4;
    const RandomPencil pencil = make_pencil(values);
    EigenvalueCount count(pencil.pattern);
    REQUIRE(count.factorize(pencil.K, 0.0, pencil.M) == 0);
    const Pencil inverse(
        pencil.pattern, pencil.M, count.values(), count.solver(), Pencil::InnerProduct::of_a);
    LanczosSettings settings;
    settings.wanted = 3;
    settings.block = 1;
    const EigenPairs plain = find_largest(inverse, settings);
    REQUIRE(plain.values.size() == 3);
    CHECK(1.0 / plain.values[1] == Approx(2.0));
    CHECK(1.0 / plain.values[2] == Approx(4.0));
    EigenvalueCount other(pencil.pattern);
    CHECK(other.count(pencil.K, -3.0, pencil.M) == 4);
    // Those that are known are not found again, and so the copies are.
    settings.wanted = 2;
    const EigenPairs more = find_largest(inverse, settings, plain.vectors);
    REQUIRE(more.values.size() == 2);
    CHECK(1.0 / more.values[0] == Approx(2.0));
    const auto pairs = find_lowest_pairs(pencil.pattern, pencil.K, pencil.M, 6);
    REQUIRE(pairs);
    check_pairs(pencil, *pairs, first);
}

TEST_CASE("rigid motions and negative eigenvalues come first", "[linear]") {
    for (const std::vector<double>& first : {std::vector<double>{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.5},
                                             {-30.0, -30.0, -2.0, 0.5, 1.0, 1.0, 3.0},
                                             {-2.0, 0.0, 0.0, 4.0}}) {
        const RandomPencil pencil = make_pencil(make_eigenvalues(50, first));
        const auto pairs =
            find_lowest_pairs(pencil.pattern, pencil.K, pencil.M, static_cast<int>(first.size()));
        REQUIRE(pairs);
        check_pairs(pencil, *pairs, first);
        CHECK(pairs->shift < first[0]);
    }
}

TEST_CASE("vibrations are found however fast they are next to rigid motions", "[linear]") {
    // Of few stiff elements, whose lowest vibration is as fast as K_ii/M_ii: rigid motions alone, and fewer
    // than are found at once.
    const std::vector<double> all{0.0, 0.0, 0.0, 2e8, 2e8, 4e8, 4e8, 5e8, 7e8, 7e8};
    const RandomPencil pencil = make_pencil(Eigen::VectorXd::Map(all.data(), 10));
    for (const int count : {2, 5, 10}) {
        const auto pairs = find_lowest_pairs(pencil.pattern, pencil.K, pencil.M, count);
        REQUIRE(pairs);
        check_pairs(pencil, *pairs, {all.begin(), all.begin() + count});
    }
    // Nothing is stiff.
    const RandomPencil loose = make_pencil(Eigen::VectorXd::Zero(6));
    const auto pairs = find_lowest_pairs(loose.pattern, loose.K, loose.M, 10);
    REQUIRE(pairs);
    check_pairs(loose, *pairs, std::vector<double>(6, 0.0));
    CHECK(pairs->is_all);
}

TEST_CASE("motions without inertia have no eigenvalue", "[linear]") {
    const double none = std::numeric_limits<double>::infinity();
    Eigen::VectorXd values = Eigen::VectorXd::Constant(40, none);
    values.head(6) << 1.0, 1.0, 5.0, 30.0, 100.0, 100.0;
    const RandomPencil pencil = make_pencil(values);
    const auto pairs = find_lowest_pairs(pencil.pattern, pencil.K, pencil.M, 10);
    REQUIRE(pairs);
    check_pairs(pencil, *pairs, {1.0, 1.0, 5.0, 30.0, 100.0, 100.0});
    CHECK(pairs->is_all);
    const std::vector<double> nothing(pencil.M.size(), 0.0);
    CHECK_FALSE(find_lowest_pairs(pencil.pattern, pencil.K, nothing, 3));
}

TEST_CASE("all eigenvalues below a bound are found", "[linear]") {
    const std::vector<double> first{1.0, 2.0, 2.0, 2.0, 5.0};
    const RandomPencil pencil = make_pencil(make_eigenvalues(80, first));
    const auto lower = find_lowest_pairs(pencil.pattern, pencil.K, pencil.M, 0, 3.0);
    REQUIRE(lower);
    check_pairs(pencil, *lower, {1.0, 2.0, 2.0, 2.0});
    // 1 … 5, then 86 … 160.
    const auto most = find_lowest_pairs(pencil.pattern, pencil.K, pencil.M, 0, 140.5);
    REQUIRE(most);
    CHECK(most->values.size() == 60);
    CHECK(most->complete());
    const auto none = find_lowest_pairs(pencil.pattern, pencil.K, pencil.M, 0, 0.5);
    REQUIRE(none);
    CHECK(none->values.size() == 0);
    CHECK(none->complete());
}

TEST_CASE("a basis that is full starts again from its best vectors", "[linear]") {
    // Eigenvalues so near to each other that a few dozen products do not part them.
    Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(160, 1.0, 1.1);
    const RandomPencil pencil = make_pencil(values);
    const auto pairs = find_lowest_pairs(pencil.pattern, pencil.K, pencil.M, 5);
    REQUIRE(pairs);
    check_pairs(pencil, *pairs, {values[0], values[1], values[2], values[3], values[4]});
}
