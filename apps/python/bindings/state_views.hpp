#pragma once

#include <nanobind/ndarray.h>

#include <array>
#include <span>
#include <vector>

#include "module.hpp"
#include "state/motion.hpp"

namespace gxrod::python {

// Vectors of all nodes as arrays that NumPy reads without a copy. Each exists from when it was first asked
// for and then follows the simulation.
class StateViews {
  public:
    enum Quantity {
        position,
        velocity,
        acceleration,
        angular_velocity,
        angular_acceleration,
        rotation_vector,
        orientation,  // quaternion w x y z
        count
    };

    void follow(std::span<const NodeMotion> nodes);
    // [N, 3], or [N, 4] of orientations; read-only, owned by `owner`.
    nb::object get(Quantity quantity, std::span<const NodeMotion> nodes, nb::handle owner);

  private:
    void fill(int quantity, std::span<const NodeMotion> nodes);

    std::array<std::vector<double>, count> values_;
};

}  // namespace gxrod::python
