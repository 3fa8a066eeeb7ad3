// What is remembered of a mesh changes no bit of what is found.

#include "contact/meshes/mesh_memory.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>

#include "contact/meshes.hpp"
#include "contact/meshes/mesh_surface.hpp"
#include "contact/obstacle_surface.hpp"
#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double memory_ball = 0.1;
constexpr double memory_skin = 0.05;

MeshSurface whole_surface(const TriangleMesh& mesh) {
    std::vector<int> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    return {mesh, all};
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <class Matrix>
bool have_same_bits(const Matrix& a, const Matrix& b) {
    return std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

bool have_same_bits(const ObstacleDistance& a, const ObstacleDistance& b) {
    return same_bits(a.distance, b.distance) && same_bits(a.slope, b.slope) &&
           have_same_bits(a.normal, b.normal) && have_same_bits(a.curvature, b.curvature) &&
           have_same_bits(a.position, b.position);
}

// The nearest of all triangles, the first of equal ones.
struct Nearest {
    int triangle = -1;
    double distance = std::numeric_limits<double>::infinity();
};
Nearest find_by_force(const TriangleMesh& mesh, const Vec3& x) {
    Nearest nearest;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto at = [&](std::size_t i) {
            return mesh.positions[static_cast<std::size_t>(mesh.triangles[t][i])];
        };
        const double distance = find_on_triangle(make_triangle(at(0), at(1), at(2)), x).distance;
        if (distance < nearest.distance) nearest = {static_cast<int>(t), distance};
    }
    return nearest;
}

// Ways of a point next to meshes: small and large motions, long rests, onto triangles and far away.
class Wanderer {
  public:
    explicit Wanderer(unsigned seed) : random_(seed) {}
    Vec3 next(const Vec3& x) {
        const double size = std::pow(10.0, random_.number(-6.0, 0.3));
        Vec3 y = x + random_.vector(size);
        if (y.norm() > 3.0) y *= 0.3;
        return y;
    }
    double number(double low, double high) { return random_.number(low, high); }

  private:
    RandomValues random_;
};

}  // namespace

TEST_CASE("With a memory a mesh answers the same, to the last bit", "[contact][meshes]") {
    for (const double away : {0.0, 1e4}) {
        TriangleMesh soup = make_soup(200, 3);
        for (Vec3& position : soup.positions) position.x() += away;
        const TriangleMesh floor = make_floor(2.0, 9);  // whose triangles are equally near at edges
        for (const bool is_floor : {false, true}) {
            const TriangleMesh& mesh = is_floor ? floor : soup;
            const MeshSurface surface = whole_surface(mesh);
            const Vec3 origin(is_floor ? 0.0 : away, 0.0, 0.0);
            MeshMemory memory;
            memory.range = memory_ball + memory_skin;
            MeshMemory old;  // that mostly goes by what it found elsewhere
            Wanderer wanderer(5);
            Vec3 x = Vec3(0.5, 0.2, 0.3);
            int within = 0;
            for (int sample = 0; sample < 3000; ++sample) {
                const Vec3 at = origin + x, next = wanderer.next(x), there = origin + next;
                INFO("sample " << sample << ", " << away << " away");
                const Nearest expected = find_by_force(mesh, at);
                const double limit = expected.distance * wanderer.number(0.5, 1.5);
                const MeshSurface::Closest found = surface.find_closest(at, limit, &memory);
                REQUIRE(found.own == (expected.distance < limit ? expected.triangle : -1));
                REQUIRE(found.point.distance == std::min(limit, expected.distance));
                REQUIRE(surface.is_nearer(at, limit, &old) == (expected.distance < limit));
                REQUIRE(surface.is_nearer(at, limit, &memory) == (expected.distance < limit));
                REQUIRE(surface.find_least(at, limit, &memory) == std::min(limit, expected.distance));
                const FreeMotion free = surface.find_free_motion(memory_ball, at, there, 0.0, &memory);
                const FreeMotion without = surface.find_free_motion(memory_ball, at, there);
                REQUIRE(same_bits(free.fraction, without.fraction));
                REQUIRE(same_bits(free.gap, without.gap));
                for (int turn = 0; turn < 2; ++turn)  // the second is remembered
                    REQUIRE(have_same_bits(surface.find_distance(at, memory_ball, memory_skin, &memory),
                                           surface.find_distance(at, memory_ball, memory_skin)));
                const double gap = expected.distance - memory_ball;
                within += gap > 0.0 && gap < memory_skin;
                x = next;
            }
            CHECK(within > 50);
            CHECK(memory.nearby != nullptr);
        }
    }
}

