#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "deck/decks.hpp"
#include "run/stepped_run.hpp"
#include "sensitivity/forward_sensitivity.hpp"

// A model to differentiate, its numbers, and the models next to it.
namespace gxrod::test {

// A damped rod that a following force and a moment swing; a body at its end turns on a hinge.
inline const std::string swinging_rod = R"deck(gravity = [0, 0, -9.81]
[parameters]
EI = 6
rho = 1.2
F = 3
L = 2
c = 0.02
angle = 0.3
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = "EI", EIz = 7 }
inertia = { rhoA = "rho", rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
damping = { kelvin_voigt = "c", mass_proportional = 0.1 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = ["L*cos(angle)", "L*sin(angle)", 0] }
elements = 4
[body.b]
mass = 0.5
inertia = [0.1, 0.2, 0.2]
at = ["L*cos(angle)", "L*sin(angle)", 0]
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [0, "F*sin(4*t)", 0]
moment = [0.5, 0, "F/4"]
frame = "follower"
[analysis]
kind = "dynamic"
end_time = 0.6
time_step = 0.02
newton = { tolerance = 1e-12 }
)deck";

inline const std::string hinged_end =
    "[joint.pin]\ntype = \"hinge\"\nbetween = [\"r.end\", \"b\"]\naxis = [0, 1, 0]\nspring = { stiffness = 3 "
    "}\n";

// The body on the rod's end itself.
inline std::string make_carried() {
    return replaced(swinging_rod,
                    "inertia = [0.1, 0.2, 0.2]\nat = [\"L*cos(angle)\", \"L*sin(angle)\", 0]",
                    "inertia = [0.1, 0.2, 0.2]\nat = \"r.end\"");
}

inline std::string as_static(const std::string& deck) {
    return replaced(
        replaced(
            deck, "kind = \"dynamic\"\nend_time = 0.6\ntime_step = 0.02", "kind = \"static\"\nsteps = 5"),
        "sin(4*t)",
        "t");
}

inline std::string with_integrator(const std::string& deck, const std::string& name) {
    return replaced(deck, "time_step = 0.02", "time_step = 0.02\nintegrator = \"" + name + "\"");
}

inline std::string as_explicit(const std::string& deck) {
    return replaced(deck,
                    "end_time = 0.6\ntime_step = 0.02\nnewton = { tolerance = 1e-12 }",
                    "end_time = 0.25\ntime_step = 1e-3\nintegrator = \"runge-kutta-4\"");
}

inline std::string set(const std::string& deck, const std::string& name, double value) {
    const std::size_t at = deck.find("\n" + name + " = ") + 1;
    const std::size_t end = deck.find('\n', at);
    return std::string(deck).replace(at, end - at, fmt::format("{} = {:.17g}", name, value));
}

inline double value_of(const std::string& deck, const std::string& name) {
    return std::stod(deck.substr(deck.find("\n" + name + " = ") + name.size() + 4));
}

inline RunRequest request_of(const Problem& problem) { return {problem}; }

// The deck's models for values of a number next to its own.
class Variation {
  public:
    explicit Variation(const std::string& deck, const std::string& name, double step = 5e-4)
        : step_(step * value_of(deck, name)) {
        const double p = value_of(deck, name);
        for (const int steps : {1, -1, 2, -2}) problems_.push_back(read(set(deck, name, p + steps * step_)));
    }
    VariedModels models() const {
        return {{problems_[0].model, problems_[1].model, step_},
                {problems_[2].model, problems_[3].model, 2.0 * step_}};
    }

  private:
    std::vector<Problem> problems_;
    double step_;
};

}  // namespace gxrod::test
