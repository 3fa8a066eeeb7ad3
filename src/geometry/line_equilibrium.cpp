#include "geometry/line_equilibrium.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "geometry/catenary.hpp"
#include "geometry/rising_root.hpp"

namespace gxrod {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double equilibrium_round_off = 1e-13;  // of lengths, relative to that of the line
constexpr double close_length = 1e-6;            // likewise
constexpr double least_level = 1e-9;             // level tension, relative to the weights
constexpr double most_log_level = 35.0;
constexpr int most_pieces = 100'000;  // of a line that crosses the surface again and again

double find_length(const SuspendedLine& line) {
    return std::accumulate(
        line.stretches.begin(), line.stretches.end(), 0.0, [](double sum, const LineStretch& one) {
            return sum + one.length;
        });
}

std::string describe_short(const SuspendedLine& line) {
    return fmt::format("the line's length, {:.6g}, is less than the distance of its ends, {:.6g}",
                       find_length(line),
                       std::hypot(line.span, line.rise));
}

// A place that a line has come to: behind `offset` of a stretch, before the weight at the stretch's end.
struct Reached {
    std::size_t stretch = 0;
    double offset = 0.0;
    double s = 0.0, x = 0.0, z = 0.0;
    double upright = 0.0;  // of what lies: less than 0 by what more weight has to follow before it lifts
    bool lies = false;
    bool dips = false;  // below the bed
};

// Follows a line from its start for a level tension.
class Follower {
  public:
    Follower(const SuspendedLine& line, double level)
        : line_(line), level_(level), tolerance_(equilibrium_round_off * find_length(line)) {}

    Reached start() const {
        Reached start;
        start.lies = line_.bed && *line_.bed >= -tolerance_;
        return start;
    }

    // Follows the line from a place with an upright tension there, to its end or to the lowest place of a
    // part that is below the bed; or to `until`. Adds the pieces to `pieces`, if there are any.
    Reached follow(Reached at, double upright, const Reached* until, std::vector<LinePiece>* pieces) const {
        at.upright = upright;
        bool kinks = false;
        for (int count = 0; at.stretch < line_.stretches.size(); ++count) {
            const LineStretch& stretch = line_.stretches[at.stretch];
            double end = stretch.length;
            const bool is_last = until != nullptr && until->stretch == at.stretch;
            if (is_last) end = until->offset;
            if (at.offset < end) {
                const LinePiece piece = advance(end, at, until != nullptr);
                if (pieces != nullptr && at.s > piece.s) {
                    pieces->push_back(piece);
                    pieces->back().kinks = std::exchange(kinks, false);
                }
                if (at.dips || count > most_pieces) return at;
                if (at.offset < end) continue;
            }
            if (is_last || pass_end(stretch, until != nullptr, at)) return at;
            kinks = stretch.end_weight != nullptr && !at.lies;
        }
        return at;
    }

  private:
    bool is_below_bed(double z) const { return line_.bed && z < *line_.bed - tolerance_; }

    // The weight that acts from a place on.
    double weight_from(const Reached& at, const LineStretch& stretch) const {
        if (!line_.surface) return stretch.weight;
        const double above = at.z - *line_.surface;
        const bool is_dry = std::abs(above) <= tolerance_ ? at.upright > 0.0 : above > 0.0;
        return is_dry ? stretch.dry_weight : stretch.weight;
    }

    LinePiece advance(double end, Reached& at, bool is_known) const {
        const double most = end - at.offset;
        const LineStretch& stretch = line_.stretches[at.stretch];
        const double weight = weight_from(at, stretch);
        if (at.lies && at.upright > 0.0) at.lies = false;
        LinePiece piece{at.s, at.x, at.z, at.upright, weight, stretch.compliance};
        double run = most;
        if (at.lies) {
            piece.lies = true;
            piece.upright = piece.weight = 0.0;
            at.dips = weight < 0.0 && !is_known;
            const double lifts = weight > 0.0 ? -at.upright / weight : endless;
            if (lifts < most) {
                run = lifts;
                at.lies = false;
            }
            at.x += run * (1.0 + level_ * stretch.compliance);
            at.upright = at.lies ? at.upright + weight * run : 0.0;
            pass(run, end, at);
            return piece;
        }
        run = std::min(run, find_surface(at, weight, stretch.compliance));
        const double lowest = weight > 0.0 ? -at.upright / weight : endless;
        if (!is_known && lowest > 0.0 && lowest < run &&
            is_below_bed(at.z + rise(at.upright, weight, stretch.compliance, lowest))) {
            run = lowest;
            at.dips = true;
        }
        const Catenary catenary{at.upright / level_, weight / level_};
        at.x += catenary.point_at(run).x + level_ * run * stretch.compliance;
        at.z += rise(at.upright, weight, stretch.compliance, run);
        at.upright = at.dips ? 0.0 : at.upright + weight * run;
        pass(run, end, at);
        return piece;
    }

    // The end of a stretch is to be met to the last bit.
    static void pass(double run, double end, Reached& at) {
        at.offset = run == end - at.offset ? end : at.offset + run;
        at.s += run;
    }

    double rise(double upright, double weight, double compliance, double s) const {
        const Catenary catenary{upright / level_, weight / level_};
        return catenary.point_at(s).z + s * (upright + 0.5 * weight * s) * compliance;
    }

