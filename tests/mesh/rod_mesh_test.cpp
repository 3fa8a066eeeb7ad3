#include "mesh/rod_mesh.hpp"

#include <algorithm>
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

}  // namespace gxrod
