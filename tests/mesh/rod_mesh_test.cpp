#include "mesh/rod_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tools/catch.hpp"

namespace gxrod {
namespace {

using Fractions = std::vector<double>;

// Elements in each piece between points, for a mesh that has nodes at them.
std::vector<long> count_between(const Fractions& nodes, const Fractions& breaks) {
    std::vector<long> counts;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        counts.push_back(std::count_if(nodes.begin(), nodes.end(), [&](double node) {
            return node > breaks[i] + 1e-12 && node <= breaks[i + 1] + 1e-12;
        }));
    }
    return counts;
}

}  // namespace

TEST_CASE("A rod without points has equal elements", "[mesh]") {
    const Fractions nodes = compute_element_fractions({{}, {}}, 10);
    REQUIRE(nodes.size() == 11);
    for (int i = 0; i <= 10; ++i) CHECK(nodes[i] == i / 10.0);
}

TEST_CASE("Points that equal elements have do not change them", "[mesh]") {
    const Fractions nodes = compute_element_fractions({{1.0, 0.3, 0.0, 0.3, 0.7}, {}}, 10);
    REQUIRE(nodes.size() == 11);
    for (int i = 0; i <= 10; ++i) CHECK(nodes[i] == Approx(i / 10.0).epsilon(0).margin(1e-15));
    CHECK(nodes[3] == 0.3);
}

TEST_CASE("Points get a node, and elements in proportion to the lengths between them", "[mesh]") {
    CHECK(count_between(compute_element_fractions({{0.25}, {}}, 10), {0.0, 0.25, 1.0}) ==
          std::vector<long>{3, 7});
    CHECK(count_between(compute_element_fractions({{0.37}, {}}, 10), {0.0, 0.37, 1.0}) ==
          std::vector<long>{4, 6});
    CHECK(count_between(compute_element_fractions({{0.001}, {}}, 4), {0.0, 0.001, 1.0}) ==
          std::vector<long>{1, 3});
    CHECK(count_between(compute_element_fractions({{0.01, 0.02, 0.03}, {}}, 10),
                        {0.0, 0.01, 0.02, 0.03, 1.0}) == std::vector<long>{1, 1, 1, 7});
    const Fractions nodes = compute_element_fractions({{0.25}, {}}, 4);
    CHECK(nodes == Fractions{0.0, 0.25, 0.5, 0.75, 1.0});
    const Fractions third = compute_element_fractions({{0.3}, {}}, 4);
    CHECK(third[1] == 0.3);
    CHECK(third[2] == Approx(0.3 + 0.7 / 3.0));
}

TEST_CASE("Points nearer than 1e-9 to a node are that node", "[mesh]") {
    CHECK(compute_element_fractions({{1e-10, 1.0 - 1e-10}, {}}, 2) == Fractions{0.0, 0.5, 1.0});
    CHECK(compute_element_fractions({{0.5 + 9e-10}, {}}, 2) == Fractions{0.0, 0.5, 1.0});
    CHECK(compute_element_fractions({{0.4, 0.4 + 9e-10}, {}}, 2).size() == 3);
    CHECK(compute_element_fractions({{0.4, 0.4 + 3e-9}, {}}, 3).size() == 4);
    CHECK(compute_element_fractions({{0.333333333}, {}}, 3)[1] == 1.0 / 3.0);
}

TEST_CASE("Corners are breaks to the last bit, and take the place of points near them", "[mesh]") {
    const double corner = 0.3 + 4e-10;
    const Fractions nodes = compute_element_fractions({{0.3, 0.7}, {corner}}, 10);
    REQUIRE(nodes.size() == 11);
    CHECK(nodes[3] == corner);
    CHECK(nodes[7] == 0.7);
    CHECK(count_pieces({{0.3, 0.7}, {corner}}) == 3);
    CHECK(compute_element_fractions({{}, {0.2, 0.4}}, 2).empty());
    CHECK(count_between(compute_element_fractions({{}, {0.1, 0.4}}, 10), {0.0, 0.1, 0.4, 1.0}) ==
          std::vector<long>{1, 3, 6});
}

TEST_CASE("Nodes of an element are where the Legendre polynomials have their extremes", "[mesh]") {
    // P₁′ … P₄′ of 2x − 1 vanish at the inner nodes of orders 1 … 4.
    const auto slope = [](int order, double x) {
        const double y = 2.0 * x - 1.0;
        return order == 2 ? 3.0 * y : order == 3 ? 7.5 * y * y - 1.5 : 17.5 * y * y * y - 7.5 * y;
    };
    CHECK(compute_element_nodes(1) == Fractions{0.0, 1.0});
    for (int order = 2; order <= 4; ++order) {
        const Fractions nodes = compute_element_nodes(order);
        REQUIRE(nodes.size() == static_cast<std::size_t>(order) + 1);
        CHECK(nodes.front() == 0.0);
        CHECK(nodes.back() == 1.0);
        CHECK(std::is_sorted(nodes.begin(), nodes.end(), std::less_equal<>()));
        for (std::size_t i = 1; i + 1 < nodes.size(); ++i) CHECK(std::abs(slope(order, nodes[i])) < 1e-14);
    }
}

