#include "assembly/scale_groups.hpp"

#include "assembly/system.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// Rods of two elements from x = 0, 1, 2 on, of these stiffnesses EA = GA = EI; joined where `is_joined`.
Model make_row(const std::vector<double>& stiffnesses, bool is_joined) {
    Model model;
    for (std::size_t i = 0; i < stiffnesses.size(); ++i) {
        const double k = stiffnesses[i];
        model.sections.push_back(make_section({k, k, k, k, k, k}));
        Rod rod;
        rod.section = static_cast<int>(i);
        rod.length = 1.0;
        for (int node = 0; node < 3; ++node) {
            if (node == 0 && is_joined && i > 0) {
                rod.nodes.push_back(model.rods.back().nodes.back());
                continue;
            }
            rod.nodes.push_back(static_cast<int>(model.nodes.size()));
            model.nodes.push_back({"", Vec3(static_cast<double>(i) + 0.5 * node, 0.0, 0.0)});
        }
        set_line_elements(rod, {0.0, 0.5, 1.0}, std::vector<Quat>(3, Quat::Identity()));
        model.rods.push_back(rod);
    }
    return model;
}

Residual make_residual(const ScaleGroups& groups, const std::vector<double>& forces) {
    Residual residual;
    residual.groups.resize(groups.count());
    for (std::size_t rod = 0; rod < forces.size(); ++rod)
        residual.groups[rod].raise(forces[rod], forces[rod]);
    return residual;
}

}  // namespace

TEST_CASE("a residual is compared with what acts in its own part of the model", "[assembly]") {
    const Model model = make_row({1.0, 1.0}, false);
    const ScaleGroups groups(model);
    CHECK(groups.count() == 2);
    CHECK(groups.part_count() == 2);
    const NodeScales scales = groups.compute_scales(make_residual(groups, {1e3, 1e-5}));
    CHECK(scales.of(0).force == 1e3);
    CHECK(scales.of(5).force == 1e-5);
    CHECK(scales.of(5).moment == 1e-5);
    CHECK(groups.length_at(0) == 1.0);
}

TEST_CASE("within one part it is compared with a thousand times what acts in its rod", "[assembly]") {
    const Model model = make_row({1.0, 1.0, 1.0}, true);
    const ScaleGroups groups(model);
    CHECK(groups.count() == 5);  // three rods, and two nodes that they share
    CHECK(groups.part_count() == 1);
    CHECK(groups.length_at(0) == 3.0);
    const NodeScales scales = groups.compute_scales(make_residual(groups, {1e3, 1e-4, 10.0}));
    CHECK(scales.of(0).force == 1e3);
    CHECK(scales.of(1).force == 1e3);
    CHECK(scales.of(2).force == 1e3);          // shared with the second rod
    CHECK(scales.of(3).force == Approx(0.1));  // the second rod's own
    CHECK(scales.of(4).force == 1e3);          // shared with the third
    CHECK(scales.of(5).force == 1e3);          // whose forces are not that small
}

TEST_CASE("no scale falls below the round-off of forces in the rod", "[assembly]") {
    // EA |r| / h × 16 units of rounding, over the usual tolerance of 1e-8.
    for (const bool is_joined : {false, true}) {
        const Model model = make_row({1e12, 1.0}, is_joined);
        const ScaleGroups groups(model);
        const NodeScales scales = groups.compute_scales(make_residual(groups, {1e-9, 1e9}));
        const double round_off = 16.0 * 2.220446049250313e-16 * 1e12 * 1.0 / 0.5;
        CHECK(scales.of(0).force == Approx(round_off / 1e-8));
        CHECK(scales.of(groups.part_count() == 1 ? 4 : 5).force == 1e9);
    }
}

TEST_CASE("a model of one rod has one scale, that of all that acts", "[assembly]") {
    Model model = make_rod_model(along_x, 10.0, {4, 2}, make_section({1e4, 1e4, 1e4, 1.0, 1.0, 1.0}));
    clamp(model, 0);
    add_ramp(model, 3, {0.0, 7.0, 0.0}, {0.0, 0.0, 2.0});
    const System system(model);
    Residual residual;
    system.compute_residual(system.initial_state(), 1.0, residual);
    const NodeScales scales = system.scale_groups().compute_scales(residual);
    for (const int node : {0, 3, 8}) {
        CHECK(scales.of(node).force == 7.0);
        CHECK(scales.of(node).moment == 2.0);
    }
}

TEST_CASE("groups take up what acts in their rods, bodies and nodes alone", "[assembly]") {
    Model model = make_row({1.0, 1.0}, true);
    Body body;
    body.node = 4;
    body.mass = 1.0;
    body.inertia = Mat3::Identity();
    model.bodies.push_back(body);
    model.gravity = TimeVector(Vec3(0.0, 0.0, -10.0));
    add_ramp(model, 2, {5.0, 0.0, 0.0}, Vec3::Zero());
    add_ramp(model, 1, {3.0, 0.0, 0.0}, Vec3::Zero());
    const System system(model);
    Residual residual;
    system.compute_residual(system.initial_state(), 1.0, residual);
    const ScaleGroups& groups = system.scale_groups();
    CHECK(residual.groups[groups.of_rod(0)].force_scale == 3.0);
    CHECK(residual.groups[groups.of_rod(1)].force_scale == 0.0);
    CHECK(residual.groups[groups.of_body(0)].force_scale == 10.0);
    CHECK(residual.groups[groups.of_node(2)].force_scale == 5.0);
    CHECK(groups.of_node(4) != groups.of_rod(1));
    CHECK(residual.force_scale == 10.0);
}
