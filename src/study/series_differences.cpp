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

double length(const HistoryRow& row) {
    double sum = 0.0;
    for (const double component : row) sum += component * component;
    return std::sqrt(sum);
}

// NaN where a thing has no value, such as a touch-down of a line that touches nowhere.
bool are_missing(double one, double other) { return std::isnan(one) && std::isnan(other); }

HistoryRow combine(const HistoryRow& one, double factor, const HistoryRow& other) {
    HistoryRow sum = one;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] = are_missing(one[i], other[i]) ? 0.0 : one[i] + factor * other[i];
    }
    return sum;
}

double find_scale(const Series& series, const std::vector<HistoryRow>& rows) {
    const bool counts_from_start = series.quantity->size == Size::place || series.is_rotation();
    double scale = 0.0;
    for (const HistoryRow& row : rows) {
        scale = std::fmax(scale, counts_from_start ? distance(series, row, rows.front()) : length(row));
    }
    return series.is_rotation() ? std::fmin(scale, 1.0) : scale;
}

// Whether series are of one quantity, of whatever things.
bool is_alike(const Series& one, const Series& other) {
    return std::string_view(one.quantity->word) == other.quantity->word;
}

// Of what is large in the model.
double still_part_of(const Series& series) {
    if (series.quantity->size == Size::strain) return still_strain;
    return series.is_length() ? still_place : still_by_nature;
}

}  // namespace

double distance(const Series& series, const HistoryRow& one, const HistoryRow& other) {
    const double apart = length(combine(one, -1.0, other));
    if (!series.is_rotation()) return apart;
    // Two unit quaternions of rotations that differ by α are 2 sin(α/4) apart, if their signs are the nearer.
    const double nearer = std::fmin(apart, length(combine(one, 1.0, other)));
    return 4.0 * std::asin(std::fmin(1.0, 0.5 * nearer));
}

std::vector<double> compute_differences(const Series& series,
                                        const std::vector<HistoryRow>& one,
                                        const std::vector<HistoryRow>& other) {
    std::vector<double> differences(std::min(one.size(), other.size()));
    for (std::size_t i = 0; i < differences.size(); ++i) differences[i] = distance(series, one[i], other[i]);
    return differences;
}

bool is_same(const Series& series, const HistoryRow& one, const HistoryRow& other) {
    const auto is_alike_or_missing = [](double a, double b) { return a == b || are_missing(a, b); };
    if (std::ranges::equal(one, other, is_alike_or_missing)) return true;
    return series.is_rotation() && one == HistoryRow{-other[0], -other[1], -other[2], -other[3]};
}

double NaturalScales::of(Size size) const {
    const auto by_length = [&](double value) { return length > 0.0 ? value / length : 0.0; };
    switch (size) {
        case Size::unknown:
            return 0.0;
        case Size::place:
        case Size::change:
        case Size::length:
            return length;
        case Size::speed:
            return speed;
        case Size::spin:
            return by_length(speed);
        case Size::acceleration:
            return by_length(speed * speed);
        case Size::force:
            return by_length(energy);
        case Size::line_force:
            return by_length(by_length(energy));
        case Size::moment:
            return energy;
        case Size::stress:
            return by_length(by_length(by_length(energy)));
        case Size::curvature:
            return by_length(1.0);
        case Size::strain:
        case Size::number:
            break;
    }
    return 1.0;
}

std::vector<SeriesScale> compute_scales(const std::vector<Series>& series,
                                        const std::vector<std::vector<HistoryRow>>& rows,
                                        const NaturalScales& natural,
                                        const std::vector<double>& round_off) {
    std::vector<SeriesScale> scales(series.size());
    for (std::size_t k = 0; k < series.size(); ++k) scales[k].scale = find_scale(series[k], rows[k]);
    const std::vector<SeriesScale> own = scales;
    for (std::size_t k = 0; k < series.size(); ++k) {
        double group = 0.0;
        for (std::size_t j = 0; j < series.size(); ++j) {
            if (is_alike(series[j], series[k])) group = std::fmax(group, own[j].scale);
        }
        const double nature = natural.of(series[k].quantity->size);
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
