#pragma once

#include "environment/lane_functions.hpp"
#include "environment/wave_kernels.hpp"

// Wave kernels for the sources of instruction sets; see elements/lanes/lanes.hpp.
namespace gxrod {

template <class Arch>
class WaveLanes {
  public:
    static WaveKernels make() {
        return {{&sum_surface<SumsAlong>, &add_flow<SumsAlong, false>, &add_flow<SumsAlong, true>},
                {&sum_surface<SumsInPlane>, &add_flow<SumsInPlane, false>, &add_flow<SumsInPlane, true>}};
    }

  private:
    using Real = xsimd::batch<double, Arch>;
    using Functions = LaneFunctions<Real>;
    static_assert(wave_group % Real::size == 0);

    static Real load(const double* entries) { return Real::load_unaligned(entries); }

    template <class Sums>
    static void sum_surface(
        const WaveRows& rows, std::size_t count, const double* place, double* phases, double* sums) {
        constexpr bool in_plane = Sums::surface == SumsInPlane::surface;
        const Real x(place[0]), y(place[1]);
        for (std::size_t lane = 0; lane < wave_group; lane += Real::size) {
            Real height(0.0), slope_x(0.0), slope_y(0.0);
            for (std::size_t i = lane; i < count; i += wave_group) {
                const Real number = load(rows.number + i);
                Real along = x;
                if constexpr (in_plane) along = x * load(rows.cosine + i) + y * load(rows.sine + i);
                const auto phase = Functions::sine_cosine(number * along - load(rows.lag + i));
                phase.cosine.store_unaligned(phases + 2 * i - lane);
                phase.sine.store_unaligned(phases + 2 * i - lane + wave_group);
                const Real amplitude = load(rows.amplitude + i);
                height += amplitude * phase.cosine;
                const Real slope = amplitude * number * phase.sine;
                if constexpr (in_plane) {
                    slope_x += slope * load(rows.cosine + i);
                    slope_y += slope * load(rows.sine + i);
                } else {
                    slope_x += slope;
                }
            }
            height.store_unaligned(sums + lane);
            slope_x.store_unaligned(sums + wave_group + lane);
            if constexpr (in_plane) slope_y.store_unaligned(sums + 2 * wave_group + lane);
        }
    }

    template <class Sums, bool is_deep>
    static void add_flow(const WaveRows& rows,
                         const WaveKernels::Trains& trains,
                         double z,
                         const double* phases,
                         double* sums) {
        const Real height(z);
        for (std::size_t lane = 0; lane < wave_group; lane += Real::size) {
            Real sum[Sums::flow];
            for (int k = 0; k < Sums::flow; ++k) sum[k] = load(sums + k * wave_group + lane);
            for (std::size_t i = trains.begin + lane; i < trains.end; i += wave_group) {
                const Real number = load(rows.number + i);
                const Real flow = load(rows.flow + i);
                const Real cosine = flow * load(phases + 2 * i - lane);
                const Real sine = flow * load(phases + 2 * i - lane + wave_group);
                Real large = Functions::exponential(number * height), small = large;
                if constexpr (!is_deep) {
                    const Real echo = load(rows.echo + i) / large;
                    large = large + echo;
                    small = small - echo;
                }
                const Products of{large * cosine, large * sine, small * cosine, small * sine};
                if constexpr (Sums::flow == SumsInPlane::flow) {
                    add_in_plane(rows, i, of, sum);
                } else {
                    add_along(number, load(rows.frequency + i), of, sum);
                }
            }
            for (int k = 0; k < Sums::flow; ++k) sum[k].store_unaligned(sums + k * wave_group + lane);
        }
    }

    struct Products {
        Real large_cosine, large_sine, small_cosine,
            small_sine;  // q C cos ψ, q C sin ψ, q S cos ψ, q S sin ψ
    };

    static void add_along(const Real& number,
                          const Real& frequency,
                          const Products& of,
                          Real (&sum)[SumsAlong::flow]) {
        const Real both = number * frequency;
        sum[0] += of.large_cosine;
        sum[1] += of.small_sine;
        sum[2] += frequency * of.large_sine;
        sum[3] += frequency * of.small_cosine;
        sum[4] += number * of.large_sine;
        sum[5] += number * of.small_cosine;
        sum[6] += both * of.large_cosine;
        sum[7] += both * of.small_sine;
    }

    static void add_in_plane(const WaveRows& rows,
                             std::size_t i,
                             const Products& of,
                             Real (&sum)[SumsInPlane::flow]) {
        const Real number = load(rows.number + i), frequency = load(rows.frequency + i);
        const Real x = load(rows.cosine + i), y = load(rows.sine + i);
        const Real both = number * frequency;
        add_vector(x, y, of.large_cosine, sum);
        sum[2] += of.small_sine;
        add_vector(x, y, frequency * of.large_sine, sum + 3);
        sum[5] += frequency * of.small_cosine;
        add_gradient(x, y, number * of.large_sine, number * of.small_cosine, sum + 6);
        add_gradient(x, y, both * of.large_cosine, both * of.small_sine, sum + 11);
    }
    static void add_vector(const Real& x, const Real& y, const Real& value, Real* sum) {
        sum[0] += x * value;
        sum[1] += y * value;
    }
    static void add_gradient(
        const Real& x, const Real& y, const Real& level, const Real& upright, Real* sum) {
        const Real of_x = x * level;
        sum[0] += x * of_x;
        sum[1] += y * of_x;
        sum[2] += y * (y * level);
        add_vector(x, y, upright, sum + 3);
    }
};

}  // namespace gxrod
