// Systems for small motions about a state with contact.
#include "assembly/touching_system.hpp"

#include <Eigen/Core>
#include <string>

#include "assembly/contact/contacts.hpp"
#include "assembly/scatter.hpp"
#include "assembly/state_matrices.hpp"
#include "deck/decks.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// Two rods that cross and a ball, all within the skin of each other, and a cylinder that one of them touches.
std::string heap(const std::string& contact) {
    return R"(
[section.s]
shape = { circle = { radius = 0.05 } }
material = { E = 1e6, nu = 0.3, density = 1000 }
[rod.a]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 3
order = 2
[rod.b]
section = "s"
line = { from = [0.4, -0.5, 0.12], to = [0.6, 0.5, 0.11] }
elements = 2
order = 3
[body.ball]
mass = 1
inertia = [1, 1, 1]
at = [0.8, 0.06, 0.1]
sphere = { radius = 0.05, force = 20 }
[[support]]
at = "a.start"
fix = ["x", "z"]
axes = [[0.8, 0.6, 0], [-0.6, 0.8, 0], [0, 0, 1]]
[obstacle.log]
cylinder = { from = [0.2, -1, -0.16], to = [0.2, 1, -0.16], radius = 0.1 }
[contact]
skin = 0.6
bend_radius = 0.2
)" + contact +
           R"([analysis]
kind = "dynamic"
end_time = 1
time_step = 0.1
)";
}

State make_state(const System& system) {
    State state = system.initial_state();
    RandomValues random(5);
    for (NodeMotion& motion : state.trial) motion.r += random.vector(1e-3);
    state.previous = state.trial;
    return state;
}

double find_error(const TouchingSystem& touching) {
    const System& system = touching.system();
    const std::int64_t size = system.equations().count();
    Eigen::MatrixXd expected(size, size);
    for (std::int64_t j = 0; j < size; ++j) {
        const int node = system.equations().unknown(j).node;
        const Vec6 direction = system.equations().increment_of(node, Eigen::VectorXd::Unit(size, j));
        expected.col(j) = differentiate(
            [&](double amount) {
                State moved = touching.state();
                const auto i = static_cast<std::size_t>(node);
                apply_spin(moved.previous[i],
                           amount * direction.head<3>(),
                           amount * direction.tail<3>(),
                           moved.trial[i]);
                Residual residual;
                system.compute_residual(moved, 0.0, residual);
                return gather(residual.nodal, system.equations());
            },
            1e-5);
    }
    const StateMatrices matrices = compute_state_matrices(system, touching.state(), 0.0);
    Eigen::MatrixXd found = Eigen::MatrixXd::Zero(size, size);
    system.pattern().visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
        found(row, column) = matrices.stiffness[static_cast<std::size_t>(slot)];
    });
    return relative_difference(found, expected);
}

}  // namespace

// The model is that of a motion: without TouchingSystem its contact would act by impulses.
TEST_CASE("Touching: the stiffness about a state is the derivative of the residual", "[assembly][touch]") {
    for (const char* contact : {"", "dissipation = 0.3\ndamping = 2\n"}) {
        const Problem problem = test::read(heap(contact));
        const System system(problem.model);
        const State state = make_state(system);
        const TouchingSystem touching(system, state);
        CHECK(Contacts(touching.system()).count(touching.state(), 0.0).touching >= 4);
        REQUIRE(touching.system().pattern().nonzeros() > system.pattern().nonzeros());
        CHECK(find_error(touching) < 1e-7);
    }
}

TEST_CASE("Touching: without contact it is the given system", "[assembly][touch]") {
    const Problem problem = test::read(
        "[section.s]\nshape = { circle = { radius = 0.05 } }\nmaterial = { E = 1e6, nu = 0.3, density = 1000 "
        "}\n"
        "[rod.a]\nsection = \"s\"\nline = { from = [0, 0, 0], to = [1, 0, 0] }\nelements = 3\n"
        "[[support]]\nat = \"a.start\"\nfix = \"all\"\n[analysis]\nkind = \"static\"\n");
    const System system(problem.model);
    const State state = system.initial_state();
    const TouchingSystem touching(system, state);
    CHECK(&touching.system() == &system);
    CHECK(&touching.state() == &state);
}