    // How far it is to the surface: with E = √(H² + V²), z rises by ΔE/w + ΔE²/(2 EA w).
    double find_surface(const Reached& at, double weight, double compliance) const {
        if (!line_.surface) return endless;
        const double above = *line_.surface - at.z;
        const double tension = std::hypot(level_, at.upright);
        const auto ahead = [&](double s) { return s > tolerance_ ? s : endless; };
        if (weight == 0.0) return ahead(above / (at.upright * (1.0 / tension + compliance)));
        const double factor = 1.0 + tension * compliance;
        const double root = factor * factor + 2.0 * weight * above * compliance;
        if (root < 0.0) return endless;
        const double there = tension + 2.0 * weight * above / (factor + std::sqrt(root));
        if (there < level_) return endless;
        const double upright = std::sqrt((there - level_) * (there + level_));
        return std::min(ahead((upright - at.upright) / weight), ahead((-upright - at.upright) / weight));
    }

    // Goes on to the next stretch. Returns true at the lowest place of a part that is below the bed.
    bool pass_end(const LineStretch& stretch, bool is_known, Reached& at) const {
        double upright = at.upright;
        if (stretch.end_weight) {
            const double weight = stretch.end_weight(at.z);
            upright += weight;
            at.dips = !is_known && at.lies && weight < 0.0;
        }
        const bool is_end = at.stretch + 1 == line_.stretches.size();
        at.dips = at.dips || (!is_known && !is_end && !at.lies && at.upright <= 0.0 && upright > 0.0 &&
                              is_below_bed(at.z));
        if (at.dips) return true;
        at.upright = upright;
        ++at.stretch;
        at.offset = 0.0;
        return false;
    }

    const SuspendedLine& line_;
    double level_;
    double tolerance_;
};

// The whole line for a level tension.
class Profile {
  public:
    Profile(const SuspendedLine& line, double weights)
        : line_(line), weights_(weights), length_(find_length(line)) {}

    // Finds x of the end; the pieces are those of the line then.
    double find_span(double level) {
        pieces_.clear();
        const Follower follower(line_, level);
        Reached from = follower.start();
        double most = endless;  // of the upright tension from there
        for (std::size_t part = 0; part <= 2 * line_.stretches.size(); ++part) {
            const auto [upright, dip] = find_upright(follower, from, level, most);
            const Reached at = follower.follow(from, upright, dip ? &*dip : nullptr, &pieces_);
            if (!dip) return at.x;
            from = *dip;
            from.x = at.x;
            from.z = *line_.bed;
            from.lies = true;
            from.dips = false;
            most = at.upright;
        }
        throw std::invalid_argument("the line would lie on the bed in more parts than it has sections");
    }
    const std::vector<LinePiece>& pieces() const { return pieces_; }

  private:
    struct Found {
        double upright;
        std::optional<Reached> dip;  // where the line comes down to the bed; nullopt if it comes to its end
    };

    // Finds the upright tension by which the line comes to its end, or, if it cannot without going below the
    // bed, the least one by which it does not.
    Found find_upright(const Follower& follower, const Reached& from, double level, double most) const {
        std::optional<Reached> dip;
        const auto miss = [&](double upright) {
            const Reached at = follower.follow(from, upright, nullptr, nullptr);
            if (at.dips) {
                dip = at;
                return -endless;
            }
            if (at.z < line_.rise) dip.reset();
            return at.z - line_.rise;
        };
        const double scale = weights_ + level;
        const RisingRoot root = find_rising_root(
            miss, {-scale, std::min(most, scale)}, most, equilibrium_round_off * length_, 1e-15 * scale);
        if (root.is_never) throw std::invalid_argument(describe_short(line_));
        const bool is_jump = root.gap > close_length * length_;
        if (is_jump && dip) return {root.above, dip};
        if (is_jump) {
            throw std::invalid_argument(
                "a part of the line would float on the surface, with which a catenary is not drawn; expected "
                "another curve, from which a static stage finds it");
        }
        return {root.best, std::nullopt};
    }

    const SuspendedLine& line_;
    double weights_, length_;
    std::vector<LinePiece> pieces_;
};

// Whether a line turns back on itself.
bool folds(const std::vector<LinePiece>& pieces, double length) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double end = i + 1 < pieces.size() ? pieces[i + 1].s : length;
        if (pieces[i].upright * (pieces[i].upright + pieces[i].weight * (end - pieces[i].s)) < 0.0)
            return true;
    }
    return false;
}

}  // namespace

LineEquilibrium find_line_equilibrium(const SuspendedLine& line) {
    const double length = find_length(line);
    double weights = 0.0;
    for (const LineStretch& one : line.stretches) {
        weights += one.length * std::max(std::abs(one.weight), std::abs(one.dry_weight));
        if (one.end_weight) weights += std::abs(one.end_weight(line.rise));
    }
    Profile profile(line, weights);
    const auto miss = [&](double log_level) { return profile.find_span(std::exp(log_level)) - line.span; };
    double log_level = std::log(least_level * weights);
    const double excess = miss(log_level);
    if (excess > close_length * length ||
        (line.span <= close_length * length && folds(profile.pieces(), length))) {
        throw std::invalid_argument(fmt::format(
            "the line's length, {:.6g}, is more than hangs or lies in tension between its ends, {:.6g} apart",
            length,
            std::hypot(line.span, line.rise)));
    }
    if (excess < 0.0) {
        const double half = std::log(0.5 * weights);
        const RisingRoot root = find_rising_root(miss,
                                                 {half - 1.0, half + 1.0},
                                                 half + most_log_level,
                                                 10.0 * equilibrium_round_off * length,
                                                 1e-15);
        if (root.is_never) throw std::invalid_argument(describe_short(line));
        log_level = root.best;
    }
    profile.find_span(std::exp(log_level));
    return {std::exp(log_level), profile.pieces()};
}

}  // namespace gxrod
