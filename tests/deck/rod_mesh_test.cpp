#include "deck/rod_mesh.hpp"

#include <algorithm>
#include <numeric>
#include <random>

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

TEST_CASE("A rod without points has equal elements", "[deck]") {
    const Fractions nodes = compute_node_fractions({}, 10);
    REQUIRE(nodes.size() == 11);
    for (int i = 0; i <= 10; ++i) CHECK(nodes[i] == i / 10.0);
}

TEST_CASE("Points that equal elements have do not change them", "[deck]") {
    const Fractions nodes = compute_node_fractions({1.0, 0.3, 0.0, 0.3, 0.7}, 10);
    REQUIRE(nodes.size() == 11);
    for (int i = 0; i <= 10; ++i) CHECK(nodes[i] == Approx(i / 10.0).epsilon(0).margin(1e-15));
    CHECK(nodes[3] == 0.3);
}

TEST_CASE("Points get a node, and elements in proportion to the lengths between them", "[deck]") {
    CHECK(count_between(compute_node_fractions({0.25}, 10), {0.0, 0.25, 1.0}) == std::vector<long>{3, 7});
    CHECK(count_between(compute_node_fractions({0.37}, 10), {0.0, 0.37, 1.0}) == std::vector<long>{4, 6});
    CHECK(count_between(compute_node_fractions({0.001}, 4), {0.0, 0.001, 1.0}) == std::vector<long>{1, 3});
    CHECK(count_between(compute_node_fractions({0.01, 0.02, 0.03}, 10), {0.0, 0.01, 0.02, 0.03, 1.0}) ==
          std::vector<long>{1, 1, 1, 7});
    const Fractions nodes = compute_node_fractions({0.25}, 4);
    CHECK(nodes == Fractions{0.0, 0.25, 0.5, 0.75, 1.0});
    const Fractions third = compute_node_fractions({0.3}, 4);
    CHECK(third[1] == 0.3);
    CHECK(third[2] == Approx(0.3 + 0.7 / 3.0));
}

TEST_CASE("Points nearer than 1e-9 to a node are that node", "[deck]") {
    CHECK(compute_node_fractions({1e-10, 1.0 - 1e-10}, 2) == Fractions{0.0, 0.5, 1.0});
    CHECK(compute_node_fractions({0.5 + 9e-10}, 2) == Fractions{0.0, 0.5, 1.0});
    CHECK(compute_node_fractions({0.4, 0.4 + 9e-10}, 2).size() == 3);
    CHECK(compute_node_fractions({0.4, 0.4 + 3e-9}, 3).size() == 4);
    CHECK(compute_node_fractions({0.333333333}, 3)[1] == 1.0 / 3.0);
}

TEST_CASE("More pieces than elements make no mesh", "[deck]") {
    CHECK(compute_node_fractions({0.2, 0.4}, 2).empty());
    CHECK(count_pieces({0.2, 0.4, 0.4}) == 3);
    CHECK(compute_node_fractions({0.2, 0.4}, 3) == Fractions{0.0, 0.2, 0.4, 1.0});
}

TEST_CASE("Every mesh has its points, its elements and increasing nodes", "[deck]") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> anywhere(0.0, 1.0);
    for (int i = 0; i < 500; ++i) {
        Fractions points(random() % 6);
        for (double& point : points) point = anywhere(random);
        const long elements = static_cast<long>(count_pieces(points)) + static_cast<long>(random() % 20);
        const Fractions nodes = compute_node_fractions(points, elements);
        REQUIRE(nodes.size() == static_cast<std::size_t>(elements) + 1);
        CHECK(std::is_sorted(nodes.begin(), nodes.end(), std::less_equal<>()));
        for (const double point : points) CHECK(std::find(nodes.begin(), nodes.end(), point) != nodes.end());
    }
}

}  // namespace gxrod
