// The distance of a place from a mesh: nanoseconds a question, for a ball that moves in a bore of triangles
// from one question to the next, in its middle or along its wall; without and with a memory of what was found
// before.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numeric>

#include "contact/meshes.hpp"
#include "contact/meshes/mesh_surface.hpp"

namespace gxrod::speed {
namespace {

constexpr double bore = 1.5;
constexpr double ball_radius = 0.4;
constexpr double ball_skin = 0.008;

MeshSurface make_bore(int facets) {
    const TriangleMesh mesh = make_cylinder(bore, -50.0, 50.0, facets, 50);
    std::vector<int> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    return {mesh, all};
}

// Moves to and fro along the bore, at a distance from the axis, by a hundredth of the radius a question.
void measure_distance(benchmark::State& state, double off_axis, bool remembers) {
    const MeshSurface surface = make_bore(static_cast<int>(state.range(0)));
    MeshMemory memory;
    memory.range = ball_radius + ball_skin;
    double phase = 0.0;
    for (auto _ : state) {
        phase += 0.01 * ball_radius / 20.0;
        const Vec3 x(off_axis, 0.01, 20.0 * std::sin(phase));
        MeshMemory* const own = remembers ? &memory : nullptr;
        if (surface.is_nearer(x, ball_radius + ball_skin, own))
            benchmark::DoNotOptimize(surface.find_distance(x, ball_radius, ball_skin, own));
    }
}
constexpr double near_the_wall = 0.98 * bore - ball_radius - 0.2 * ball_skin;
BENCHMARK_CAPTURE(measure_distance, middle_search, 0.0, false)->Arg(10)->Arg(24)->Arg(96);
BENCHMARK_CAPTURE(measure_distance, middle_memory, 0.0, true)->Arg(10)->Arg(24)->Arg(96);
BENCHMARK_CAPTURE(measure_distance, wall_search, near_the_wall, false)->Arg(24)->Arg(96);
BENCHMARK_CAPTURE(measure_distance, wall_memory, near_the_wall, true)->Arg(24)->Arg(96);

}  // namespace
}  // namespace gxrod::speed
