#include "environment/flow_profile.hpp"

#include "environment/current.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("A current turns with depth, and its gradient is its difference", "[environment]") {
    const double factor = 0.7;
    for (const std::vector<double>& speeds : {std::vector<double>{0.5, -0.3, 1.5, 1.1, 1.0, 0.4},
                                              std::vector<double>{0.5, 0.1, 0, 1.5, -0.4, 0.2, 0, 2, 0}}) {
        const Flow flow{.profile = SpeedProfile{.heights = {-10, -4, 0},
                                                .speeds = speeds,
                                                .direction = Vec3(0.6, 0.8, 0),
                                                .factor = TimeFunction(factor)}};
        Current current(flow, 1.0, "water");
        current.move_to(0.3);
        const auto velocity = [&](double z) { return current.at(Vec3::Zero(), {.z = z}, false).velocity; };
        for (std::size_t row = 0; row < 3; ++row)
            CHECK(
                (velocity(flow.profile->heights[row]) - factor * velocity_at_row(*flow.profile, row)).norm() <
                1e-15);
        CHECK(velocity(-20) == velocity(-10));
        const double step = 1e-5;
        const Vec3 difference = (velocity(-6 + step) - velocity(-6 - step)) / (2 * step);
        const FormulaHeight height{.z = -6};
        const Mat3 gradient = current.at(Vec3::Zero(), height, true).velocity_gradient;
        CHECK((gradient - difference * height.gradient.transpose()).norm() < 1e-9);
    }
    // Halfway between two rows: the mean speed at the mean angle.
    const SpeedProfile turning{.heights = {-10, 0}, .speeds = {1, 0, 3, 1}, .direction = Vec3::UnitX()};
    const Vec3 middle = interpolate_turning(turning, -5).velocity;
    CHECK((middle - 2.0 * Vec3(std::cos(0.5), std::sin(0.5), 0)).norm() < 1e-15);
}
