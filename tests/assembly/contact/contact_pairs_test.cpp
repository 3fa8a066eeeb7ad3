// Rods that touch each other and themselves.

#include "assembly/contact/contact_assembly.hpp"
#include "deck/decks.hpp"
#include "integrators/load_stepping.hpp"
#include "solvers/paired_matrix.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

const Stage stage{0, 0.0, 1.0, 1.0};

// Two rods that cross, a third one along the first, and one that comes back to itself; the skin is wide.
std::string tangle(const char* more = "") {
    return std::string(R"(
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
[rod.c]
section = "s"
line = { from = [0.1, 0.115, 0.02], to = [0.9, 0.112, -0.01] }
elements = 3
order = 1
[rod.hook]
section = "s"
spline = [[2, 0, 0], [2.5, 0.02, 0.05], [2.6, 0.3, 0.06], [2.2, 0.3, 0.05], [2.25, -0.1, 0.16]]
elements = 8
order = 2
[[support]]
at = "a.start"
fix = "all"
[contact]
skin = 0.6
bend_radius = 0.2
)") + more +
           R"(
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.1
)";
}

struct Scene {
    explicit Scene(const char* more = "") : problem(test::read(tangle(more))) {}

    Problem problem;
    System system{problem.model};
    State state = make_state();

    State make_state() const {
        State start = system.initial_state();
        RandomValues random(3);
        for (NodeMotion& motion : start.trial) {
            motion.r += random.vector(2e-3);
            motion.theta = random.vector(0.02);
        }
        contact_assembly_of(system)->search(start);
        return start;
    }
    const ContactPairs& pairs() const { return contact_assembly_of(system)->pairs(); }
};

std::vector<Vec6> forces_of(const System& system, const State& state) {
    Residual residual;
    residual.nodal.assign(state.trial.size(), Vec6::Zero());
    contact_assembly_of(system)->pairs().subtract_forces(state, -1.0, residual);
    return residual.nodal;
}

std::string name_of(const Model& model, int node) { return model.nodes[static_cast<std::size_t>(node)].name; }

// Of the tangent of all pairs, by spins, against differences of forces.
double tangent_error(const Scene& scene) {
    std::vector<NodeLinearization> linearizations(scene.state.trial.size());
    LoadStepping().linearize(scene.state, stage, linearizations);
    const std::vector<PairBlock> blocks = scene.pairs().compute_tangents(scene.state, 1.0, linearizations);
    const auto size = static_cast<Eigen::Index>(6 * scene.state.trial.size());
    Eigen::MatrixXd tangent = Eigen::MatrixXd::Zero(size, size);
    for (const PairBlock& block : blocks) {
        for (std::size_t i = 0; i < block.nodes.size(); ++i) {
            for (std::size_t j = 0; j < block.nodes.size(); ++j)
                tangent.block<6, 6>(6 * block.nodes[i], 6 * block.nodes[j]) += block.matrix.block<6, 6>(
                    static_cast<Eigen::Index>(6 * i), static_cast<Eigen::Index>(6 * j));
        }
    }
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(size, size);
    for (std::size_t node = 0; node < scene.state.trial.size(); ++node) {
        for (int k = 0; k < 6; ++k) {
            expected.col(static_cast<Eigen::Index>(6 * node) + k) = differentiate(
                [&](double amount) {
                    State moved = scene.state;
                    Vec6 delta = Vec6::Zero();
                    delta[k] = amount;
                    apply_spin(moved.previous[node], delta.head<3>(), delta.tail<3>(), moved.trial[node]);
                    const std::vector<Vec6> forces = forces_of(scene.system, moved);
                    Eigen::VectorXd stacked(size);
                    for (std::size_t i = 0; i < forces.size(); ++i)
                        stacked.segment<6>(static_cast<Eigen::Index>(6 * i)) = -forces[i];
                    return stacked;
                },
                1e-5);
        }
    }
    return relative_difference(tangent, expected);
}

}  // namespace

