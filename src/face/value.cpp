#include "face/value.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "face/simulation.hpp"
#include "face/unknown_name_error.hpp"

namespace gxrod {

std::vector<double> Value::numbers() const {
    const std::vector<std::string> names = simulation_->list_quantities(history_);
    const std::string& history = simulation_->problem().output.histories[history_].name;
    const std::size_t quantity = find_name("quantity of history " + history, quantity_, names);
    return by_ < 0 ? simulation_->compute(history_, quantity)
                   : simulation_->differentiate(static_cast<std::size_t>(by_), history_, quantity);
}

std::vector<double> Value::numbers(std::size_t count, const char* what) const {
    std::vector<double> numbers = this->numbers();
    if (numbers.size() == count) return numbers;
    throw std::logic_error(fmt::format("{} has {} numbers; it is not a {}", quantity_, numbers.size(), what));
}

double Value::number() const { return numbers(1, "number").front(); }

Vec3 Value::vector() const { return Vec3(numbers(3, "vector").data()); }

Quat Value::quaternion() const {
    const std::vector<double> wxyz = numbers(4, "quaternion");
    return {wxyz[0], wxyz[1], wxyz[2], wxyz[3]};
}

Values::Values(Simulation& simulation, std::size_t history, int by)
    : position(simulation, history, "position", by),
      displacement(simulation, history, "displacement", by),
      rotation_vector(simulation, history, "rotation_vector", by),
      orientation(simulation, history, "orientation", by),
      velocity(simulation, history, "velocity", by),
      angular_velocity(simulation, history, "angular_velocity", by),
      acceleration(simulation, history, "acceleration", by),
      force(simulation, history, "force", by),
      moment(simulation, history, "moment", by),
      simulation_(&simulation),
      history_(history),
      by_(by) {}

std::vector<std::string> Values::names() const { return simulation_->list_quantities(history_); }

Values Values::derivative(const std::string& number) const {
    return {
        *simulation_, history_, static_cast<int>(find_name("sensitivity", number, simulation_->numbers()))};
}

}  // namespace gxrod
