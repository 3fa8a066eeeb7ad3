#include "study/series_differences.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

namespace {

// Less than this part of the same quantity elsewhere, or of the model's own, is what solvers leave.
constexpr double still = 1e-9;
constexpr double still_by_nature = 1e-6;
constexpr double still_place = 1e-9;  // of the model's length
constexpr double still_strain = 1e-12;
constexpr double still_by_round_off = 10.0;

double length(const HistoryPoint::Row& row) {
    double sum = 0.0;
    for (const double component : row) sum += component * component;
    return std::sqrt(sum);
}

HistoryPoint::Row combine(const HistoryPoint::Row& one, double factor, const HistoryPoint::Row& other) {
    HistoryPoint::Row sum = one;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * other[i];
    return sum;
}

double find_scale(const Series& series, const std::vector<HistoryPoint::Row>& rows) {
    const bool is_place = series.is_length() && series.quantity != Quantity::displacement &&
                          series.quantity != Quantity::elongation;
    const bool counts_from_start = is_place || series.is_rotation();
    double scale = 0.0;
    for (const HistoryPoint::Row& row : rows) {
        scale = std::fmax(scale, counts_from_start ? distance(series, row, rows.front()) : length(row));
    }
    return series.is_rotation() ? std::fmin(scale, 1.0) : scale;
}

// Of what is large in the model.
double still_part_of(const Series& series) {
    if (series.quantity == Quantity::strain) return still_strain;
    return series.is_length() ? still_place : still_by_nature;
}

}  // namespace

double distance(const Series& series, const HistoryPoint::Row& one, const HistoryPoint::Row& other) {
    const double apart = length(combine(one, -1.0, other));
    if (!series.is_rotation()) return apart;
    // Two unit quaternions of rotations that differ by α are 2 sin(α/4) apart, if their signs are the nearer.
    const double nearer = std::fmin(apart, length(combine(one, 1.0, other)));
    return 4.0 * std::asin(std::fmin(1.0, 0.5 * nearer));
}

std::vector<double> compute_differences(const Series& series,
                                        const std::vector<HistoryPoint::Row>& one,
                                        const std::vector<HistoryPoint::Row>& other) {
    std::vector<double> differences(std::min(one.size(), other.size()));
    for (std::size_t i = 0; i < differences.size(); ++i) differences[i] = distance(series, one[i], other[i]);
    return differences;
}

bool is_same(const Series& series, const HistoryPoint::Row& one, const HistoryPoint::Row& other) {
    if (one == other) return true;
    return series.is_rotation() && one == HistoryPoint::Row{-other[0], -other[1], -other[2], -other[3]};
}

double NaturalScales::of(Quantity quantity) const {
    const auto by_length = [&](double value) { return length > 0.0 ? value / length : 0.0; };
    switch (quantity) {
        case Quantity::position:
        case Quantity::displacement:
        case Quantity::centre_of_mass:
        case Quantity::elongation:
        case Quantity::slide:
        case Quantity::gap:
        case Quantity::tendon_length:
        case Quantity::least_gap:
            return length;
        case Quantity::velocity:
        case Quantity::water_velocity:
        case Quantity::slide_rate:
            return speed;
        case Quantity::angular_velocity:
        case Quantity::angle_rate:
        case Quantity::angular_velocity_material:
            return by_length(speed);
        case Quantity::acceleration:
            return by_length(speed * speed);
        case Quantity::force:
        case Quantity::force_spatial:
        case Quantity::reaction_force:
        case Quantity::axial_force:
        case Quantity::force_a:
        case Quantity::effective_tension:
        case Quantity::wall_tension:
        case Quantity::contact_force:
        case Quantity::contact_friction:
            return by_length(energy);
        case Quantity::fluid_force:
        case Quantity::bed_force:  // of a body a force, which is larger
            return by_length(by_length(energy));
        case Quantity::moment:
        case Quantity::moment_spatial:
        case Quantity::reaction_moment:
        case Quantity::moment_a:
            return energy;
        case Quantity::curvature:
            return by_length(1.0);
        case Quantity::strain:
        case Quantity::angle:
        case Quantity::wet_fraction:
            return 1.0;
        default:
            return 0.0;
    }
}

std::vector<SeriesScale> compute_scales(const std::vector<Series>& series,
                                        const std::vector<std::vector<HistoryPoint::Row>>& rows,
                                        const NaturalScales& natural,
                                        const std::vector<double>& round_off) {
    std::vector<SeriesScale> scales(series.size());
    for (std::size_t k = 0; k < series.size(); ++k) scales[k].scale = find_scale(series[k], rows[k]);
    const std::vector<SeriesScale> own = scales;
    for (std::size_t k = 0; k < series.size(); ++k) {
        double group = 0.0;
        for (std::size_t j = 0; j < series.size(); ++j) {
            if (series[j].quantity == series[k].quantity) group = std::fmax(group, own[j].scale);
        }
        const double nature = natural.of(series[k].quantity);
        const double least =
            std::max({still * group, still_part_of(series[k]) * nature, still_by_round_off * round_off[k]});
        if (own[k].scale > least) continue;
        scales[k] = {std::fmax(group, nature), true};
        // Where nothing turns, a radian is as good a measure as any.
        if (series[k].is_rotation() && group <= still_by_round_off * round_off[k]) scales[k].scale = 1.0;
    }
    return scales;
}

}  // namespace gxrod
