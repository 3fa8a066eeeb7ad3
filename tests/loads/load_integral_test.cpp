// Loads whose form changes within elements: totals, moments and shares of nodes against integrals known
// exactly.
#include "loads/load_integral.hpp"
#include "assembly/system_measures.hpp"

#include "assembly/system.hpp"
#include "loads/distributed_load.hpp"
#include "model/evaluation_error.hpp"
#include "numerics/gauss_legendre.hpp"
#include "numerics/lagrange.hpp"
#include "tools/catch.hpp"
#include "tools/random_values.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double length = 10.0;

using Profile = std::function<double(double, double)>;  // of t and s

// A load along global z whose form changes where `arguments` cross 0.
DistributedLoad make_load(const Profile& profile,
                          const std::vector<Profile>& arguments,
                          Frame frame = Frame::spatial,
                          LineForm form = {}) {
    Switches switches;
    for (const Profile& argument : arguments) switches.push_back({argument, {0.0}});
    DistributedLoad load;
    load.key = "load[0]";
    load.frame = frame;
    load.force[2] = LineFunction(profile, std::make_shared<const Switches>(switches), form);
    return load;
}

Model make_model(const Mesh& mesh, const DistributedLoad& load) {
    Model model = make_rod_model(along_x, length, mesh, make_section({1, 1, 1, 1, 1, 1}));
    model.distributed_loads.push_back(load);
    return model;
}

std::vector<Vec6> compute_loads(const System& system, const State& state, double time) {
    return SystemMeasures(system).compute_load_forces(state, time);
}

// Force along z, and minus its moment about y.
struct Total {
    double force = 0.0;
    double moment = 0.0;
};

Total add_up(const std::vector<Vec6>& nodal, const State& state) {
    Total total;
    for (std::size_t i = 0; i < nodal.size(); ++i) {
        total.force += nodal[i][2];
        total.moment += nodal[i][2] * state.trial[i].r.x() - nodal[i][4];
    }
    return total;
}

Total compute_total(const Model& model, double time) {
    const System system(model);
    const State state = system.initial_state();
    return add_up(compute_loads(system, state, time), state);
}

// ∫ q ds and ∫ s q ds of a unit load from `from` to `to`.
void check_patch(const Total& total, double from, double to) {
    CHECK(std::abs(total.force - (to - from)) < 1e-13);
    CHECK(std::abs(total.moment - 0.5 * (to * to - from * from)) < 1e-12);
}

const std::vector<Mesh> meshes{{1, 1}, {3, 1}, {10, 1}, {1, 2}, {7, 2}, {2, 3}, {10, 3}, {3, 4}, {25, 4}};

DistributedLoad make_patch(double from, double to, Frame frame = Frame::spatial) {
    return make_load([=](double, double s) { return s > from && s < to ? 1.0 : 0.0; },
                     {[=](double, double s) { return s - from; }, [=](double, double s) { return s - to; }},
                     frame);
}

}  // namespace

TEST_CASE("A patch has its force and moment on every mesh", "[loads]") {
    for (const Mesh& mesh : meshes) {
        INFO(mesh.elements << " elements of order " << mesh.order);
        for (const Frame frame : {Frame::spatial, Frame::follower, Frame::body}) {
            check_patch(compute_total(make_model(mesh, make_patch(2.0, 2.5, frame)), 0.0), 2.0, 2.5);
            check_patch(compute_total(make_model(mesh, make_patch(0.3, 9.9, frame)), 0.0), 0.3, 9.9);
            // Far narrower than an element, so that samples would miss it.
            check_patch(compute_total(make_model(mesh, make_patch(4.2, 4.20001, frame)), 0.0), 4.2, 4.20001);
            // From node to node, and over the ends of the rod.
            check_patch(compute_total(make_model(mesh, make_patch(0.0, 10.0, frame)), 0.0), 0.0, 10.0);
            check_patch(compute_total(make_model(mesh, make_patch(-3.0, 5.0, frame)), 0.0), 0.0, 5.0);
        }
    }
}

TEST_CASE("A patch that travels has its force and moment at all times", "[loads]") {
    const DistributedLoad patch =
        make_load([](double t, double s) { return s > 20.0 * t && s < 20.0 * t + 0.07 ? 1.0 : 0.0; },
                  {[](double t, double s) { return s - 20.0 * t; },
                   [](double t, double s) { return s - 20.0 * t - 0.07; }});
    for (const Mesh& mesh : meshes) {
        INFO(mesh.elements << " elements of order " << mesh.order);
        const Model model = make_model(mesh, patch);
        const System system(model);
        const State state = system.initial_state();
        for (int i = 0; i < 50; ++i) {
            const double time = 0.0099 * i;
            check_patch(add_up(compute_loads(system, state, time), state), 20.0 * time, 20.0 * time + 0.07);
        }
        // It leaves the rod at its end.
        check_patch(add_up(compute_loads(system, state, 0.498), state), 9.96, 10.0);
        CHECK(add_up(compute_loads(system, state, 0.6), state).force == 0.0);
    }
}

