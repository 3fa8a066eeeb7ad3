#include "environment/wave_kernels.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Row = std::vector<double>;

struct Trains {
    Row number, frequency, lag, cosine, sine, amplitude, flow, echo;

    WaveRows rows() const {
        return {number.data(),
                frequency.data(),
                lag.data(),
                cosine.data(),
                sine.data(),
                amplitude.data(),
                flow.data(),
                echo.data()};
    }
};

Trains make_trains(std::size_t count) {
    std::mt19937_64 engine(3);
    const auto draw = [&](double low, double high) {
        Row row(count);
        for (double& entry : row) entry = std::uniform_real_distribution(low, high)(engine);
        return row;
    };
    Trains trains{draw(0.01, 3), draw(0.2, 5), draw(-1e4, 1e4), {}, {}, draw(0, 1), draw(0, 2), draw(0, 1)};
    for (const double angle : draw(-3, 3)) {
        trains.cosine.push_back(std::cos(angle));
        trains.sine.push_back(std::sin(angle));
    }
    return trains;
}

using Sums = std::array<double, most_wave_sums * wave_group>;

double total(const Sums& sums, std::size_t k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < wave_group; ++i) sum += sums[k * wave_group + i];
    return sum;
}

struct Results {
    Row phases;
    Sums surface{}, flow{}, deep_flow{};
};

Results run(const WaveKernels::OfDirections& kernels, const Trains& trains, double z) {
    const std::size_t count = trains.number.size();
    Results results{Row(2 * count), {}, {}, {}};
    const std::array<double, 2> place{12.3, -4.5};
    kernels.sum_surface(trains.rows(), count, place.data(), results.phases.data(), results.surface.data());
    kernels.add_flow(trains.rows(), {4, count}, z, results.phases.data(), results.flow.data());
    kernels.add_deep_flow(trains.rows(), {0, count - 4}, z, results.phases.data(), results.deep_flow.data());
    return results;
}

bool same_bits(const Sums& a, const Sums& b) { return std::memcmp(a.data(), b.data(), sizeof a) == 0; }

// The sums of a description in wave_kernels.hpp, by the functions of the standard library.
std::array<double, 16> sum_flow(
    const Trains& trains, std::size_t begin, std::size_t end, double z, bool is_deep) {
    std::array<double, 16> sums{};
    for (std::size_t i = begin; i < end; ++i) {
        const double k = trains.number[i], w = trains.frequency[i], x = trains.cosine[i], y = trains.sine[i];
        const double phase = k * (x * 12.3 + y * -4.5) - trains.lag[i];
        const double echo = is_deep ? 0.0 : trains.echo[i] * std::exp(-k * z);
        const double large = trains.flow[i] * (std::exp(k * z) + echo);
        const double small = trains.flow[i] * (std::exp(k * z) - echo);
        const double c = std::cos(phase), s = std::sin(phase);
        const std::array<double, 16> terms{large * c * x,
                                           large * c * y,
                                           small * s,
                                           w * large * s * x,
                                           w * large * s * y,
                                           w * small * c,
                                           k * large * s * x * x,
                                           k * large * s * x * y,
                                           k * large * s * y * y,
                                           k * small * c * x,
                                           k * small * c * y,
                                           w * k * large * c * x * x,
                                           w * k * large * c * x * y,
                                           w * k * large * c * y * y,
                                           w * k * small * s * x,
                                           w * k * small * s * y};
        for (std::size_t j = 0; j < terms.size(); ++j) sums[j] += terms[j];
    }
    return sums;
}

}  // namespace

TEST_CASE("Kernels of waves give the same bits with every instruction set", "[environment]") {
    if (find_instruction_set() == InstructionSet::baseline) return;
    const WaveKernels narrow = find_wave_kernels(InstructionSet::baseline),
                      wide = find_wave_kernels(InstructionSet::avx2);
    const Trains trains = make_trains(52);
    for (const double z : {-30.0, -1.0, 0.0, 2.0}) {
        for (const auto of : {&WaveKernels::along, &WaveKernels::in_plane}) {
            const Results first = run(narrow.*of, trains, z), second = run(wide.*of, trains, z);
            CHECK(first.phases == second.phases);
            CHECK(same_bits(first.surface, second.surface));
            CHECK(same_bits(first.flow, second.flow));
            CHECK(same_bits(first.deep_flow, second.deep_flow));
        }
    }
}

