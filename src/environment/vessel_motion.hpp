#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "model/surroundings.hpp"

// A vessel that follows waves by its response amplitude operators (docs/theory/water.md).
namespace gxrod {

// Surge, sway, heave, roll, pitch and yaw per amplitude of a wave, in the vessel's axes: x forward, y to
// port, z up. The motion is Re(R e^(iωt)) for a wave that is cos ωt at the vessel.
using VesselResponse = std::array<std::complex<double>, 6>;

struct ResponseTable {
    std::vector<double> frequencies;        // ω, rising
    std::vector<double> headings;           // where waves go, from the vessel's x towards its y; rising
    std::vector<VesselResponse> responses;  // entry of frequency f and heading h: f + h frequencies.size()
};

// Interpolates between frequencies and headings, linearly in the complex numbers. A table of headings of one
// side holds for the other side, too, with opposite sway, roll and yaw. Returns nullopt beyond the table.
std::optional<VesselResponse> find_response(const ResponseTable& table, double frequency, double heading);

struct Vessel {
    Vec3 place = Vec3::Zero();   // whose motion the responses are, at t = 0
    Vec3 offset = Vec3::Zero();  // of its mean place from there
    double heading = 0.0;        // of its x axis, from the global x towards y
};

// The motion of a vessel in waves about its mean place.
class VesselMotion {
  public:
    // Sums trains of waves, with their ramp. The first train beyond the table goes to `beyond`.
    VesselMotion(const Vessel& vessel,
                 const ResponseTable& table,
                 const Water& water,
                 std::optional<WaveTrain>& beyond);

    // Computes displacement and rotation vector, global; offset included.
    Vec6 at(double time) const;
    // Computes the same of a point that is fixed to the vessel, from its place at t = 0.
    Vec6 of_point(const Vec3& point, double time) const;
    // Returns the sum of the amplitudes of all waves, by component.
    const Vec6& largest() const { return largest_; }

  private:
    struct Part {
        double frequency;
        std::array<std::complex<double>, 6> amplitudes;  // global, with the wave's amplitude and phase
    };
    Vessel vessel_;
    std::vector<Part> parts_;
    double ramp_start_, ramp_;
    Vec6 largest_ = Vec6::Zero();
};

}  // namespace gxrod
