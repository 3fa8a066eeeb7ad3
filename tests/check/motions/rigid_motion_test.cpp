#include "check/motions/rigid_motion.hpp"

#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

State make_state(std::size_t nodes) {
    RandomValues random(4);
    State state;
    state.trial.resize(nodes);
    for (NodeMotion& motion : state.trial) motion.r = random.vector(5.0);
    return state;
}

}  // namespace

TEST_CASE("a rigid motion is found again, whatever moves elsewhere", "[check]") {
    RandomValues random(5);
    const State state = make_state(6);
    const ModelPart part{{1, 2, 4}, {}, {}};
    const RigidMotion motion{random.vector(), random.vector(), random.vector()};
    std::vector<Vec6> direction = compute_direction(motion, part, state, 3.0);
    CHECK(direction[0].isZero(0.0));
    CHECK(direction[2].tail<3>() == motion.rotation);
    const Vec3 moved = motion.displacement + motion.rotation.cross(state.trial[2].r - motion.point);
    CHECK(direction[2].head<3>().isApprox(moved / 3.0, 1e-14));
    direction[5] << random.vector(), random.vector();
    const RigidFit fit = fit_rigid_motion(direction, part, state, 3.0);
    CHECK(fit.remainder < 1e-14);
    CHECK(fit.motion.rotation.isApprox(motion.rotation, 1e-13));
    CHECK(fit.motion.displacement_at(Vec3::Ones()).isApprox(motion.displacement_at(Vec3::Ones()), 1e-13));
    // And no more once a node leaves it.
    direction[4] *= 1.5;
    CHECK(fit_rigid_motion(direction, part, state, 3.0).remainder > 0.01);
}

TEST_CASE("one node always moves rigidly", "[check]") {
    const State state = make_state(1);
    const std::vector<Vec6> direction{Vec6::LinSpaced(-1.0, 1.0)};
    const RigidFit fit = fit_rigid_motion(direction, {{0}, {}, {}}, state, 2.0);
    CHECK(fit.remainder < 1e-15);
    CHECK(fit.motion.rotation.isApprox(direction[0].tail<3>(), 1e-15));
    CHECK(fit.motion.displacement.isApprox(2.0 * direction[0].head<3>(), 1e-15));
}
