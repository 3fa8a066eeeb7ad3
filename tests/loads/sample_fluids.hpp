#pragma once

#include "loads/fluid_force.hpp"
#include "tools/random_values.hpp"

namespace gxrod::tools {

// A smooth random field v + A sin(k·x + p) with its gradient.
class SampleField {
  public:
    explicit SampleField(RandomValues& random)
        : v_(2.0 * random.vector()), A_(random.vector()), k_(random.vector()), phase_(random.number(0, 6)) {}
    Vec3 value(const Vec3& x) const { return v_ + A_ * std::sin(k_.dot(x) + phase_); }
    Mat3 gradient(const Vec3& x) const { return A_ * k_.transpose() * std::cos(k_.dot(x) + phase_); }

  private:
    Vec3 v_, A_, k_;
    double phase_;
};

enum class Around { water, air, both };

// Water and air that flow at random; the water's surface, if it has one, is a wave around z = `level`.
struct SampleFluids {
    SampleFluids(RandomValues& random, Around what, std::optional<double> level_ = std::nullopt)
        : around(what), level(level_), water_flow(random), water_change(random), wind(random) {
        gravity = random.vector(10.0);
    }

    Around around;
    std::optional<double> level;
    SampleField water_flow, water_change, wind;
    Vec3 gravity;

    // |u| u is not smooth where u changes sign: whether no component of the flow, relative to `v`, does so
    // near here.
    bool flows_past(const Vec3& x, const Vec3& v, const Mat3& axes) const {
        const auto flows = [&](const Vec3& velocity) {
            return (axes.transpose() * (velocity - v)).cwiseAbs().minCoeff() > 0.05;
        };
        return flows(water_flow.value(x)) && flows(wind.value(x));
    }

    // What `ask` answers of the fluids at `x`.
    template <class Ask>
    auto at(const Vec3& x, Ask&& ask) const {
        WaterAt water{.velocity = water_flow.value(x),
                      .acceleration = water_change.value(x),
                      .velocity_gradient = water_flow.gradient(x),
                      .acceleration_gradient = water_change.gradient(x)};
        if (level) {
            const double phase = 1.3 * x.x() - 0.4 * x.y();
            water.has_surface = true;
            water.surface = *level + 0.2 * std::sin(phase);
            water.surface_slope = 0.2 * std::cos(phase) * Vec3(1.3, -0.4, 0.0);
        }
        const AirAt air{wind.value(x), wind.gradient(x)};
        return ask(FluidsAt{.water_density = 1.7,
                            .water = around == Around::air ? nullptr : &water,
                            .air_density = 0.6,
                            .air = around == Around::water ? nullptr : &air,
                            .gravity = gravity});
    }
};

inline NodeMotion random_motion(RandomValues& random) {
    NodeMotion motion;
    motion.r = random.vector();
    motion.Lambda = random.rotation();
    motion.v = random.vector();
    motion.a = random.vector();
    motion.omega = random.vector();
    motion.alpha = random.vector();
    return motion;
}

}  // namespace gxrod::tools
