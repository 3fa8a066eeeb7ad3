#include "loads/pressure.hpp"
#include "assembly/system_values.hpp"

#include "assembly/sample_model.hpp"
#include "assembly/system.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE("Pressures grow with the depth", "[loads][surroundings]") {
    SectionInFluid pipe;
    pipe.area = 0.5;
    pipe.contents_area = 0.3;
    pipe.contents_density = 900.0;
    pipe.contents_pressure = 2e5;
    const Water sea{.density = 1025.0, .surface = 10.0};
    CHECK(compute_pressure_force(pipe, sea, 9.81, 0.0) ==
          Approx((2e5 + 900.0 * 98.1) * 0.3 - 1025.0 * 98.1 * 0.5).epsilon(1e-14));
    // Above the surface the contents alone press.
    CHECK(compute_pressure_force(pipe, sea, 9.81, 15.0) ==
          Approx((2e5 - 900.0 * 49.05) * 0.3).epsilon(1e-14));
    CHECK(compute_pressure_force(pipe, {}, 9.81, -2.0) == Approx((2e5 + 900.0 * 19.62) * 0.3).epsilon(1e-14));
    pipe.poisson = 0.3;
    CHECK(compute_pressure_strain(pipe, 5e4, 1e9) == Approx(0.4 * 5e4 / 1e9).epsilon(1e-14));
}

TEST_CASE("The axial force of a pressed rod lacks what pressures stretch", "[loads][surroundings]") {
    for (int order = 1; order <= 4; ++order) {
        Model model = make_turned_model(ElementKind::objective, order);
        model.sections[0].stiffness = Vec6(1e3, 4e2, 4e2, 10.0, 20.0, 20.0).asDiagonal();
        SectionInFluid pipe;
        pipe.area = 0.5;
        pipe.diameter = 0.8;
        pipe.poisson = 0.2;
        model.gravity = Vec3(0.0, 0.0, -9.81);
        model.surroundings.water = Water{.density = 100.0, .surface = 6.0};
        model.sections[0].fluid = pipe;
        const System pressed(model);
        Model other = model;
        other.sections[0].fluid->poisson = 0.5;
        const System incompressible(other);
        const State state = make_turned_state(pressed, 3);
        const auto with = SystemValues(pressed).compute_section_values(state);
        const auto without = SystemValues(incompressible).compute_section_values(state);
        for (std::size_t e = 0; e < with.size(); ++e) {
            const Rod& rod = model.rods[0];
            // In the middle: of a line that is curved in z the depth is that of the force point.
            if (order == 1) {
                double z = 0.0;
                for (std::size_t i = 0; i < 2; ++i)
                    z += 0.5 * state.trial[static_cast<std::size_t>(rod.element_nodes[2 * e + i])].r.z();
                CHECK(with[e].force.x() - without[e].force.x() ==
                      Approx(0.6 * 100.0 * 9.81 * (6.0 - z) * 0.5).epsilon(1e-10));
            } else {
                CHECK(with[e].force.x() - without[e].force.x() > 0.0);
            }
            CHECK(with[e].moment == without[e].moment);
        }
    }
}
