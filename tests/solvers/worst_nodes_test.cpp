#include "solvers/worst_nodes.hpp"

#include <limits>

#include "solvers/mechanisms.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE("the worst nodes come in order, each by its worst component", "[solvers]") {
    Model model;
    add_rod(model, {"r", Vec3::Zero(), Vec3(2.0, 0.0, 0.0), 4});
    add_support(model, 0, {0, 1, 2, 3, 4, 5});
    const System system(model);
    Residual residual;
    residual.nodal.assign(5, Vec6::Zero());
    residual.groups = {{10.0, 100.0}};
    residual.nodal[0] = Vec6::Constant(1e6);  // held
    residual.nodal[1] << 0.0, -1.0, 0.5, 9.0, 0.0, 0.0;
    residual.nodal[2] << 0.1, 0.0, 0.0, 0.0, 0.0, 50.0;
    residual.nodal[3][2] = 0.2;
    const std::vector<WorstNode> worst = find_worst_nodes(system, residual, 3);
    REQUIRE(worst.size() == 3);
    CHECK(name_place(model, worst[0].node, worst[0].component) == "r node 2 (rz)");
    CHECK(worst[0].residual == 0.5);
    CHECK(name_place(model, worst[1].node, worst[1].component) == "r node 1 (y)");
    CHECK(worst[1].residual == 0.1);
    CHECK(name_place(model, worst[2].node, worst[2].component) == "r node 3 (z)");
    CHECK(find_worst_nodes(system, residual, 1).size() == 1);
    CHECK(find_worst_nodes(system, residual, 9).size() == 3);
    residual.nodal[4][0] = std::numeric_limits<double>::quiet_NaN();
    CHECK(find_worst_nodes(system, residual, 3)[0].node == 4);
    CHECK(name_place(model, 4, -1) == "r.end");
}

TEST_CASE("components are those of a support's own axes", "[solvers]") {
    Model model;
    add_rod(model, {"r", Vec3::Zero(), Vec3(2.0, 0.0, 0.0), 1});
    add_support(model, 0, {0});
    model.supports[0].axes =
        Quat(Eigen::AngleAxisd(0.5 * 3.14159265358979, Vec3::UnitZ()));  // x is the global y
    const System system(model);
    Residual residual;
    residual.nodal.assign(2, Vec6::Zero());
    residual.groups = {{1.0, 1.0}};
    residual.nodal[0] << 0.5, 7.0, 0.0, 0.0, 0.0, 0.0;
    const std::vector<WorstNode> worst = find_worst_nodes(system, residual, 3);
    REQUIRE(worst.size() == 1);
    CHECK(worst[0].component == 1);
    CHECK(worst[0].residual == Approx(0.5));
}
