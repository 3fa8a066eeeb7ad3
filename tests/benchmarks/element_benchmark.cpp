// Forces and tangents of rod elements: of one element again and again, and of a rod, assembled.
#include <benchmark/benchmark.h>

#include "assembly/system.hpp"
#include "benchmarks/problems.hpp"
#include "elements/rod/rod_element.hpp"
#include "numerics/lagrange.hpp"
#include "state/increment.hpp"
#include "tools/random_values.hpp"

namespace gxrod::speed {
namespace {

// As in a step of Newmark's method, Δt = 1 ms.
const NodeLinearization linearization{1.0, 2e3, 4e6, 2e3 * Mat3::Identity(), 4e6 * Mat3::Identity()};

// An element of the pendulum, turned by much and bent by little.
template <class E>
class Sample {
  public:
    static constexpr int nodes = E::node_count;

    Sample() : rod_(make_geometry(), make_pendulum(1, 1, 1).model.sections[0]) {
        tools::RandomValues random(1);
        const Vec3 common = random.direction();
        const auto at = compute_node_positions<nodes>();
        for (int i = 0; i < nodes; ++i) {
            NodeMotion previous;
            previous.Lambda = exp_quaternion(common);
            const Vec3 r = previous.Lambda * Vec3(half_length * at[i], 0.0, 0.0) + random.vector(1e-4);
            place(previous, r, random.vector(1e-2), motions_[i]);
            motions_[i].omega = random.vector();
            motions_[i].alpha = random.vector();
        }
        rod_.start(histories_);
        for (int i = 0; i < nodes; ++i) {
            motions[i] = &motions_[i];
            linearizations[i] = &linearization;
        }
    }
    Sample(const Sample&) = delete;  // its parts point at each other
    Sample& operator=(const Sample&) = delete;

    const E& rod() const { return rod_; }
    Histories histories() const { return {.axes = histories_}; }

    Motions<nodes> motions;
    Linearizations<nodes> linearizations;

  private:
    static constexpr double half_length = 5e-3;

    static RodElementGeometry<nodes> make_geometry() {
        RodElementGeometry<nodes> geometry;
        const auto at = compute_node_positions<nodes>();
        for (int i = 0; i < nodes; ++i) {
            geometry.nodes[i] = i;
            geometry.positions[i] = Vec3(half_length * at[i], 0.0, 0.0);
            geometry.triads[i] = Quat::Identity();
        }
        return geometry;
    }

    E rod_;
    std::array<NodeMotion, nodes> motions_;
    std::array<SectionHistory, E::history_count> histories_;
};

template <class E>
void internal_force(benchmark::State& state) {
    const Sample<E> sample;
    for (auto _ : state) {
        NodalVector<E::node_count> force = NodalVector<E::node_count>::Zero();
        sample.rod().add_internal_force(sample.motions, sample.histories(), force);
        benchmark::DoNotOptimize(force);
    }
}

template <class E>
void internal_tangent(benchmark::State& state) {
    const Sample<E> sample;
    for (auto _ : state) {
        NodalMatrix<E::node_count> tangent = NodalMatrix<E::node_count>::Zero();
        sample.rod().add_internal_tangent(sample.motions, sample.histories(), sample.linearizations, tangent);
        benchmark::DoNotOptimize(tangent);
    }
}

template <class E>
void inertial_force(benchmark::State& state) {
    const Sample<E> sample;
    for (auto _ : state) {
        NodalVector<E::node_count> force = NodalVector<E::node_count>::Zero();
        sample.rod().add_inertial_force(sample.motions, Vec3::UnitZ(), force);
        benchmark::DoNotOptimize(force);
    }
}

template <class E>
void inertial_tangent(benchmark::State& state) {
    const Sample<E> sample;
    for (auto _ : state) {
        NodalMatrix<E::node_count> tangent = NodalMatrix<E::node_count>::Zero();
        sample.rod().add_inertial_tangent(sample.motions, Vec3::UnitZ(), sample.linearizations, tangent);
        benchmark::DoNotOptimize(tangent);
    }
}

template <class E>
void add_element(const std::string& name) {
    benchmark::RegisterBenchmark((name + "/internal_force").c_str(), internal_force<E>);
    benchmark::RegisterBenchmark((name + "/internal_tangent").c_str(), internal_tangent<E>);
    benchmark::RegisterBenchmark((name + "/inertial_force").c_str(), inertial_force<E>);
    benchmark::RegisterBenchmark((name + "/inertial_tangent").c_str(), inertial_tangent<E>);
}

bool add_all() {
    add_element<ObjectiveElement<2>>("objective/order:1");
    add_element<ObjectiveElement<3>>("objective/order:2");
    add_element<ObjectiveElement<4>>("objective/order:3");
    add_element<ObjectiveElement<5>>("objective/order:4");
    add_element<SimoElement<2>>("simo/order:1");
    add_element<SimoElement<3>>("simo/order:2");
    add_element<SimoElement<4>>("simo/order:3");
    add_element<SimoElement<5>>("simo/order:4");
    return true;
}
const bool added = add_all();

constexpr int elements = 1000;

void per_element(benchmark::State& state) {
    state.counters["per_element"] = benchmark::Counter(
        elements, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void assemble_forces(benchmark::State& state, ElementKind kind) {
    const Problem problem = make_pendulum(elements, static_cast<int>(state.range(0)), 1, kind);
    const System system(problem.model);
    const State start = system.initial_state();
    Residual residual;
    for (auto _ : state) {
        system.compute_residual(start, 0.0, residual);
        benchmark::DoNotOptimize(residual.nodal.data());
    }
    per_element(state);
}
BENCHMARK_CAPTURE(assemble_forces, objective, ElementKind::objective)->ArgName("order")->DenseRange(1, 4);
BENCHMARK_CAPTURE(assemble_forces, simo, ElementKind::simo)->ArgName("order")->DenseRange(1, 4);

void assemble_tangent(benchmark::State& state, ElementKind kind) {
    const Problem problem = make_pendulum(elements, static_cast<int>(state.range(0)), 1, kind);
    const System system(problem.model);
    const State start = system.initial_state();
    const std::vector<NodeLinearization> linearizations(start.trial.size(), linearization);
    std::vector<double> values;
    for (auto _ : state) {
        system.compute_tangent(start, 0.0, linearizations, values);
        benchmark::DoNotOptimize(values.data());
    }
    per_element(state);
}
BENCHMARK_CAPTURE(assemble_tangent, objective, ElementKind::objective)->ArgName("order")->DenseRange(1, 4);
BENCHMARK_CAPTURE(assemble_tangent, simo, ElementKind::simo)->ArgName("order")->DenseRange(1, 4);

}  // namespace
}  // namespace gxrod::speed
