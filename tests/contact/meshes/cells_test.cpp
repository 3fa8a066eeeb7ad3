#include "contact/meshes/cells.hpp"

#include <cmath>
#include <random>

#include "contact/pairs/closest_points.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

bool are_boxes_near(const Capsule& a, const Capsule& b, double margin) {
    for (int k = 0; k < 3; ++k) {
        const double reach_a = a.radius + 0.5 * margin, reach_b = b.radius + 0.5 * margin;
        if (std::min(a.start[k], a.end[k]) - reach_a >= std::max(b.start[k], b.end[k]) + reach_b)
            return false;
        if (std::min(b.start[k], b.end[k]) - reach_b >= std::max(a.start[k], a.end[k]) + reach_a)
            return false;
    }
    return true;
}

std::vector<CapsulePair> list_near_pairs(const std::vector<Capsule>& capsules, double margin) {
    std::vector<CapsulePair> pairs;
    for (std::uint32_t i = 0; i < capsules.size(); ++i)
        for (std::uint32_t j = i + 1; j < capsules.size(); ++j)
            if (are_boxes_near(capsules[i], capsules[j], margin)) pairs.push_back({i, j});
    return pairs;
}

class CapsuleScene {
  public:
    explicit CapsuleScene(std::uint64_t seed) : random_(seed) {}

    Vec3 vector(double scale) {
        const double x = uniform_(random_), y = uniform_(random_), z = uniform_(random_);
        return scale * Vec3(x, y, z);
    }
    std::vector<Capsule> make(int count, double size, double length, double radius) {
        std::vector<Capsule> capsules;
        for (int k = 0; k < count; ++k) {
            const Vec3 start = vector(size);
            capsules.push_back({start, start + vector(length), radius});
        }
        return capsules;
    }

  private:
    std::mt19937_64 random_;
    std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

void check_near_pairs(const std::vector<Capsule>& capsules, double margin) {
    const std::vector<CapsulePair> expected = list_near_pairs(capsules, margin);
    const std::vector<CapsulePair> found = find_near_pairs(capsules, margin);
    CHECK(found.size() == expected.size());
    CHECK(found == expected);
}

}  // namespace

TEST_CASE("Near pairs are those of all pairs compared", "[contact]") {
    CapsuleScene scene(3);
    for (const double size : {1.0, 5.0, 50.0})
        for (const double margin : {0.0, 0.1, 1.0}) {
            INFO(size << " " << margin);
            check_near_pairs(scene.make(700, size, 0.5, 0.1), margin);
            check_near_pairs(scene.make(2, size, 3.0, 0.1), margin);
        }
}

TEST_CASE("Near pairs of very unlike lengths, places and sizes", "[contact]") {
    CapsuleScene scene(5);
    std::vector<Capsule> capsules = scene.make(500, 2.0, 0.02, 0.005);
    for (const Capsule& capsule : scene.make(20, 2.0, 4.0, 0.3)) capsules.push_back(capsule);
    capsules.push_back({Vec3(-1000, 0, 0), Vec3(1000, 1, 0), 0.01});
    capsules.push_back({Vec3(1e6, 1e6, 1e6), Vec3(1e6, 1e6, 1e6 + 1e-3), 0.01});
    check_near_pairs(capsules, 0.01);
    for (Capsule& capsule : capsules) capsule.start[2] = capsule.end[2] = 0.0;  // in a plane
    check_near_pairs(capsules, 0.01);
}

TEST_CASE("Near pairs of scenes without extent", "[contact]") {
    CHECK(find_near_pairs(std::vector<Capsule>{}, 1.0).empty());
    const Capsule point{Vec3(1, 2, 3), Vec3(1, 2, 3), 0.0};
    CHECK(find_near_pairs(std::vector<Capsule>{point}, 1.0).empty());
    check_near_pairs(std::vector<Capsule>(30, point), 0.0);
    check_near_pairs(std::vector<Capsule>(30, point), 0.5);  // all in one cell
    // On a lattice whose boxes just do, or do not, touch.
    std::vector<Capsule> lattice;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            for (int k = 0; k < 6; ++k) lattice.push_back({Vec3(i, j, k), Vec3(i, j, k), 0.25});
    for (const double margin : {0.5, 0.5 + 1e-12, 1.5, 3.0}) check_near_pairs(lattice, margin);
    CHECK(find_near_pairs(lattice, 0.5).empty());
}

TEST_CASE("Pairs that a filter refuses are left out, and no nearer ones are missed", "[contact]") {
    CapsuleScene scene(9);
    const std::vector<Capsule> capsules = scene.make(600, 2.0, 0.4, 0.05);
    const double margin = 0.03;
    const auto is_near = [&](CapsulePair pair) {
        const Capsule &a = capsules[pair.first], &b = capsules[pair.second];
        return find_closest_points({a.start, a.end}, {b.start, b.end}).distance - a.radius - b.radius <
               margin;
    };
    std::vector<CapsulePair> expected;
    for (std::uint32_t i = 0; i < capsules.size(); ++i)
        for (std::uint32_t j = i + 1; j < capsules.size(); ++j)
            if (is_near({i, j})) expected.push_back({i, j});
    REQUIRE(expected.size() > 100);
    CHECK(find_near_pairs(capsules, margin, is_near) == expected);
}

}  // namespace gxrod::test
