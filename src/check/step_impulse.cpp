#include "check/step_impulse.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gxrod {

namespace {

constexpr double most_lost = 0.3;
// Of ∫ |f| dt: less can be round-off.
constexpr double smallest_loss = 1e-6;
constexpr double steps_around = 5.0;
constexpr std::size_t most_windows = 100;
constexpr double steps_of_block = 8.0;
constexpr double most_blocks = 25.0;
constexpr int most_halvings = 30;

// A time of whole steps, by their numbers.
struct Window {
    double first = 0.0;
    double last = 0.0;
};

// Of a window: sums over its steps.
struct Sums {
    double given = 0.0;
    double exact = 0.0;
    double wrong = 0.0;  // the sum of the steps' errors' sizes
    double above = 0.0;  // ∫ |f − the straight line from end to end| dt
    double size = 0.0;   // ∫ |f| dt
};

class StepSums {
  public:
    StepSums(const TimedLoad& load, const StepTimes& times, const Integrator& integrator)
        : load_(load), times_(times), integrator_(integrator), weights_(integrator.power_weights()) {}

    double count() const { return std::max(1.0, std::round(times_.end_time / times_.time_step)); }
    double time_of(double step) const { return step >= count() ? times_.end_time : step * times_.time_step; }

    Sums add_up(const Window& window) const {
        Sums sums;
        const double from = time_of(window.first);
        const double to = time_of(window.last);
        const double start = load_.value(from);
        const double slope = (load_.value(to) - start) / (to - from);
        for (double step = window.first; step < window.last; ++step) {
            const double given = give(step);
            const Sums own = integrate(step, [&](double t) { return start + slope * (t - from); });
            sums.given += given;
            sums.exact += own.exact;
            sums.wrong += std::abs(given - own.exact);
            sums.above += own.above;
            sums.size += own.size;
        }
        return sums;
    }

  private:
    // What the scheme makes of a step.
    double give(double step) const {
        const double from = time_of(step);
        const double size = time_of(step + 1.0) - from;
        const auto value_at = [&](double fraction) {
            return load_.value(fraction == 1.0 ? time_of(step + 1.0) : from + fraction * size);
        };
        if (weights_.empty()) return 0.5 * size * (value_at(0.0) + value_at(1.0));
        double sum = weights_.front() * value_at(0.0);
        for (std::size_t i = 1; i < weights_.size(); ++i) {
            sum += weights_[i] * value_at(integrator_.stage_fraction(static_cast<int>(i) - 1));
        }
        return size * sum;
    }

    // The integrals over a step, by Gauss' rule of three points between breaks.
    template <class Line>
    Sums integrate(double step, const Line& line) const {
        const double end = time_of(step + 1.0);
        double from = time_of(step);
        Sums sums;
        auto next = std::upper_bound(load_.breaks.begin(), load_.breaks.end(), from);
        while (from < end) {
            const double to = next == load_.breaks.end() ? end : std::min(*next++, end);
            static const std::array<std::array<double, 2>, 3> rule{
                {{-std::sqrt(0.6), 5.0 / 18.0}, {0.0, 4.0 / 9.0}, {std::sqrt(0.6), 5.0 / 18.0}}};
            for (const auto& [xi, weight] : rule) {
                const double at = 0.5 * (from + to) + 0.5 * (to - from) * xi;
                const double value = load_.value(at);
                sums.exact += weight * (to - from) * value;
                sums.above += weight * (to - from) * std::abs(value - line(at));
                sums.size += weight * (to - from) * std::abs(value);
            }
            from = to;
        }
        return sums;
    }

    const TimedLoad& load_;
    StepTimes times_;
    const Integrator& integrator_;
    std::vector<double> weights_;
};

// Near a break, errors of both signs can cancel: a pulse from one step to another one.
double lost_at_break(const Sums& sums) { return std::abs(sums.given - sums.exact); }
double lost_in_block(const Sums& sums) { return sums.wrong; }

Window window_around(double time, const StepSums& steps, double time_step) {
    const double step = std::floor(time / time_step);
    return {std::max(0.0, step - steps_around), std::min(steps.count(), step + 1.0 + steps_around)};
}

class ImpulseSearch {
  public:
    ImpulseSearch(const TimedLoad& load, const StepTimes& times, const Integrator& integrator)
        : load_(load), times_(times), integrator_(integrator), steps_(load, times, integrator) {}

    std::optional<LostImpulse> run() {
        const std::size_t stride = (load_.breaks.size() + most_windows - 1) / most_windows;
        for (std::size_t i = 0; i < load_.breaks.size(); i += std::max<std::size_t>(stride, 1)) {
            look(window_around(load_.breaks[i], steps_, times_.time_step), lost_at_break);
        }
        const double blocks = std::min(most_blocks, std::floor(steps_.count() / steps_of_block));
        for (double i = 0.0; load_.breaks.empty() && i < blocks; ++i) {
            const double first =
                std::floor(i * (steps_.count() - steps_of_block) / std::max(blocks - 1.0, 1.0));
            look({first, first + steps_of_block}, lost_in_block);
        }
        if (!worst_) return std::nullopt;
        worst_->step_needed = find_step_needed();
        return worst_;
    }

  private:
    static bool is_lost(double lost, const Sums& sums) {
        return lost > most_lost * sums.above && lost > smallest_loss * sums.size;
    }

    void look(const Window& window, double (*lost_of)(const Sums&)) {
        const Sums sums = steps_.add_up(window);
        const double lost = lost_of(sums);
        if (!is_lost(lost, sums) || lost <= worst_lost_) return;
        worst_lost_ = lost;
        worst_ =
            LostImpulse{steps_.time_of(window.first), steps_.time_of(window.last), sums.given, sums.exact};
        lost_of_ = lost_of;
    }

    // By halving the step until nothing is lost where most was, nor with the next half: one may do so by
    // chance.
    double find_step_needed() const {
        double step = times_.time_step;
        int good = 0;
        for (int i = 0; i < most_halvings && good < 2; ++i) {
            step *= 0.5;
            good = loses(StepSums(load_, {times_.end_time, step}, integrator_), step) ? 0 : good + 1;
        }
        return good < 2 ? step : 2.0 * step;
    }

    bool loses(const StepSums& finer, double step) const {
        const auto loses_in = [&](const Window& window) {
            const Sums sums = finer.add_up(window);
            return is_lost(lost_of_(sums), sums);
        };
        if (load_.breaks.empty()) {
            const double first = std::floor(worst_->from / step);
            return loses_in({first, std::min(first + steps_of_block, finer.count())});
        }
        return std::any_of(load_.breaks.begin(), load_.breaks.end(), [&](double at) {
            return at >= worst_->from && at <= worst_->to && loses_in(window_around(at, finer, step));
        });
    }

    const TimedLoad& load_;
    StepTimes times_;
    const Integrator& integrator_;
    StepSums steps_;
    std::optional<LostImpulse> worst_;
    double worst_lost_ = 0.0;
    double (*lost_of_)(const Sums&) = lost_at_break;
};

}  // namespace

std::optional<LostImpulse> find_lost_impulse(const TimedLoad& load,
                                             const StepTimes& times,
                                             const Integrator& integrator) {
    return ImpulseSearch(load, times, integrator).run();
}

}  // namespace gxrod
