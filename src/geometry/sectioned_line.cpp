#include "geometry/sectioned_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "geometry/catenary.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

// How often the ends are corrected at most by what rounds take away, and how closely.
constexpr int most_corrections = 30;
constexpr double close_ends = 1e-10;  // relative to the length
constexpr int gathered_points = 64;

double upright_at(const LinePiece& piece, double s) { return piece.upright + piece.weight * (s - piece.s); }

}  // namespace

SectionedLine::SectionedLine(const Ends& ends) : from_(ends.from), to_(ends.to), level_(Vec3::UnitX()) {
    if (ends.bed && std::min(from_.z(), to_.z()) < *ends.bed) {
        throw std::invalid_argument(
            fmt::format("an end of the line lies below the bed, z = {:.6g}", *ends.bed));
    }
    const Vec3 between = to_ - from_;
    SuspendedLine line{std::hypot(between.x(), between.y()), between.z(), ends.stretches};
    if (line.span > 0.0) level_ = Vec3(between.x(), between.y(), 0.0) / line.span;
    if (ends.bed) line.bed = *ends.bed - from_.z();
    if (ends.surface) line.surface = *ends.surface - from_.z();
    for (LineStretch& stretch : line.stretches) {
        length_ += stretch.length;
        if (!stretch.end_weight) continue;
        stretch.end_weight = [weight = stretch.end_weight, start = from_.z()](double z) {
            return weight(start + z);
        };
    }
    hang(line, ends.kink);
    sum_turns();
}

void SectionedLine::hang(const SuspendedLine& line, const LineKink& kink) {
    Shift behind = Shift::Zero();
    for (int i = 0; i < most_corrections; ++i) {
        SuspendedLine longer = line;
        longer.span = std::max(longer.span - behind.x(), 0.0);
        longer.rise -= behind.y();
        line_ = find_line_equilibrium(longer);
        find_rounds(kink);
        const Shift before = behind;
        behind.setZero();
        for (const Round& round : rounds_) behind += round.behind;
        if ((behind - before).norm() <= close_ends * length_) return;
    }
}

// ∫ (t(θ + δ) − t(θ)) (1 + ε) ds from far away to a place, with du/u in place of ds for the faded turn u.
SectionedLine::Shift SectionedLine::gather(const Round& round, double place, bool is_before) const {
    const double most = round.fade(place);
    Shift sum = Shift::Zero();
    for (int i = 0; i < gathered_points; ++i) {
        const double u = most * (i + 0.5) / gathered_points;
        const double away = -round.length * std::log(u);
        const double s = std::clamp(is_before ? round.s - away : round.s + away, 0.0, length_);
        const double angle = plain_angle(s), turn = (is_before ? round.half : -round.half) * u;
        const double stretch = (1.0 + tension(s) * piece_at(s).compliance) / u;
        sum += stretch *
               Shift(std::cos(angle + turn) - std::cos(angle), std::sin(angle + turn) - std::sin(angle));
    }
    return round.length * most / gathered_points * sum;
}

SectionedLine::Shift SectionedLine::shift_at(const Round& round, double place) const {
    if (place < round.s) return gather(round, place, true);
    return round.behind - gather(round, place, false);
}

const LinePiece& SectionedLine::piece_at(double s) const {
    const auto after = std::ranges::upper_bound(line_.pieces, s, {}, &LinePiece::s);
    return after == line_.pieces.begin() ? line_.pieces.front() : *(after - 1);
}

double SectionedLine::tension(double s) const { return std::hypot(line_.level, upright_at(piece_at(s), s)); }

void SectionedLine::find_rounds(const LineKink& kink) {
    rounds_.clear();
    for (std::size_t i = 1; i < line_.pieces.size(); ++i) {
        const LinePiece& piece = line_.pieces[i];
        if (!piece.kinks) continue;
        const double before = std::atan2(upright_at(line_.pieces[i - 1], piece.s), line_.level);
        const double after = std::atan2(piece.upright, line_.level);
        Round round{piece.s,
                    std::max(std::sqrt(kink.bending / tension(piece.s)), kink.reach),
                    0.5 * (after - before)};
        round.behind = gather(round, piece.s, true) + gather(round, piece.s, false);
        rounds_.push_back(round);
    }
}

double SectionedLine::plain_angle(double s) const {
    return std::atan2(upright_at(piece_at(s), s), line_.level);
}

double SectionedLine::angle(double s) const {
    double angle = plain_angle(s);
    for (const Round& round : rounds_) angle += round.turn_at(s);
    return angle;
}

Vec3 SectionedLine::position(double s) const {
    if (s <= 0.0) return from_;
    if (s >= length_) return to_;
    const LinePiece& piece = piece_at(s);
    const double along = s - piece.s;
    const auto [x, z] = Catenary{piece.upright / line_.level, piece.weight / line_.level}.point_at(along);
    Vec3 place(piece.x + x + line_.level * along * piece.compliance,
               0.0,
               piece.z + z + along * (piece.upright + 0.5 * piece.weight * along) * piece.compliance);
    for (const Round& round : rounds_) {
        const Shift shift = shift_at(round, s);
        place += Vec3(shift.x(), 0.0, shift.y());
    }
    return from_ + place.x() * level_ + place.z() * Vec3::UnitZ();
}

Vec3 SectionedLine::tangent(double s) const {
    const double at = angle(s);
    return std::cos(at) * level_ + std::sin(at) * Vec3::UnitZ();
}

Quat SectionedLine::transport(double s) const {
    return exp_quaternion((angle(s) - angle(0.0)) * level_.cross(Vec3::UnitZ()));
}

void SectionedLine::sum_turns() {
    turns_.push_back(0.0);
    for (std::size_t i = 1; i < line_.pieces.size(); ++i) {
        const LinePiece& before = line_.pieces[i - 1];
        const double end = std::atan2(upright_at(before, line_.pieces[i].s), line_.level);
        turns_.push_back(turns_.back() + std::abs(end - plain_angle(before.s)));
    }
}

double SectionedLine::turn(double s) const {
    const LinePiece& piece = piece_at(s);
    const auto index = static_cast<std::size_t>(&piece - line_.pieces.data());
    double turn = turns_[index] + std::abs(plain_angle(s) - plain_angle(piece.s));
    for (const Round& round : rounds_) turn += round.turned_up_to(s) - round.turned_up_to(0.0);
    return turn;
}

}  // namespace gxrod
