#include "environment/fluid_field.hpp"

#include "environment/current.hpp"
#include "environment/waves.hpp"

namespace gxrod {

// Of one time: current and waves.
class WaterField {
  public:
    WaterField(const Water& water, double length)
        : water_(&water),
          level_(water.surface.value_or(0.0)),
          current_(water.current, length, "water"),
          waves_(water, find_wave_kernels(find_instruction_set())) {}

    void move_to(double time) {
        current_.move_to(time);
        waves_.move_to(time);
    }
    bool is_shareable() const { return current_.is_shareable(); }

    WaterAt at(const Vec3& position, bool gradients) const {
        Waves::At waves;
        const double z = position[2] - level_;
        if (!waves_.are_still()) waves = waves_.at({position[0], position[1], z});
        WaterAt water;
        water.velocity = waves.flow.velocity;
        water.acceleration = waves.flow.acceleration;
        water.velocity_gradient = waves.flow.velocity_gradient;
        water.acceleration_gradient = waves.flow.acceleration_gradient;
        water.has_surface = water_->surface.has_value();
        water.surface = level_ + waves.surface.elevation;
        water.surface_slope = waves.surface.slope;
        if (!current_.is_still()) add_current(position, waves.surface, gradients, water);
        return water;
    }

  private:
    void add_current(const Vec3& position, const WaveSurface& surface, bool gradients, WaterAt& water) const {
        FormulaHeight height{position[2], Vec3::UnitZ()};
        if (water_->stretches_current) {
            height = draw_to_still_water(position[2] - level_, water_->depth, surface);
            height.z += level_;
        }
        const FlowAt flow = current_.at(position, height, gradients);
        water.velocity += flow.velocity;
        water.acceleration += flow.acceleration;
        water.velocity_gradient += flow.velocity_gradient;
        water.acceleration_gradient += flow.acceleration_gradient;
    }

    const Water* water_;
    double level_;  // of still water
    Current current_;
    Waves waves_;
};

struct FluidField::Fields {
    std::optional<WaterField> water{};
    std::optional<Current> wind{};
    std::optional<double> time{};  // of the last move
};

FluidField::FluidField(const Surroundings& surroundings, double length)
    : fields_(std::make_unique<Fields>()) {
    if (surroundings.water) fields_->water.emplace(*surroundings.water, length);
    if (surroundings.air) fields_->wind.emplace(surroundings.air->wind, length, "air");
}

FluidField::~FluidField() = default;
FluidField::FluidField(FluidField&&) noexcept = default;
FluidField& FluidField::operator=(FluidField&&) noexcept = default;

void FluidField::move_to(double time) {
    if (fields_->time == time) return;
    fields_->time.reset();
    if (fields_->water) fields_->water->move_to(time);
    if (fields_->wind) fields_->wind->move_to(time);
    fields_->time = time;
}

void FluidField::forget() { fields_->time.reset(); }

bool FluidField::is_shareable() const {
    return (!fields_->water || fields_->water->is_shareable()) &&
           (!fields_->wind || fields_->wind->is_shareable());
}

WaterAt FluidField::water_at(const Vec3& position, bool gradients) const {
    return fields_->water->at(position, gradients);
}

AirAt FluidField::air_at(const Vec3& position, bool gradients) const {
    const FlowAt flow = fields_->wind->at(position, {position[2], Vec3::UnitZ()}, gradients);
    return {flow.velocity, flow.velocity_gradient};
}

}  // namespace gxrod