TEST_CASE("Pairs: forces are derivatives of their energy, and in balance", "[assembly][touch]") {
    const Scene scene;
    State state = scene.state;
    state.previous = state.trial;  // of no motion, whose impulses are forces
    ContactCount count{0, 1.0};
    scene.pairs().count(state, count);
    CHECK(count.touching > 10);
    CHECK(count.least_gap > 0.0);
    const std::vector<Vec6> forces = forces_of(scene.system, state);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    double largest = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        sum += forces[i].head<3>();
        moment += state.trial[i].r.cross(forces[i].head<3>()) + forces[i].tail<3>();
        largest = std::max(largest, forces[i].norm());
        for (int k = 0; k < 3; ++k) {
            const double slope = differentiate(
                [&](double amount) {
                    State moved = state;
                    moved.trial[i].r[k] += amount;
                    return scene.pairs().compute_energy(moved);
                },
                1e-5);
            CHECK(forces[i][k] == Approx(-slope).epsilon(1e-5).margin(1e-6));
        }
    }
    CHECK(largest > 1e-2);
    CHECK(sum.norm() < 1e-12 * largest);
    CHECK(moment.norm() < 1e-12 * largest);
}

TEST_CASE("Pairs: all rods of the tangle touch, the hook itself", "[assembly][touch]") {
    const Scene scene;
    const std::vector<Vec6> forces = forces_of(scene.system, scene.state);
    for (const char* rod : {"a", "b", "c", "hook"}) {
        double largest = 0.0;
        for (std::size_t i = 0; i < forces.size(); ++i) {
            if (name_of(scene.problem.model, static_cast<int>(i)).starts_with(rod))
                largest = std::max(largest, forces[i].norm());
        }
        INFO(rod);
        CHECK(largest > 1e-6);
    }
}

TEST_CASE("Pairs: the tangent is the derivative of the forces", "[assembly][touch]") {
    SECTION("without friction") {
        const Scene scene;
        CHECK(tangent_error(scene) < 1e-5);
    }
    SECTION("where all slides") { CHECK(tangent_error(Scene("friction = 1e-3")) < 1e-5); }
    SECTION("where all sticks") {
        Scene scene("friction = 1e6");
        CHECK(tangent_error(scene) < 1e-5);
    }
    SECTION("by parameters too, where they are on the law") {
        const Scene scene;
        std::vector<NodeLinearization> linearizations(scene.state.trial.size());
        LoadStepping().linearize(scene.state, stage, linearizations);
        const std::vector<PairBlock> blocks =
            scene.pairs().compute_tangents(scene.state, 1.0, linearizations);
        State state = scene.state;
        contact_assembly_of(scene.system)->start(state, 1.0);
        CHECK(state.contact.has_parameters);
        const std::vector<PairBlock> mixed = scene.pairs().compute_tangents(state, 1.0, linearizations);
        REQUIRE(mixed.size() == blocks.size());
        for (std::size_t i = 0; i < mixed.size(); ++i)
            CHECK((mixed[i].matrix - blocks[i].matrix).norm() <= 1e-9 * (1.0 + blocks[i].matrix.norm()));
    }
}

TEST_CASE("Pairs: damping pushes where rods approach, and the tangent follows", "[assembly][touch]") {
    for (const char* more : {"damping = 2\n", "damping = 2\nfriction = 0.4\n", "damping = 1000\n"}) {
        INFO(more);
        Scene scene(more);
        scene.state.trial_time = 0.1;
        CHECK(tangent_error(scene) < 1e-6);
        // Its work in the step is that of the undamped forces, or less.
        State undamped = scene.state;
        undamped.trial_time = 0.0;
        CHECK(scene.pairs().compute_work(scene.state) < scene.pairs().compute_work(undamped));
    }
}

