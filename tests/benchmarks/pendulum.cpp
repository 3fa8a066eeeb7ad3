#include "benchmarks/pendulum.hpp"

#include <fmt/format.h>

namespace gxrod::speed {

Problem make_pendulum(int elements, int order, long steps) {
    const char* const deck = R"(
gravity = [0, -9.81, 0]
[section.rubber]
shape    = { circle = { radius = 5e-3 } }
material = { E = 5e6, nu = 0.5, density = 1100, shear_factor = 1 }
[rod.rod]
section  = "rubber"
line     = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 10
[[support]]
at  = "rod.start"
fix = ["position", "rotation"]
[analysis]
kind       = "dynamic"
integrator = "newmark-simplified"
end_time   = 1.0
time_step  = 0.001
[[history]]
name = "tip"
at = "rod.end"
quantities = ["position"]
)";
    constexpr double time_step = 1e-3;
    return read_problem_text(deck,
                             "pendulum.toml",
                             {fmt::format("rod.rod.elements={}", elements),
                              fmt::format("rod.rod.order={}", order),
                              fmt::format("analysis.end_time={}", time_step * static_cast<double>(steps))});
}

}  // namespace gxrod::speed
