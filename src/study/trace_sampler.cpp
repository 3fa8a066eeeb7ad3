#include "study/trace_sampler.hpp"

namespace gxrod {

namespace {

constexpr double same_time = 1e-9;  // relative to the end
constexpr std::size_t most_points = 4;

// The values at `time` of Lagrange's polynomials on these points.
std::vector<double> compute_weights(const std::vector<double>& points, double time) {
    std::vector<double> weights(points.size(), 1.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < points.size(); ++j) {
            if (j != i) weights[i] *= (time - points[j]) / (points[i] - points[j]);
        }
    }
    return weights;
}

}  // namespace

TraceSampler::TraceSampler(const std::vector<double>& times, double end_time)
    : times_(&times), tolerance_(same_time * end_time) {
    samples_.reserve(times.size());
}

void TraceSampler::sample_between(double time) {
    const std::vector<double> weights = compute_weights(last_times_, time);
    Rows sum(last_rows_.front().size(), HistoryRow{});
    for (std::size_t i = 0; i < weights.size(); ++i) {
        for (std::size_t k = 0; k < sum.size(); ++k) {
            for (std::size_t c = 0; c < sum[k].size(); ++c) sum[k][c] += weights[i] * last_rows_[i][k][c];
        }
    }
    samples_.push_back(std::move(sum));
}

void TraceSampler::add(double time, const Rows& rows) {
    last_times_.push_back(time);
    last_rows_.push_back(rows);
    if (last_times_.size() > most_points) {
        last_times_.erase(last_times_.begin());
        last_rows_.erase(last_rows_.begin());
    }
    while (samples_.size() < times_->size() && (*times_)[samples_.size()] <= time + tolerance_) {
        const double wanted = (*times_)[samples_.size()];
        if (wanted >= time - tolerance_) {
            samples_.push_back(rows);
        } else {
            sample_between(wanted);
        }
    }
}

}  // namespace gxrod