TEST_CASE("Pairs: friction is remembered as it was, of what touches", "[assembly][touch]") {
    const Scene scene("friction = 0.3");
    State state = scene.state;
    contact_assembly_of(scene.system)->commit(state, 1.0);
    const std::vector<PairTraction>& pairs = state.pair_tractions;
    REQUIRE(pairs.size() > 10);
    CHECK(std::ranges::is_sorted(pairs, {}, &PairTraction::pieces));
    const std::vector<PairTractionRow> rows = pack(pairs);
    CHECK(rows.size() >= pairs.size());
    CHECK((rows.size() & (rows.size() - 1)) == 0);
    const std::vector<PairTraction> again = unpack(rows);
    REQUIRE(again.size() == pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        CHECK(again[i].pieces == pairs[i].pieces);
        CHECK(again[i].traction == pairs[i].traction);
    }
    // Without a further motion it stays.
    state.previous = state.trial;
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        state.previous[i].theta.setZero();
        state.trial[i].theta.setZero();
    }
    const std::vector<PairTraction> before = pairs;
    contact_assembly_of(scene.system)->commit(state, 1.0);
    REQUIRE(state.pair_tractions.size() == before.size());
    for (std::size_t i = 0; i < before.size(); ++i)
        CHECK((state.pair_tractions[i].traction - before[i].traction).norm() <
              1e-9 * before[i].traction.norm());
}

TEST_CASE("Pairs: a limited increment lets no rods pass", "[assembly][touch]") {
    const Scene scene;
    RandomValues random(7);
    int shortened = 0;
    for (int sample = 0; sample < 30; ++sample) {
        State state = scene.state;
        std::vector<Vec6> increments;
        for (std::size_t i = 0; i < state.trial.size(); ++i)
            increments.emplace_back() << random.vector(sample % 2 == 0 ? 0.05 : 1.0), Vec3::Zero();
        const ContactLimits limits = contact_assembly_of(scene.system)->limit(increments, state, 1.0);
        shortened += limits.shorten() ? 1 : 0;
        for (int part = 1; part <= 20; ++part) {
            State moved = scene.state;
            for (std::size_t i = 0; i < moved.trial.size(); ++i) {
                const int of_node = scene.system.scale_groups().part_of_node(static_cast<int>(i));
                moved.trial[i].r += part / 20.0 * limits.of_parts[static_cast<std::size_t>(of_node)] *
                                    increments[i].head<3>();
            }
            contact_assembly_of(scene.system)->search(moved);
            ContactCount count{0, 1.0};
            scene.pairs().count(moved, count);
            CHECK(count.least_gap > 0.0);
        }
    }
    CHECK(shortened > 10);
}