TEST_CASE("Smooth loads and loads with kinks and unbounded slopes are integrated", "[loads]") {
    for (const Mesh& mesh : meshes) {
        INFO(mesh.elements << " elements of order " << mesh.order);
        const Total sine = compute_total(
            make_model(mesh, make_load([](double, double s) { return std::sin(2.0 * s); }, {})), 0.0);
        CHECK(std::abs(sine.force - 0.5 * (1.0 - std::cos(20.0))) < 1e-8 * length);
        const Total hat = compute_total(
            make_model(
                mesh,
                make_load([](double, double s) { return std::max(0.0, 1.0 - std::abs(s - 5.05) / 0.01); },
                          {[](double, double s) { return s - 5.05; },
                           [](double, double s) { return 1.0 - std::abs(s - 5.05) / 0.01; }})),
            0.0);
        CHECK(std::abs(hat.force - 0.01) < 1e-14);
        CHECK(std::abs(hat.moment - 0.0505) < 1e-13);
        const Total root =
            compute_total(make_model(mesh,
                                     make_load([](double, double s) { return std::sqrt(std::abs(s - 3.3)); },
                                               {[](double, double s) { return s - 3.3; }},
                                               Frame::spatial,
                                               {.in_time = InTime::constant, .is_even = false})),
                          0.0);
        const double exact = 2.0 / 3.0 * (std::pow(3.3, 1.5) + std::pow(6.7, 1.5));
        CHECK(std::abs(root.force - exact) < 1e-7);
    }
}

TEST_CASE("Nodes share a load by their shape functions, dead or turned", "[loads]") {
    // Of one element from 0 to 10: ∫ N_I q ds, and Σ_J Λ_J ∫ N_I N_J q ds, by a rule of many points over the
    // patch.
    RandomValues random(172);
    for (const Frame frame : {Frame::spatial, Frame::follower, Frame::body}) {
        const Model model = make_model({1, 3}, make_patch(2.3, 7.1, frame));
        const System system(model);
        State state = system.initial_state();
        for (NodeMotion& motion : state.trial) motion.Lambda = random.rotation();
        std::vector<Vec3> expected(4, Vec3::Zero());
        for (const auto& [xi, weight] : compute_gauss_rule<12>()) {
            const double s = 4.7 + 2.4 * xi;
            const NodeValues<4> shape = compute_shape_functions<4>(0.2 * s - 1.0);
            Vec3 turned = Vec3::Zero();
            for (int j = 0; j < 4; ++j) turned += shape[j] * (state.trial[j].Lambda * Vec3::UnitZ());
            const Vec3 q = frame == Frame::spatial ? Vec3(Vec3::UnitZ()) : turned;
            for (int i = 0; i < 4; ++i) expected[i] += 2.4 * weight * shape[i] * q;
        }
        const auto nodal = compute_loads(system, state, 0.0);
        for (int i = 0; i < 4; ++i) CHECK((nodal[i].head<3>() - expected[i]).norm() < 1e-13);
    }
}

TEST_CASE("What has been asked for before changes no load", "[loads]") {
    const Mesh mesh{7, 2};
    const auto travelling = make_load([](double t, double s) { return s > t ? 1.0 + t * s : 0.0; },
                                      {[](double t, double s) { return s - t; }});
    const auto proportional = make_load([](double t, double s) { return t * std::sin(s); },
                                        {},
                                        Frame::body,
                                        {.in_time = InTime::proportional, .is_even = false});
    const auto fixed = make_load([](double, double s) { return std::cos(s); },
                                 {},
                                 Frame::spatial,
                                 {.in_time = InTime::constant, .is_even = false});
    Model model = make_model(mesh, travelling);
    model.distributed_loads.push_back(proportional);
    model.distributed_loads.push_back(fixed);
    const System asked_often(model);
    const State state = asked_often.initial_state();
    for (const double time : {0.3, 0.9, 0.3, 0.0, 0.7}) {
        const System fresh(model);
        CHECK(compute_loads(asked_often, state, time) == compute_loads(fresh, state, time));
    }
}

TEST_CASE("A load that is known to be proportional or even is what its function says", "[loads]") {
    const Profile function = [](double t, double s) { return t * (1.0 + std::sin(s)); };
    const Profile even = [](double t, double) { return std::exp(t); };
    for (const Mesh& mesh : meshes) {
        const Total known = compute_total(
            make_model(
                mesh,
                make_load(function, {}, Frame::spatial, {.in_time = InTime::proportional, .is_even = false})),
            0.37);
        // 1 + sin s and s (1 + sin s), each from 0 to 10.
        CHECK(std::abs(known.force - 0.37 * (length + 1.0 - std::cos(length))) < 1e-8 * length);
        CHECK(std::abs(known.moment - 0.37 * (0.5 * length * length + std::sin(length) -
                                              length * std::cos(length))) < 1e-8 * length * length);
        const Total varying = compute_total(make_model(mesh, make_load(function, {})), 0.37);
        CHECK(std::abs(known.force - varying.force) < 1e-6 * length);
        CHECK(std::abs(known.moment - varying.moment) < 1e-6 * length * length);
        const Total flat = compute_total(
            make_model(mesh,
                       make_load(even, {}, Frame::spatial, {.in_time = InTime::varying, .is_even = true})),
            0.37);
        CHECK(std::abs(flat.force - length * std::exp(0.37)) < 1e-13);
    }
}

TEST_CASE("A load without an integral is refused, with its key, place and time", "[loads]") {
    const auto message_of = [](const Profile& profile) -> std::string {
        try {
            compute_total(make_model({4, 1}, make_load(profile, {})), 0.25);
        } catch (const EvaluationError& error) {
            return error.what();
        }
        return "";
    };
    const std::string wild = message_of([](double, double s) { return std::sin(1e7 * s); });
    CHECK(wild.starts_with(
        "load[0]: the load per length has no integral that can be found from s = 0 to s = 2.5 "
        "at t = 0.25: after "));
    CHECK(message_of([](double, double s) { return 1.0 / (s - 3.3); }).starts_with("load[0]: "));
}