TEST_CASE("More pieces than elements make no mesh", "[mesh]") {
    CHECK(compute_element_fractions({{0.2, 0.4}, {}}, 2).empty());
    CHECK(count_pieces({{0.2, 0.4, 0.4}, {}}) == 3);
    CHECK(compute_element_fractions({{0.2, 0.4}, {}}, 3) == Fractions{0.0, 0.2, 0.4, 1.0});
}

TEST_CASE("Every mesh has its points, its elements and increasing nodes", "[mesh]") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> anywhere(0.0, 1.0);
    for (int i = 0; i < 500; ++i) {
        Fractions points(random() % 6);
        for (double& point : points) point = anywhere(random);
        const long elements =
            static_cast<long>(count_pieces({points, {}})) + static_cast<long>(random() % 20);
        const Fractions nodes = compute_element_fractions({points, {}}, elements);
        REQUIRE(nodes.size() == static_cast<std::size_t>(elements) + 1);
        CHECK(std::is_sorted(nodes.begin(), nodes.end(), std::less_equal<>()));
        for (const double point : points) CHECK(std::find(nodes.begin(), nodes.end(), point) != nodes.end());
    }
}

TEST_CASE("Graded elements end at equal steps of the integral of 1/h", "[mesh]") {
    // h = 1 + 2x: ∫ dx/h = ½ log(1 + 2x), and x = ½ (3^(k/n) − 1).
    const Fractions nodes = compute_element_fractions({{}, {}, Grading({{0.0, 1.0}, {1.0, 3.0}})}, 7);
    REQUIRE(nodes.size() == 8);
    for (int k = 0; k <= 7; ++k)
        CHECK(nodes[k] == Approx(0.5 * (std::pow(3.0, k / 7.0) - 1.0)).epsilon(0).margin(2e-16));
    // The same size twice is even, and a jump from 1 to 4 has four times the elements before it.
    const Fractions even = compute_element_fractions({{}, {}, Grading({{0.0, 2.0}, {1.0, 2.0}})}, 10);
    for (int k = 0; k <= 10; ++k) CHECK(even[k] == Approx(k / 10.0).epsilon(0).margin(2e-16));
    const Grading jump({{0.0, 1.0}, {0.5, 1.0}, {0.5, 4.0}, {1.0, 4.0}});
    CHECK(count_between(compute_element_fractions({{}, {}, jump}, 10), {0.0, 0.5, 1.0}) ==
          std::vector<long>{8, 2});
}

TEST_CASE("A grading's measure is the sum of many small steps over their sizes", "[mesh]") {
    const std::vector<std::pair<double, double>> rows{
        {0.0, 0.2}, {0.1, 1.0}, {0.6, 1.0}, {0.6, 5.0}, {0.7, 0.1}, {1.0, 0.1 + 1e-13}};
    const auto size_at = [&](double x) {
        std::size_t i = 1;
        while (i + 1 < rows.size() && x > rows[i].first) ++i;
        const double part = (x - rows[i - 1].first) / (rows[i].first - rows[i - 1].first);
        return rows[i - 1].second + part * (rows[i].second - rows[i - 1].second);
    };
    constexpr int steps = 100'000;
    const auto sum_to = [&](double end) {
        double sum = 0.0;
        for (int i = 0; i < steps; ++i) sum += end / steps / size_at(end * (i + 0.5) / steps);
        return sum;
    };
    const Grading grading(rows);
    const double whole = sum_to(1.0);
    for (const double x : {0.03, 0.1, 0.31, 0.6, 0.65, 0.7, 0.95, 1.0}) {
        CHECK(grading.measure(x) == Approx(sum_to(x) / whole).epsilon(0).margin(1e-6));
        CHECK(grading.fraction_at(grading.measure(x)) == Approx(x).epsilon(0).margin(1e-15));
    }
    CHECK(grading.measure(0.0) == 0.0);
    CHECK(grading.measure(1.0) == 1.0);
    CHECK(grading.fraction_at(1.0) == 1.0);
}

TEST_CASE("Graded meshes have a node at each point, and keep their nodes as elements are doubled", "[mesh]") {
    const Grading grading({{0.0, 0.1}, {0.2, 1.0}, {1.0, 0.3}});
    const Fractions coarse = compute_element_fractions({{}, {}, grading}, 12);
    const Fractions fine = compute_element_fractions({{}, {}, grading}, 24);
    for (int k = 0; k <= 12; ++k) CHECK(fine[2 * k] == Approx(coarse[k]).epsilon(0).margin(4e-16));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> anywhere(0.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        const RodBreaks breaks{{anywhere(random), anywhere(random)}, {0.4}, grading};
        const long elements = 4 + static_cast<long>(random() % 20);
        const Fractions nodes = compute_element_fractions(breaks, elements);
        REQUIRE(nodes.size() == static_cast<std::size_t>(elements) + 1);
        CHECK(std::is_sorted(nodes.begin(), nodes.end(), std::less_equal<>()));
        for (const double point : breaks.points)
            CHECK(std::find(nodes.begin(), nodes.end(), point) != nodes.end());
        CHECK(std::find(nodes.begin(), nodes.end(), 0.4) != nodes.end());
    }
    // 0.5 to 1 has the measure 0.29 of the whole.
    const double behind = 1.0 - grading.measure(0.5);
    CHECK(count_between(compute_element_fractions({{0.5}, {}, grading}, 100), {0.0, 0.5, 1.0})[1] ==
          std::lround(100.0 * behind));
}

}  // namespace gxrod