TEST_CASE("Sines, cosines and exponentials of waves are right to round-off", "[environment]") {
    const WaveKernels::OfDirections kernels = find_wave_kernels(InstructionSet::baseline).along;
    std::mt19937_64 engine(5);
    for (const double range : {0.1, 2.0, 10.0, 1e3, 1e6}) {
        for (int trial = 0; trial < 500; ++trial) {
            std::uniform_real_distribution phase(-range, range), exponent(-39.0, 5.0);
            const double psi = phase(engine), x = exponent(engine);
            const Row one{1, 1, 1, 1}, zero{0, 0, 0, 0};
            const WaveRows rows{one.data(),
                                one.data(),
                                zero.data(),
                                one.data(),
                                zero.data(),
                                one.data(),
                                one.data(),
                                zero.data()};
            std::array<double, 8> phases{};
            const std::array<double, 2> place{psi, 0.0};
            Sums surface{}, flow{};
            kernels.sum_surface(rows, 4, place.data(), phases.data(), surface.data());
            CHECK(std::abs(phases[0] - std::cos(psi)) < 2.5e-16);
            CHECK(std::abs(phases[4] - std::sin(psi)) < 2.5e-16);
            const std::array<double, 8> ones{1, 1, 1, 1, 1, 1, 1, 1};
            kernels.add_deep_flow(rows, {0, 4}, x, ones.data(), flow.data());
            CHECK(std::abs(flow[0] / std::exp(x) - 1.0) < 4.5e-16);
        }
    }
}

TEST_CASE("Kernels of waves sum what they say", "[environment]") {
    const Trains trains = make_trains(24);
    const Results results = run(find_wave_kernels(InstructionSet::baseline).in_plane, trains, -0.7);
    std::array<double, 3> surface{};
    for (std::size_t i = 0; i < 24; ++i) {
        const double phase =
            trains.number[i] * (trains.cosine[i] * 12.3 + trains.sine[i] * -4.5) - trains.lag[i];
        surface[0] += trains.amplitude[i] * std::cos(phase);
        surface[1] += trains.amplitude[i] * trains.number[i] * std::sin(phase) * trains.cosine[i];
        surface[2] += trains.amplitude[i] * trains.number[i] * std::sin(phase) * trains.sine[i];
    }
    // Phases of 1e4 are rounded to 1e-12.
    for (std::size_t k = 0; k < 3; ++k) CHECK(total(results.surface, k) == Approx(surface[k]).margin(1e-10));
    const auto flow = sum_flow(trains, 4, 24, -0.7, false), deep = sum_flow(trains, 0, 20, -0.7, true);
    for (std::size_t k = 0; k < 16; ++k) {
        CHECK(total(results.flow, k) == Approx(flow[k]).margin(1e-9));
        CHECK(total(results.deep_flow, k) == Approx(deep[k]).margin(1e-9));
    }
}

TEST_CASE("Trains of one direction are summed along it as in the plane", "[environment]") {
    Trains trains = make_trains(24);
    trains.cosine.assign(24, 1.0);
    trains.sine.assign(24, 0.0);
    const WaveKernels kernels = find_wave_kernels(InstructionSet::baseline);
    const Results along = run(kernels.along, trains, -0.7), plane = run(kernels.in_plane, trains, -0.7);
    CHECK(total(along.surface, 0) == total(plane.surface, 0));
    CHECK(total(along.surface, 1) == total(plane.surface, 1));
    const std::array<std::size_t, SumsAlong::flow> same{0, 2, 3, 5, 6, 9, 11, 14};
    for (std::size_t k = 0; k < same.size(); ++k) {
        CHECK(total(along.flow, k) == total(plane.flow, same[k]));
        CHECK(total(along.deep_flow, k) == total(plane.deep_flow, same[k]));
    }
}

}  // namespace gxrod::test
