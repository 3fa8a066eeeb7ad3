#include "elements/carried_bushing_motion.hpp"

#include "elements/bushing_motion.hpp"
#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

namespace {

using Kind = BushingTurn::Kind;

const NodeMotion& at_rest() {
    static const NodeMotion motion;
    return motion;
}

const NodeMotion& find_motion(const NodeMotion* motion) { return motion == nullptr ? at_rest() : *motion; }

double sign_of(std::size_t end) { return end == 0 ? -1.0 : 1.0; }

// The axis of the swing, as a node carries it.
Vec3 carry_axis(const Bushing& bushing, int axis, const NodeMotion& node) {
    return node.Lambda * (bushing.axes * Vec3::Unit(axis));
}

void fill_swing(const Bushing& bushing,
                int axis,
                const NodeMotion& a,
                const NodeMotion& b,
                CarriedBushingMotion& motion) {
    const Vec3 of_a = carry_axis(bushing, axis, a);
    const Vec3 of_b = carry_axis(bushing, axis, b);
    motion.turn = compute_swing(of_a, of_b);
    motion.turn_change = compute_swing_rate(of_a, of_b, a.omega, b.omega);
    motion.twist = compute_twist_direction(of_a, of_b);
}

// δe = T(e)⁻¹ δφ_B − T(e)⁻ᵀ δφ_A.
void fill_vector(const NodeMotion& a, const NodeMotion& b, CarriedBushingMotion& motion) {
    const Vec3 e = log(Quat(b.Lambda * a.Lambda.conjugate()));
    const Mat3 T = tangent_map_inverse(e);
    motion.turn = {e, {-T.transpose(), T}};
    const Mat3 by_e =
        tangent_map_inverse_derivative(e, b.omega) - tangent_map_inverse_transpose_derivative(e, a.omega);
    motion.turn_change = {T * b.omega - T.transpose() * a.omega, {-by_e * T.transpose(), by_e * T}};
}

}  // namespace

BushingTurn find_bushing_turn(const Bushing& bushing) {
    std::array<bool, 3> is_free{}, is_idle{};
    for (int axis = 0; axis < 3; ++axis) {
        is_free[axis] = bushing.leaves_turn_free(axis);
        is_idle[axis] = is_free[axis] && bushing.damping.col(3 + axis).isZero(0.0);
    }
    const auto count = [](const std::array<bool, 3>& axes) { return axes[0] + axes[1] + axes[2]; };
    const auto first = [](const std::array<bool, 3>& axes) { return axes[0] ? 0 : (axes[1] ? 1 : 2); };
    if (count(is_free) == 1) return {Kind::swing, first(is_free)};
    if (count(is_free) < 3) return {Kind::vector, 0};
    return count(is_idle) == 1 ? BushingTurn{Kind::swing, first(is_idle)} : BushingTurn{Kind::spin, 0};
}

bool carries_axes(const Bushing& bushing, std::size_t end) {
    return bushing.carrier == (end == 0 ? BushingAxes::a : BushingAxes::b);
}

CarriedBushingMotion compute_carried_motion(const Bushing& bushing,
                                            const NodeMotion* a,
                                            const NodeMotion* b) {
    const NodeMotion& at_A = find_motion(a);
    const NodeMotion& at_B = find_motion(b);
    const NodeMotion& carrier =
        carries_axes(bushing, 0) ? at_A : (carries_axes(bushing, 1) ? at_B : at_rest());
    const BushingTurn turn = find_bushing_turn(bushing);
    CarriedBushingMotion motion;
    motion.axes = (carrier.Lambda * bushing.axes).toRotationMatrix();
    motion.axes_spin = carrier.omega;
    motion.distance = compute_distance(bushing.ends, a, b);
    motion.turn_rate = at_B.omega - at_A.omega;
    if (turn.kind == Kind::swing) fill_swing(bushing, turn.axis, at_A, at_B, motion);
    if (turn.kind == Kind::vector) fill_vector(at_A, at_B, motion);
    const Mat3 to_axes = motion.axes.transpose();
    const Vec3& d = motion.distance.d;
    motion.strain << to_axes * d, to_axes * motion.turn.v;
    const Vec3 seen = turn.kind == Kind::spin
                          ? motion.turn_rate
                          : Vec3(motion.turn_change.v + motion.turn.v.cross(motion.axes_spin));
    motion.rate << to_axes * (motion.distance.rate - motion.axes_spin.cross(d)), to_axes * seen;
    if (turn.kind == Kind::swing) motion.rate[3 + turn.axis] += motion.twist.v.dot(motion.turn_rate);
    return motion;
}

