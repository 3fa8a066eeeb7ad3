#include "environment/vessel_motion.hpp"

#include <algorithm>
#include <cmath>

#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// Relative to the values of a table: how far beyond its ends is round-off.
constexpr double table_end = 1e-9;

// Where a value lies in rising numbers: between one and the next, by a share.
struct Between {
    std::size_t first, second;
    double share;
};

std::optional<Between> find_between(const std::vector<double>& rising, double value) {
    const double margin = table_end * (1.0 + std::abs(rising.back()));
    if (value < rising.front() - margin || value > rising.back() + margin) return std::nullopt;
    const auto after = std::ranges::upper_bound(rising, value);
    if (after == rising.begin()) return Between{0, 0, 0.0};
    const auto first = static_cast<std::size_t>(after - rising.begin()) - 1;
    if (after == rising.end()) return Between{first, first, 0.0};
    return Between{first, first + 1, (value - rising[first]) / (rising[first + 1] - rising[first])};
}

// Headings go round.
std::optional<Between> find_heading(const std::vector<double>& headings, double heading) {
    const double turn = 2.0 * M_PI;
    const double round = heading - turn * std::floor((heading - headings.front()) / turn + table_end);
    if (auto found = find_between(headings, round)) return found;
    // From the last one over a whole turn to the first, if they go round with no larger gap than others.
    if (headings.back() - headings.front() <= M_PI * (1.0 + table_end)) return std::nullopt;
    double largest = 0.0;
    for (std::size_t i = 1; i < headings.size(); ++i)
        largest = std::max(largest, headings[i] - headings[i - 1]);
    const double gap = headings.front() + turn - headings.back();
    if (gap > largest * (1.0 + table_end)) return std::nullopt;
    return Between{headings.size() - 1, 0, (round - headings.back()) / gap};
}

}  // namespace

std::optional<VesselResponse> find_response(const ResponseTable& table, double frequency, double heading) {
    const std::optional<Between> f = find_between(table.frequencies, frequency);
    std::optional<Between> h = find_heading(table.headings, heading);
    const bool is_mirrored = !h;
    if (is_mirrored) h = find_heading(table.headings, -heading);
    if (!f || !h) return std::nullopt;
    const auto entry = [&](std::size_t of_heading, std::size_t of_frequency, std::size_t i) {
        return table.responses[of_frequency + of_heading * table.frequencies.size()][i];
    };
    const auto along = [&](std::size_t of_heading, std::size_t i) {
        return (1.0 - f->share) * entry(of_heading, f->first, i) + f->share * entry(of_heading, f->second, i);
    };
    VesselResponse response;
    for (std::size_t i = 0; i < 6; ++i) {
        response[i] = (1.0 - h->share) * along(h->first, i) + h->share * along(h->second, i);
        if (is_mirrored && i % 2 == 1) response[i] = -response[i];  // sway, roll, yaw
    }
    return response;
}

VesselMotion::VesselMotion(const Vessel& vessel,
                           const ResponseTable& table,
                           const Water& water,
                           std::optional<WaveTrain>& beyond)
    : vessel_(vessel), ramp_start_(water.ramp_start), ramp_(water.ramp) {
    const Vec3 mean = vessel.place + vessel.offset;
    const double c = std::cos(vessel.heading), s = std::sin(vessel.heading);
    for (const WaveTrain& wave : water.waves) {
        const std::optional<VesselResponse> found =
            find_response(table, wave.frequency, wave.direction - vessel.heading);
        if (!found) {
            if (!beyond) beyond = wave;
            continue;
        }
        const double way = mean.x() * std::cos(wave.direction) + mean.y() * std::sin(wave.direction);
        const std::complex<double> here = std::polar(wave.amplitude, -(wave.number * way + wave.phase));
        Part part{wave.frequency, {}};
        for (std::size_t i = 0; i < 6; i += 3) {
            const VesselResponse& own = *found;
            part.amplitudes[i] = here * (c * own[i] - s * own[i + 1]);
            part.amplitudes[i + 1] = here * (s * own[i] + c * own[i + 1]);
            part.amplitudes[i + 2] = here * own[i + 2];
        }
        for (std::size_t i = 0; i < 6; ++i)
            largest_[static_cast<Eigen::Index>(i)] += std::abs(part.amplitudes[i]);
        parts_.push_back(part);
    }
}

Vec6 VesselMotion::at(double time) const {
    Vec6 motion = Vec6::Zero();
    for (const Part& part : parts_) {
        const double cosine = std::cos(part.frequency * time), sine = std::sin(part.frequency * time);
        for (std::size_t i = 0; i < 6; ++i) {
            motion[static_cast<Eigen::Index>(i)] +=
                part.amplitudes[i].real() * cosine - part.amplitudes[i].imag() * sine;
        }
    }
    const double q = ramp_ > 0.0 ? std::clamp((time - ramp_start_) / ramp_, 0.0, 1.0) : 1.0;
    motion *= q * q * q * (10.0 - 15.0 * q + 6.0 * q * q);
    motion.head<3>() += vessel_.offset;
    return motion;
}

Vec6 VesselMotion::of_point(const Vec3& point, double time) const {
    Vec6 motion = at(time);
    const Vec3 arm = point - vessel_.place;
    const Vec3 turn = motion.tail<3>();
    motion.head<3>() += exp_quaternion(turn) * arm - arm;
    return motion;
}

}  // namespace gxrod