TEST_CASE("Pairs: what an increment takes into touch is expected to touch", "[assembly][touch]") {
    const Problem problem = test::read(R"(
[section.s]
shape = { circle = { radius = 0.01 } }
material = { E = 1e9, nu = 0.3, density = 1000 }
[rod.a]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 1
[rod.b]
section = "s"
line = { from = [0.25, -0.5, 0.021], to = [0.25, 0.5, 0.021] }
elements = 1
[contact]
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.1
)");
    const System system(problem.model);
    const ContactPairs& pairs = contact_assembly_of(system)->pairs();
    State state = system.initial_state();
    // b goes down by three times the gap, of 5 skins.
    const double gap = 1e-3, skin = 2e-4;
    const auto moved_by = [](double z) {
        std::vector<Vec6> increments(4, Vec6::Zero());
        increments[2][2] = increments[3][2] = z;
        return increments;
    };
    ContactLimits limits = contact_assembly_of(system)->limit(moved_by(-3.0 * gap), state, 1.0);
    CHECK(limits.least < 1.0 / 3.0);
    REQUIRE(state.contact.pieces.size() == 1);
    CHECK(state.contact.pieces_expected[0] == -0.8);
    CHECK(pairs.list_groups(state).size() == 1);
    const auto taken_force = [&](const State& at) {
        Residual residual;
        residual.nodal.assign(at.trial.size(), Vec6::Zero());
        pairs.replace_by_tangent_forces(at, -1.0, residual);
        return residual.nodal;
    };
    // Nothing touches, so the true force is zero; that of the linear solution pulls both together, on the
    // arms of the crossing, and has the tangent's stiffness.
    const std::vector<Vec6> before = taken_force(state);
    CHECK(before[0][2] == Approx(3.0 * before[1][2]));
    CHECK(before[2][2] == Approx(before[3][2]));
    CHECK((before[0] + before[1] + before[2] + before[3]).norm() < 1e-12 * before[0].norm());
    CHECK(before[2][2] < 0.0);
    std::vector<NodeLinearization> linearizations(4);
    LoadStepping().linearize(state, stage, linearizations);
    const std::vector<PairBlock> blocks = pairs.compute_tangents(state, 1.0, linearizations);
    REQUIRE(blocks.size() == 1);
    State moved = state;
    for (const std::size_t node : {2, 3}) moved.trial[node].r.z() -= 0.1 * skin;
    const std::vector<Vec6> after = taken_force(moved);
    const Eigen::MatrixXd& K = blocks[0].matrix;
    CHECK(after[2][2] - before[2][2] == Approx(0.1 * skin * (K(14, 14) + K(14, 20))).epsilon(1e-9));
    CHECK(after[0][2] - before[0][2] == Approx(0.1 * skin * (K(2, 14) + K(2, 20))).epsilon(1e-9));
    // Where solutions go on to lead into the other rod, a greater force is expected, up to a bound.
    State pushed = state;
    contact_assembly_of(system)->limit(moved_by(-0.9 * gap), pushed, 1.0);
    const double firmer = pushed.contact.pieces_expected[0];
    CHECK(firmer == Approx(advance_contact({skin, 2.0 * M_PI * 1e-4 * 1e9 / 1000.0}, -0.8, gap, -0.9 * gap)));
    CHECK(firmer > -0.8);
    CHECK(firmer < 0.5);
    contact_assembly_of(system)->limit(moved_by(-3.0 * gap), pushed, 1.0);
    CHECK(pushed.contact.pieces_expected[0] == 0.5);
    // Where the solution leads away it is forgotten.
    limits = contact_assembly_of(system)->limit(moved_by(gap), state, 1.0);
    CHECK(limits.least == 1.0);
    CHECK(state.contact.pieces_expected[0] == no_contact);
}

TEST_CASE("Pairs: the number of threads changes nothing", "[assembly][touch]") {
    const Scene scene;
    const ThreadTeam team(3);
    const System several(scene.problem.model, team);
    CHECK(forces_of(scene.system, scene.state) == forces_of(several, scene.state));
    std::vector<NodeLinearization> linearizations(scene.state.trial.size());
    LoadStepping().linearize(scene.state, stage, linearizations);
    const std::vector<PairBlock> one = scene.pairs().compute_tangents(scene.state, 1.0, linearizations);
    const std::vector<PairBlock> other =
        contact_assembly_of(several)->pairs().compute_tangents(scene.state, 1.0, linearizations);
    REQUIRE(one.size() == other.size());
    for (std::size_t i = 0; i < one.size(); ++i) CHECK(one[i].matrix == other[i].matrix);
}

