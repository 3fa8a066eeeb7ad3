// The kernels of finite rotations, for angles of a step and for large ones: the argument is a thousandth of a
// radian.
#include <benchmark/benchmark.h>

#include <array>

#include "rotation/half_rotation.hpp"
#include "rotation/rates.hpp"
#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"
#include "tools/random_values.hpp"

namespace gxrod::speed {
namespace {

constexpr int vectors = 256;

// Arguments for a kernel: rotation vectors of one angle, and two vectors with each.
struct Arguments {
    std::array<Vec3, vectors> phi, u, v;
    std::array<Quat, vectors> rotation;
    std::array<Mat3, vectors> matrix;

    explicit Arguments(double angle) {
        tools::RandomValues random(1);
        for (int i = 0; i < vectors; ++i) {
            phi[i] = angle * random.direction();
            u[i] = random.vector();
            v[i] = random.vector();
            rotation[i] = exp_quaternion(phi[i]);
            matrix[i] = exp_matrix(phi[i]);
        }
    }
};

// `kernel` takes the arguments and which of them.
template <class Kernel>
void measure(benchmark::State& state, Kernel kernel) {
    constexpr double thousandth = 1e-3;
    const Arguments arguments(thousandth * static_cast<double>(state.range(0)));
    for (auto _ : state) {
        for (int i = 0; i < vectors; ++i) {
            auto value = kernel(arguments, i);
            benchmark::DoNotOptimize(value);
        }
    }
    state.counters["per_call"] = benchmark::Counter(
        vectors, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void add(const char* name, auto kernel) {
    benchmark::RegisterBenchmark((std::string("rotation/") + name).c_str(),
                                 [kernel](benchmark::State& state) { measure(state, kernel); })
        ->Arg(1)
        ->Arg(300)
        ->Arg(2500);
}

bool add_all() {
    using A = Arguments;
    add("exp_quaternion", [](const A& a, int i) { return exp_quaternion(a.phi[i]); });
    add("exp_matrix", [](const A& a, int i) { return exp_matrix(a.phi[i]); });
    add("log_quaternion", [](const A& a, int i) { return log(a.rotation[i]); });
    add("log_matrix", [](const A& a, int i) { return log(a.matrix[i]); });
    add("log_nearest", [](const A& a, int i) { return log_nearest(a.rotation[i], a.phi[i]); });
    add("split_rotation", [](const A& a, int i) { return split_rotation(a.rotation[i]); });
    add("tangent_map", [](const A& a, int i) { return tangent_map(a.phi[i]); });
    add("tangent_map_inverse", [](const A& a, int i) { return tangent_map_inverse(a.phi[i]); });
    add("tangent_map_derivative", [](const A& a, int i) { return tangent_map_derivative(a.phi[i], a.v[i]); });
    add("tangent_map_inverse_derivative",
        [](const A& a, int i) { return tangent_map_inverse_derivative(a.phi[i], a.v[i]); });
    add("tangent_map_hessian",
        [](const A& a, int i) { return tangent_map_hessian(a.phi[i], a.u[i], a.v[i]); });
    add("angular_acceleration",
        [](const A& a, int i) { return angular_acceleration(a.phi[i], a.u[i], a.v[i]); });
    return true;
}
const bool added = add_all();

}  // namespace
}  // namespace gxrod::speed