std::array<Vec3, 2> distribute_moment(const Bushing& bushing,
                                      const CarriedBushingMotion& motion,
                                      const Vec3& own) {
    const BushingTurn turn = find_bushing_turn(bushing);
    const Vec3 m = motion.axes * own;
    if (turn.kind == Kind::spin) return {-m, m};
    std::array<Vec3, 2> moments;
    for (std::size_t end = 0; end < 2; ++end) {
        moments[end] = motion.turn.by[end].transpose() * m + sign_of(end) * own[turn.axis] * motion.twist.v;
        if (carries_axes(bushing, end)) moments[end] += m.cross(motion.turn.v);
    }
    return moments;
}

std::array<std::array<Mat3, 2>, 2> differentiate_moments(const Bushing& bushing,
                                                         const CarriedBushingMotion& motion,
                                                         const NodeMotion* a,
                                                         const NodeMotion* b,
                                                         const Vec3& own) {
    const Vec3 m = motion.axes * own;
    const Mat3 none = Mat3::Zero();
    std::array<std::array<Mat3, 2>, 2> by{{{none, none}, {none, none}}};
    const BushingTurn turn = find_bushing_turn(bushing);
    if (turn.kind == Kind::swing) {
        by = differentiate_swing_moments(carry_axis(bushing, turn.axis, find_motion(a)),
                                         carry_axis(bushing, turn.axis, find_motion(b)),
                                         m);
    } else if (turn.kind == Kind::vector) {
        const Vec3& e = motion.turn.v;
        const Mat3 of_A = -tangent_map_inverse_derivative(e, m);
        const Mat3 of_B = tangent_map_inverse_transpose_derivative(e, m);
        for (std::size_t j = 0; j < 2; ++j) {
            by[0][j] = of_A * motion.turn.by[j];
            by[1][j] = of_B * motion.turn.by[j];
        }
    }
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) by[i][j] += sign_of(i) * own[turn.axis] * motion.twist.by[j];
    }
    return by;
}

namespace {

BushingValues measure_between(const Bushing& bushing, const NodeMotion* a, const NodeMotion* b) {
    const BushingMotion motion = compute_bushing_motion(bushing, a, b);
    const Vec6 own = compute_bushing_force(bushing, motion);
    return {.axes = motion.axes,
            .displacement = motion.strain.head<3>(),
            .turn = motion.strain.tail<3>(),
            .force = own.head<3>(),
            .moment = take_to_rotation_vector(motion.turn, own.tail<3>())};
}

}  // namespace

BushingValues measure(const Bushing& bushing, const NodeMotion* a, const NodeMotion* b) {
    if (bushing.has_axes_between()) return measure_between(bushing, a, b);
    const CarriedBushingMotion motion = compute_carried_motion(bushing, a, b);
    const Vec6 own = bushing.stiffness * motion.strain + bushing.damping * motion.rate;
    const Vec3 on_B = distribute_moment(bushing, motion, own.tail<3>())[1];
    return {.axes = motion.axes,
            .displacement = motion.strain.head<3>(),
            .turn = motion.strain.tail<3>(),
            .force = own.head<3>(),
            .moment = motion.axes.transpose() * on_B};
}

}  // namespace gxrod
