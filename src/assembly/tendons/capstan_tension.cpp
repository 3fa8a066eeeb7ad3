#include "assembly/tendons/capstan_tension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/evaluation_error.hpp"

namespace gxrod {
namespace {

constexpr double still_sticking = 1e-13;  // of a tension
constexpr double straight = 1e-12;        // sine of an angle that is round-off
constexpr double no_tension = 1e-12;      // of the rod's axial stiffness

// The angle between two directions, and its derivatives by vectors that have them.
struct Turning {
    double angle;
    Vec3 by_one, by_other;
};

Turning find_turning(const Vec3& one, const Vec3& other) {
    const double length = one.norm(), other_length = other.norm();
    if (!(length > 0.0) || !(other_length > 0.0)) return {0.0, Vec3::Zero(), Vec3::Zero()};
    const Vec3 from = one / length, to = other / other_length;
    const Vec3 normal = from.cross(to);
    const double sine = normal.norm();
    Turning turning{std::atan2(sine, from.dot(to)), Vec3::Zero(), Vec3::Zero()};
    if (sine < straight) return turning;
    turning.by_one = from.cross(normal) / (sine * length);
    turning.by_other = normal.cross(to) / (sine * other_length);
    return turning;
}

}  // namespace

struct CapstanTension::Sweep {
    std::vector<TendonTangent> tangents;
    std::vector<double> tensions;
    Eigen::MatrixXd derivatives;  // of each tension a row, if asked for
};

CapstanTension::CapstanTension(const Model& model, const Tendon& tendon, std::size_t first)
    : name_("tendon " + tendon.name),
      tendon_(&tendon),
      line_(model, tendon),
      start_stretches_(line_.start_stretches()),
      first_memory_(first) {
    if (!tendon.friction->is_pulled_at_start) std::ranges::reverse(start_stretches_);
    const Rod& rod = model.rods[static_cast<std::size_t>(tendon.rod)];
    round_off_ = no_tension * model.sections[static_cast<std::size_t>(rod.section)].stiffness(0, 0);
}

double CapstanTension::find_pull(double time) const {
    const double pull = tendon_->tension(time);
    if (pull < -round_off_)
        throw EvaluationError(
            fmt::format("tendon.{}.tension is {} at t = {}: with friction a tendon only pulls",
                        tendon_->name,
                        pull,
                        time));
    return std::max(pull, 0.0);
}

std::vector<TendonTangent> CapstanTension::list_tangents(const std::vector<NodeMotion>& motions,
                                                         const State& state,
                                                         bool with_gradients) const {
    std::vector<TendonTangent> tangents = line_.list_tangents(motions, state, with_gradients);
    if (!tendon_->friction->is_pulled_at_start) std::ranges::reverse(tangents);
    return tangents;
}

std::vector<double> CapstanTension::find_sticking(const std::vector<TendonTangent>& tangents,
                                                  const State& state) const {
    const std::span<const double> before = memory().of(state);
    std::vector<double> sticking(before.begin(), before.end());
    const double stiffness = tendon_->friction->stiffness;
    if (stiffness == 0.0) return sticking;
    const std::vector<TendonTangent> previous = list_tangents(state.previous, state, false);
    for (std::size_t i = 0; i < start_stretches_.size(); ++i) {
        const double change = tangents[i + 1].slope.norm() - previous[i + 1].slope.norm();
        sticking[i] += stiffness * change / start_stretches_[i];
        // The anchor is where the last force point's part ends.
        if (i + 1 == start_stretches_.size()) sticking[i + 1] += stiffness * change / start_stretches_[i];
    }
    return sticking;
}

auto CapstanTension::sweep(const std::vector<NodeMotion>& motions,
                           const State& state,
                           double time,
                           bool with_gradients) const -> Sweep {
    const auto& [friction, stiffness, is_pulled_at_start] = *tendon_->friction;
    Sweep sweep{list_tangents(motions, state, with_gradients), {}, {}};
    const std::vector<double> sticking = find_sticking(sweep.tangents, state);
    double tension = find_pull(time);
    Eigen::RowVectorXd derivative;
    if (with_gradients) {
        derivative.setZero(6 * static_cast<Eigen::Index>(nodes().size()));
        sweep.derivatives.resize(static_cast<Eigen::Index>(count()), derivative.size());
    }
    for (std::size_t i = 0; i < count(); ++i) {
        const TendonTangent &from = sweep.tangents[i], &to = sweep.tangents[i + 1];
        const Turning turning = find_turning(from.slope, to.slope);
        const double share = std::exp(friction * turning.angle);
        const double least = tension / share, most = tension * share;
        // −1 where it slips to where it is pulled, 1 where it slips from there, 0 where it sticks.
        const double slips = sticking[i] < least * (1.0 - still_sticking)  ? -1.0
                             : sticking[i] > most * (1.0 + still_sticking) ? 1.0
                                                                           : 0.0;
        if (with_gradients) {
            if (slips != 0.0) {
                derivative = (slips < 0.0 ? 1.0 / share : share) *
                             (derivative + slips * friction * tension *
                                               (turning.by_one.transpose() * from.gradient +
                                                turning.by_other.transpose() * to.gradient));
            } else {
                const std::size_t point = std::min(i, start_stretches_.size() - 1);
                const TendonTangent& own = sweep.tangents[point + 1];
                derivative =
                    stiffness / start_stretches_[point] * own.slope.normalized().transpose() * own.gradient;
            }
            sweep.derivatives.row(static_cast<Eigen::Index>(i)) = derivative;
        }
        tension = slips < 0.0 ? least : slips > 0.0 ? most : sticking[i];
        sweep.tensions.push_back(tension);
    }
    return sweep;
}

std::vector<double> CapstanTension::compute(const std::vector<NodeMotion>& motions,
                                            const State& state,
                                            double time) const {
    return sweep(motions, state, time, false).tensions;
}

Eigen::MatrixXd CapstanTension::compute_coupling(const std::vector<NodeMotion>& motions,
                                                 const State& state,
                                                 double time) const {
    const Sweep all = sweep(motions, state, time, true);
    const auto points = static_cast<Eigen::Index>(start_stretches_.size());
    Eigen::MatrixXd lengths(all.derivatives.cols(), points);
    for (Eigen::Index i = 0; i < points; ++i) {
        const TendonTangent& point = all.tangents[static_cast<std::size_t>(i) + 1];
        lengths.col(i) = point.weight * point.gradient.transpose() * point.slope.normalized();
    }
    return lengths * all.derivatives.topRows(points);
}

std::vector<double> CapstanTension::along_rod(std::span<const double> tensions) const {
    std::vector<double> along(tensions.begin(), tensions.end() - 1);
    if (!tendon_->friction->is_pulled_at_start) std::ranges::reverse(along);
    return along;
}

std::vector<CapstanTension> list_capstan_tensions(const Model& model) {
    std::vector<CapstanTension> tensions;
    for (const Tendon& tendon : model.tendons) {
        if (tendon.friction)
            tensions.emplace_back(model, tendon, tensions.empty() ? 0 : tensions.back().memory().end());
    }
    return tensions;
}

CapstanTensions::CapstanTensions(const Model& model) {
    std::vector<CapstanTension> tensions = list_capstan_tensions(model);
    auto next = tensions.begin();
    for (std::size_t i = 0; i < model.tendons.size(); ++i) {
        if (model.tendons[i].friction) entries_.push_back({i, std::move(*next++)});
    }
}

std::size_t CapstanTensions::memory_count() const {
    return empty() ? 0 : entries_.back().tension.memory().end();
}

void CapstanTensions::set_tensions(const std::vector<NodeMotion>& motions,
                                   const State& state,
                                   double time,
                                   DriveValues& drives) const {
    for (const auto& [tendon, tension] : entries_)
        drives.set_tensions(tendon, tension.along_rod(tension.compute(motions, state, time)));
}

void CapstanTensions::commit(State& state, double time) const {
    for (const Entry& entry : entries_)
        std::ranges::copy(entry.tension.compute(state.trial, state, time),
                          entry.tension.memory().of(state).begin());
}

std::optional<double> CapstanTensions::find_end_tension(std::size_t tendon,
                                                        const State& state,
                                                        double time) const {
    for (const Entry& entry : entries_) {
        if (entry.tendon == tendon) return entry.tension.compute(state.trial, state, time).back();
    }
    return std::nullopt;
}

}  // namespace gxrod
