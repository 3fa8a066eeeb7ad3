#include "loads/nodal_load.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE("the tangent of a force by motion is its derivative", "[loads]") {
    RandomValues random(3);
    NodalLoad load;
    load.frame = Frame::body;
    load.axes = random.rotation();
    const Mat3 by_place = random.matrix<3>();
    const Mat3 by_velocity = random.matrix<3>();
    load.motion_force = [&](double time, const Vec3& r, const Vec3& v) {
        return Vec3(time * by_place * r * r.norm() + by_velocity * v * v.norm());
    };
    NodeMotion motion;
    motion.r = random.vector();
    motion.Lambda = random.rotation();
    motion.v = random.vector();
    for (const auto& [placement, rate] : {std::pair(1.0, 0.0), {0.0, 1.7}, {1.0, 1.7}}) {
        NodeLinearization linearization;
        linearization.placement = placement;
        linearization.rate = rate;
        Mat3 expected;
        for (int i = 0; i < 3; ++i) {
            expected.col(i) = differentiate([&](double amount) {
                NodeMotion moved = motion;
                moved.r += placement * amount * Vec3::Unit(i);
                moved.v += rate * amount * Vec3::Unit(i);
                return Vec3(compute_load(load, moved, 0.7).head<3>());
            });
        }
        const Mat3 tangent = compute_motion_force_tangent(load, motion, linearization, 0.7, 2.0);
        CHECK(relative_difference(tangent, expected) < 1e-8);
    }
}
