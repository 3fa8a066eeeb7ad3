#pragma once

#include <vector>

#include "environment/flow_at.hpp"
#include "environment/stretching.hpp"
#include "environment/wave_kernels.hpp"

namespace gxrod {

// The sum of a water's trains of Airy waves, with its ramp.
class Waves {
  public:
    Waves(const Water& water, const WaveKernels& kernels);

    void move_to(double time);
    // Whether there are no waves at this time.
    bool are_still() const { return trains_ == 0 || (ramp_ == 0.0 && ramp_rate_ == 0.0); }

    struct At {
        WaveSurface surface{};
        FlowAt flow{};
    };
    // Returns the waves at a place, whose height is from still water. The rate of the flow is at the height
    // of its formula, which is not differentiated by time.
    At at(const Vec3& place) const;

  private:
    // Rows for the kernels; trains in ascending order of their wave numbers.
    struct Rows {
        std::vector<double> number, frequency, phase, lag, cosine, sine, amplitude;
        std::vector<double> flow, echo;              // aω/(1 − D), D
        std::vector<double> flow_slope, echo_slope;  // kaω/(1 − D), −D: for the derivative by z
    };
    void add_row(const WaveTrain& train);
    void pad_rows();
    WaveSurface find_surface(const Vec3& place, double* phases) const;
    // Sums the flow at a height from still water, before the ramp.
    FlowAt sum_flow(double z, const double* phases, bool by_height) const;
    FlowAt continue_along_tangent(double z, const double* phases) const;
    std::size_t end_of_group(double number) const;

    WaveKernels::OfDirections kernels_;
    Stretching stretching_;
    std::optional<double> depth_;
    double ramp_start_, ramp_length_;
    std::size_t trains_;
    bool is_long_crested_ = true;  // all trains have one direction
    Rows rows_;
    double ramp_ = 1.0, ramp_rate_ = 0.0;
};

}  // namespace gxrod
