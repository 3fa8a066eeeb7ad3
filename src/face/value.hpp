#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rotation/types.hpp"

namespace gxrod {

class Simulation;

// A quantity of a history at the last accepted state of a simulation: a number, a vector or a quaternion. It
// is computed when it is read, so it follows the simulation.
class Value {
  public:
    Value(Simulation& simulation, std::size_t history, std::string quantity, int by = -1)
        : simulation_(&simulation), history_(history), quantity_(std::move(quantity)), by_(by) {}

    // Returns all its numbers; w x y z of a quaternion. Throws UnknownNameError if the history does not
    // record it.
    std::vector<double> numbers() const;
    // Return it as one of these. Throw std::logic_error if it is something else.
    double number() const;
    Vec3 vector() const;
    Quat quaternion() const;

    operator double() const { return number(); }
    operator Vec3() const { return vector(); }
    operator Quat() const { return quaternion(); }
    double x() const { return vector().x(); }
    double y() const { return vector().y(); }
    double z() const { return vector().z(); }

  private:
    std::vector<double> numbers(std::size_t count, const char* what) const;

    Simulation* simulation_;
    std::size_t history_;
    std::string quantity_;
    int by_;  // the number by which it is differentiated; -1 for the quantity itself
};

// The quantities that a [[history]] records, by their names in the deck. They follow the simulation.
class Values {
  public:
    Values(Simulation& simulation, std::size_t history, int by = -1);

    // Returns any of them by its name: run["strut"]["elongation"].
    Value operator[](const std::string& quantity) const { return {*simulation_, history_, quantity, by_}; }
    std::vector<std::string> names() const;
    // Returns their derivatives by a number of the deck; the simulation has a VariedNumber of this name.
    Values derivative(const std::string& number) const;

    // Often used ones.
    Value position, displacement, rotation_vector, orientation, velocity, angular_velocity, acceleration,
        force, moment;

  private:
    Simulation* simulation_;
    std::size_t history_;
    int by_;
};

}  // namespace gxrod
