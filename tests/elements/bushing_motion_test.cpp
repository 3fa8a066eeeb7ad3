#include "elements/bushing_motion.hpp"

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// A node in smooth motion.
struct Path {
    Vec3 r, v, spin;
    Quat Lambda;

    explicit Path(RandomValues& random)
        : r(random.vector()), v(random.vector()), spin(random.vector()), Lambda(random.rotation()) {}
    NodeMotion at(double t) const {
        NodeMotion motion;
        motion.r = r + t * v;
        motion.v = v;
        motion.Lambda = exp_quaternion(t * spin) * Lambda;
        motion.omega = spin;
        return motion;
    }
};

Bushing make_bushing(RandomValues& random) {
    Bushing bushing;
    bushing.ends = {Anchor{0, random.vector()}, Anchor{1, random.vector()}};
    bushing.axes = random.rotation();
    return bushing;
}

}  // namespace

TEST_CASE("a bushing's strain is what B has moved against A, half way between their axes", "[elements]") {
    RandomValues random(4);
    const Bushing bushing = make_bushing(random);
    const NodeMotion a = Path(random).at(0.0);
    const NodeMotion b = Path(random).at(0.0);
    const BushingMotion motion = compute_bushing_motion(bushing, &a, &b);
    const Vec3 Phi = motion.strain.tail<3>();
    const Mat3 of_A = (a.Lambda * bushing.axes).toRotationMatrix();
    const Mat3 of_B = (b.Lambda * bushing.axes).toRotationMatrix();
    CHECK((of_A * exp_matrix(Phi) - of_B).norm() < 1e-14);
    CHECK((motion.axes - of_A * exp_matrix(0.5 * Phi)).norm() < 1e-14);
    const Vec3 apart = b.r + b.Lambda * bushing.ends[1].arm - a.r - a.Lambda * bushing.ends[0].arm;
    CHECK((motion.axes * motion.strain.head<3>() - apart).norm() < 1e-14);
}

TEST_CASE("the rate of a bushing's strain is its derivative", "[elements]") {
    RandomValues random(5);
    for (int trial = 0; trial < 4; ++trial) {
        const Bushing bushing = make_bushing(random);
        const Path a(random);
        const Path b(random);
        const auto strain_at = [&](double t) {
            const NodeMotion at_A = a.at(t);
            const NodeMotion at_B = b.at(t);
            return compute_bushing_motion(bushing, &at_A, &at_B);
        };
        if (strain_at(0.0).turn.Phi.norm() > 2.8) continue;  // near half a turn it jumps
        const Vec6 rate = differentiate([&](double t) { return Vec6(strain_at(t).strain); });
        CHECK(relative_difference(strain_at(0.0).rate, rate) < 1e-8);
    }
}