TEST_CASE("Pairs: a matrix with pairs is the system's and their blocks'", "[assembly][touch]") {
    const Scene scene;
    std::vector<NodeLinearization> linearizations(scene.state.trial.size());
    LoadStepping().linearize(scene.state, stage, linearizations);
    std::vector<double> values;
    scene.system.compute_tangent(scene.state, 1.0, linearizations, values);
    std::vector<PairBlock> blocks = scene.pairs().compute_tangents(scene.state, 1.0, linearizations);
    Eigen::MatrixXd expected = make_dense(scene.system.pattern(), values);
    for (const PairBlock& block : blocks) {
        for (std::size_t i = 0; i < block.nodes.size(); ++i) {
            const auto rows = scene.system.equations().of_node(block.nodes[i]);
            for (std::size_t j = 0; j < block.nodes.size(); ++j) {
                const auto columns = scene.system.equations().of_node(block.nodes[j]);
                for (int k = 0; k < 6; ++k) {
                    for (int l = 0; l < 6; ++l) {
                        if (rows[static_cast<std::size_t>(k)] < 0 || columns[static_cast<std::size_t>(l)] < 0)
                            continue;
                        expected(rows[static_cast<std::size_t>(k)], columns[static_cast<std::size_t>(l)]) +=
                            block.matrix(static_cast<Eigen::Index>(6 * i) + k,
                                         static_cast<Eigen::Index>(6 * j) + l);
                    }
                }
            }
        }
    }
    expected.diagonal().array() += 1e3;  // of the rods that nothing holds
    for (std::size_t i = 0; i < static_cast<std::size_t>(scene.system.pattern().size()); ++i)
        values[static_cast<std::size_t>(
            scene.system.pattern().slot(static_cast<std::int64_t>(i), static_cast<std::int64_t>(i)))] += 1e3;
    PairedMatrix matrix(scene.system, LinearSolverKind::automatic);
    matrix.start({});
    matrix.set_values(values, blocks);
    REQUIRE(matrix.factorize().regular);
    Eigen::VectorXd solution = RandomValues(5).matrix<1, 1>()(0, 0) * Eigen::VectorXd::Ones(expected.rows());
    for (Eigen::Index i = 0; i < solution.size(); ++i) solution[i] = std::sin(1.0 + static_cast<double>(i));
    const Eigen::VectorXd right = solution;
    matrix.solve(solution);
    CHECK((expected * solution - right).norm() < 1e-8 * right.norm());
    SECTION("the same groups need no new order, others do") {
        const int before = matrix.orderings();
        matrix.set_values(values, blocks);
        CHECK(matrix.orderings() == before);
        matrix.start(scene.pairs().list_groups(scene.state));
        CHECK(matrix.orderings() == before + 1);
        matrix.set_values(values, blocks);
        matrix.start(scene.pairs().list_groups(scene.state));
        CHECK(matrix.orderings() == before + 1);
        matrix.start({});
        CHECK(matrix.orderings() == before + 2);
    }
}

TEST_CASE("Pairs: rods do not touch where they are connected, nor a rod its neighbourhood",
          "[assembly][touch]") {
    const Problem problem = test::read(R"(
[section.s]
shape = { circle = { radius = 0.05 } }
material = { E = 1e6, nu = 0.3 }
[rod.a]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 10
[rod.b]
section = "s"
line = { from = [1, 0, 0], to = [1.2, 1, 0] }
elements = 10
[[connect]]
points = ["a.end", "b.start"]
[[support]]
at = "a.start"
fix = "all"
[contact]
[analysis]
kind = "static"
)");
    const System system(problem.model);
    State state = system.initial_state();
    contact_assembly_of(system)->search(state);
    ContactCount count{0, 1.0};
    contact_assembly_of(system)->pairs().count(state, count);
    CHECK(count.touching == 0);
    CHECK(contact_assembly_of(system)->describe_overlap(state, 0.0).empty());
}

TEST_CASE("Pairs: rods that overlap are named", "[assembly][touch]") {
    const Problem problem = test::read(test::replaced(tangle(), "0.4, -0.5, 0.12", "0.4, -0.5, 0.07"));
    const System system(problem.model);
    State state = system.initial_state();
    contact_assembly_of(system)->search(state);
    const std::string text = contact_assembly_of(system)->describe_overlap(state, 0.0);
    CHECK(text.starts_with("a@"));
    CHECK(text.find(" and b@") != std::string::npos);
    CHECK(text.find("their radii add up to 0.1") != std::string::npos);
}