TEST_CASE("A memory spares searches", "[contact][meshes]") {
    // Far away it knows that nothing is near, next to triangles which ones are near.
    const MeshSurface surface = whole_surface(make_floor(10.0, 40));
    MeshMemory memory;
    memory.range = memory_ball + memory_skin;
    CHECK(surface.find_closest(Vec3(0.1, 0.2, 5.0), 20.0, &memory).point.distance == 5.0);
    CHECK(!surface.is_nearer(Vec3(3.0, 0.2, 5.0), 2.0, &memory));
    CHECK(memory.at == Vec3(0.1, 0.2, 5.0));
    CHECK(memory.distance == 5.0);
    CHECK(memory.nearby == nullptr);
    CHECK(surface.find_distance(Vec3(0.1, 0.2, 0.12), memory_ball, memory_skin, &memory).distance > 0.0);
    REQUIRE(memory.nearby != nullptr);
    const Box box = memory.nearby->box;
    CHECK(memory.nearby->triangles.size() < 20);
    CHECK(surface.find_distance(Vec3(0.12, 0.19, 0.13), memory_ball, memory_skin, &memory).distance > 0.0);
    CHECK(memory.nearby->box.low == box.low);
    CHECK(surface.find_distance(Vec3(2.0, 0.19, 0.13), memory_ball, memory_skin, &memory).distance > 0.0);
    CHECK(memory.nearby->box.low != box.low);
}

TEST_CASE("A surface that moves is remembered in its own axes", "[contact][meshes]") {
    Obstacle obstacle = make_obstacle(make_soup(150, 8));
    obstacle.motion = ObstacleMotion{
        TimeVector(std::array<TimeFunction, 3>{TimeFunction([](double t) { return 0.3 * t; }), 0.0, 0.0}),
        TimeVector(std::array<TimeFunction, 3>{0.0, TimeFunction([](double t) { return 0.2 * t; }), 0.0}),
        Vec3(0.1, 0.0, 0.0)};
    const std::vector<Obstacle> obstacles{obstacle};
    for (const ObstacleSurface& surface : list_surfaces(obstacles)) {
        MeshMemory memory;
        memory.range = memory_ball + memory_skin;
        Wanderer wanderer(6);
        Vec3 x = Vec3::Zero();
        for (int sample = 0; sample < 1000; ++sample) {
            const Vec3 next = wanderer.next(x);
            const ObstaclePlacement from = place_obstacle(obstacles[0], 0.01 * sample);
            const ObstaclePlacement to = place_obstacle(obstacles[0], 0.01 * sample + 0.02);
            INFO("sample " << sample);
            REQUIRE(have_same_bits(surface.find_distance(from, x, memory_ball, memory_skin, &memory),
                                   surface.find_distance(from, x, memory_ball, memory_skin)));
            REQUIRE(surface.is_further(from, x, 0.2, &memory) == surface.is_further(from, x, 0.2));
            for (const double skin : {0.0, memory_skin}) {
                const FreeMotion free =
                    surface.find_free_motion(memory_ball, from, x, to, next, skin, &memory);
                const FreeMotion without = surface.find_free_motion(memory_ball, from, x, to, next, skin);
                REQUIRE(same_bits(free.fraction, without.fraction));
                REQUIRE(same_bits(free.gap, without.gap));
            }
            x = next;
        }
    }
}
