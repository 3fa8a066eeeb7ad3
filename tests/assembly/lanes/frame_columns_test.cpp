#include "assembly/lanes/frame_columns.hpp"

#include "assembly/sample_model.hpp"
#include "assembly/scatter.hpp"
#include "integrators/steady_rotation.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double now = 0.7;

TurningFrame make_frame() {
    return {.axis = Vec3(1.0, -2.0, 0.5).normalized(),
            .through = Vec3(0.3, -0.2, 0.4),
            .speed = TimeFunction([](double t) { return 3.0 * t; })};
}

// The derivative of the residual by motions (ρ, ψ), (ρ′, ψ′), (ρ″, ψ″) relative to the frame, of each
// unknown.
template <class Move>
Eigen::MatrixXd differentiate_residual(const System& system, const State& state, Move&& move) {
    const std::int64_t size = system.equations().count();
    Eigen::MatrixXd derivative(size, size);
    for (std::int64_t j = 0; j < size; ++j) {
        const int node = system.equations().unknown(j).node;
        const Vec6 direction = system.equations().increment_of(node, Eigen::VectorXd::Unit(size, j));
        derivative.col(j) = differentiate(
            [&](double amount) {
                State moved = state;
                move(Vec6(amount * direction), state.previous[node], moved.trial[node]);
                Residual residual;
                system.compute_residual(moved, now, residual);
                return gather(residual.nodal, system.equations());
            },
            1e-2);
    }
    return derivative;
}

void check_frame(const System& system, State state) {
    const TurningFrame frame = make_frame();
    const Vec3 spin = frame.spin(now);
    for (NodeMotion& motion : state.trial) turn_with(spin, frame.through, motion);
    const FrameColumns columns(system, frame);
    const StateMatrices matrices = columns.compute_matrices(state, now);
    const auto place_node = [&](const Vec6& by, const NodeMotion& previous, NodeMotion& trial) {
        apply_spin(previous, by.head<3>(), by.tail<3>(), trial);
        turn_with(spin, frame.through, trial);
    };
    const auto add_rate = [&](const Vec6& by, const NodeMotion&, NodeMotion& trial) {
        trial.v += by.head<3>();
        trial.omega += by.tail<3>();
        trial.a += 2.0 * spin.cross(by.head<3>());
        trial.alpha += spin.cross(by.tail<3>());
    };
    const auto accelerate = [](const Vec6& by, const NodeMotion&, NodeMotion& trial) {
        trial.a += by.head<3>();
        trial.alpha += by.tail<3>();
    };
    const auto compare = [&](const std::vector<double>& values, const Eigen::MatrixXd& differences) {
        CHECK(relative_difference(make_dense(system.pattern(), values), differences) < 1e-8);
    };
    compare(matrices.stiffness, differentiate_residual(system, state, place_node));
    compare(matrices.damping, differentiate_residual(system, state, add_rate));
    compare(matrices.mass, differentiate_residual(system, state, accelerate));

    std::vector<double> stiffness = compute_state_matrices(system, state, now).stiffness;
    columns.add_stiffness(state, now, stiffness);
    CHECK(relative_difference(make_dense(system.pattern(), stiffness),
                              make_dense(system.pattern(), matrices.stiffness)) < 1e-14);
}

void check_spinning(const System& system, State state) {
    TurningFrame frame = make_frame();
    frame.spinning.assign(state.trial.size(), true);
    frame.spinning.back() = false;
    for (std::size_t i = 0; i < state.trial.size(); ++i) set_steady_rates(frame, now, i, state.trial[i]);
    const StateMatrices matrices = FrameColumns(system, frame).compute_matrices(state, now);
    const auto differentiate_by = [&](auto&& move) {
        const std::int64_t size = system.equations().count();
        Eigen::MatrixXd derivative(size, size);
        for (std::int64_t j = 0; j < size; ++j) {
            const int node = system.equations().unknown(j).node;
            const Vec6 direction = system.equations().increment_of(node, Eigen::VectorXd::Unit(size, j));
            derivative.col(j) = differentiate(
                [&](double amount) {
                    State moved = state;
                    move(Vec6(amount * direction), static_cast<std::size_t>(node), moved);
                    Residual residual;
                    system.compute_residual(moved, now, residual);
                    return gather(residual.nodal, system.equations());
                },
                1e-2);
        }
        return derivative;
    };
    const auto compare = [&](const std::vector<double>& values, const Eigen::MatrixXd& differences) {
        CHECK(relative_difference(make_dense(system.pattern(), values), differences) < 1e-8);
    };
    compare(matrices.stiffness, differentiate_by([&](const Vec6& by, std::size_t node, State& moved) {
                apply_spin(state.previous[node], by.head<3>(), by.tail<3>(), moved.trial[node]);
                set_steady_rates(frame, now, node, moved.trial[node]);
            }));
    compare(matrices.damping, differentiate_by([&](const Vec6& by, std::size_t node, State& moved) {
                const Vec3 spin = frame.spin_of(node, moved.trial[node].Lambda, now);
                moved.trial[node].v += by.head<3>();
                moved.trial[node].omega += by.tail<3>();
                moved.trial[node].alpha += Vec3(by.tail<3>()).cross(spin);
            }));
    compare(matrices.mass, differentiate_by([&](const Vec6& by, std::size_t node, State& moved) {
                moved.trial[node].a += by.head<3>();
                moved.trial[node].alpha += by.tail<3>();
            }));
}

}  // namespace

TEST_CASE("matrices of parts that spin in a frame at rest are derivatives of the residual", "[assembly]") {
    for (const int order : {1, 3}) {
        const Model model = make_turned_model(ElementKind::objective, order);
        const System system(model);
        check_spinning(system, make_turned_state(system, 23));
    }
    const Model model = make_sample_model();
    const System system(model);
    check_spinning(system, make_sample_state(system, 24));
}

TEST_CASE("matrices in a turning frame see dampers of joints and bushings", "[assembly]") {
    Model model = make_turned_model(ElementKind::objective, 2);
    const int end = static_cast<int>(model.nodes.size()) - 1;
    Joint joint;
    joint.name = "damper";
    joint.kind = JointKind::free;
    joint.a.anchor.node = 0;
    joint.b.anchor.node = end;
    joint.slide.damping = 0.7;
    joint.turn.damping = 0.4;
    model.joints.push_back(joint);
    Bushing bearing{.name = "bearing",
                    .ends = {Anchor{-1, Vec3(0.3, -0.2, 0.4)}, Anchor{end, Vec3(0.1, 0.2, 0.3)}}};
    bearing.carrier = BushingAxes::ground;
    bearing.stiffness.topLeftCorner<3, 3>().setIdentity();
    bearing.damping.setIdentity();
    model.bushings.push_back(bearing);
    const System system(model);
    check_frame(system, make_turned_state(system, 25));
}

TEST_CASE("matrices in a turning frame are derivatives of the residual", "[assembly]") {
    for (const ElementKind kind : {ElementKind::objective, ElementKind::simo}) {
        for (const int order : {1, 2, 4}) {
            INFO((kind == ElementKind::simo ? "simo" : "objective") << ", order " << order);
            const Model model = make_turned_model(kind, order);
            const System system(model);
            check_frame(system, make_turned_state(system, 21));
        }
    }
    const Model model = make_sample_model();
    const System system(model);
    check_frame(system, make_sample_state(system, 22));
}
