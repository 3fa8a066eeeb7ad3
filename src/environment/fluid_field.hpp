#pragma once

#include <memory>

#include "model/surroundings.hpp"

namespace gxrod {

// Water at a place and a time; spatial.
struct WaterAt {
    Vec3 velocity = Vec3::Zero();           // u
    Vec3 acceleration = Vec3::Zero();       // ∂u/∂t at the place
    Mat3 velocity_gradient = Mat3::Zero();  // ∂u_i/∂x_j
    Mat3 acceleration_gradient = Mat3::Zero();
    bool has_surface = false;           // otherwise water is everywhere
    double surface = 0.0;               // z of the surface above the place
    Vec3 surface_slope = Vec3::Zero();  // its gradient, z component 0
};

// Air at a place and a time; spatial.
struct AirAt {
    Vec3 velocity = Vec3::Zero();
    Mat3 velocity_gradient = Mat3::Zero();
};

// The water and the air of a model. Values that depend on time alone are computed once for each time.
class FluidField {
  public:
    // `length` is the model's length; differences of fields by place take a small part of it. The
    // surroundings must outlive this.
    FluidField(const Surroundings& surroundings, double length);
    ~FluidField();
    FluidField(FluidField&& other) noexcept;
    FluidField& operator=(FluidField&& other) noexcept;

    // Throws EvaluationError if a function has no finite value.
    void move_to(double time);
    // Forgets the values at this time, if functions depend on more than the time.
    void forget();

    // Whether several threads may ask for places at once.
    bool is_shareable() const;

    // Return water and air at the time of move_to; the model must have them. Rates of functions are
    // differences by time; the acceleration of stretched waves is taken at the height of their formula
    // (docs/theory/water.md). Without `gradients`, gradients by differences, which take time, are left out.
    WaterAt water_at(const Vec3& position, bool gradients = true) const;
    AirAt air_at(const Vec3& position, bool gradients = true) const;

  private:
    struct Fields;
    std::unique_ptr<Fields> fields_;
};

}  // namespace gxrod
