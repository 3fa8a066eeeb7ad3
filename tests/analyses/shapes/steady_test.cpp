#include "analyses/steady.hpp"

#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/steady_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using Catch::Contains;

namespace {

Model make_arm(const Section& section) {
    Model model = make_rod_model(along_x, 1.0, {4, 3}, section);
    clamp(model, 0);
    return model;
}

Section make_light_section() {
    return make_section({1e2, 4e1, 4e1, 0.8, 1.0, 2.0}, {1.0, 1.0, 1.0, 5e-2, 1e-2, 4e-2});
}

}  // namespace

TEST_CASE("a rod that turns is stretched as d(EA u′)/dx + ρA Ω² (x + u) = 0 says", "[analyses]") {
    const Model model = make_arm(make_light_section());
    constexpr double speed = 5.0;
    const SteadyRun run(model, ramped_frame(Vec3::UnitZ(), speed), make_static_settings(4));
    // x + u = sin(kx)/cos(k)·(1 + …): with u(0) = 0 and u′(1) = 0, x + u = sin(k x) / (k cos k).
    const double k = speed * std::sqrt(1.0 / 1e2);
    CHECK(run.tip().r[0] == Approx(std::tan(k) / k).epsilon(1e-8));
    CHECK(run.tip().v[1] == Approx(speed * run.tip().r[0]).epsilon(1e-12));
    CHECK(run.tip().a[0] == Approx(-speed * speed * run.tip().r[0]).epsilon(1e-12));
    CHECK(run.tip().omega[2] == speed);
    // What holds it is what turns its mass: Ω² ∫ ρA (x + u) ds.
    CHECK(run.reactions()[0][0] == Approx(-1e2 * (1.0 / std::cos(k) - 1.0)).epsilon(1e-8));
}

TEST_CASE("Newton's method converges quadratically in a turning frame, mixed or not", "[analyses]") {
    const Vec3 axis = Vec3(0.2, 0.3, 1.0).normalized();
    Model model = make_arm(make_light_section());
    add_ramp(model, last_node(model), {0.0, 1.0, 2.0}, Vec3::Zero(), Frame::follower);
    for (const TangentKind tangent : {TangentKind::consistent, TangentKind::mixed, TangentKind::difference}) {
        StaticSettings settings = make_static_settings(4);
        settings.newton.tangent = tangent;
        const SteadyRun run(model, ramped_frame(axis, 3.0), settings);
        CHECK(run.iterations() <= 24);
        CHECK(run.rejected() == 0);
    }
}

TEST_CASE("the arm of a rotor moves with its frame: from steady rotation to dynamics nothing changes",
          "[analyses]") {
    Model model = make_arm(make_light_section());
    const SteadyRun run(model, ramped_frame(Vec3::UnitZ(), 4.0), make_static_settings(4));
    Residual residual;
    run.analysis().system().compute_residual(run.analysis().state(), 1.0, residual);
    const System& system = run.analysis().system();
    CHECK(gather(residual.nodal, system.equations()).norm() < 1e-9);
}

TEST_CASE("loads that do not turn with the frame are refused", "[analyses]") {
    const auto make = [](const Model& model) {
        return SteadyAnalysis(model, make_static_settings(1), ramped_frame(Vec3::UnitZ(), 1.0));
    };
    Model model = make_arm(make_light_section());
    add_ramp(model, last_node(model), {0.0, 1.0, 0.0}, Vec3::Zero());
    model.loads.back().key = "load[0]";
    CHECK_THROWS_WITH(make(model), Contains("load[0] is fixed in space"));
    model.loads.back().frame = Frame::body;
    CHECK_NOTHROW(make(model));
    model.loads.clear();
    add_ramp(model, last_node(model), {0.0, 0.0, 1.0}, {0.0, 0.0, 2.0});
    CHECK_NOTHROW(make(model));
    model.gravity = TimeVector(Vec3(0.0, 0.0, -9.81));
    CHECK_NOTHROW(make(model));
    model.gravity = TimeVector(Vec3(0.0, -9.81, 0.0));
    CHECK_THROWS_WITH(make(model), Contains("gravity is not along the axis"));
    model.gravity = TimeVector(Vec3::Zero());
    DistributedLoad wind;
    wind.key = "load[1]";
    wind.force[0] = LineFunction([](double, double s) { return s > 0.6 ? 1.0 : 0.0; });
    model.distributed_loads.push_back(wind);
    CHECK_THROWS_WITH(make(model), Contains("load[1] is fixed in space"));
    model.distributed_loads.clear();
    Spring spring;
    spring.name = "s";
    spring.ends = {Anchor{-1, Vec3(0.0, 0.0, 3.0)}, Anchor{last_node(model)}};
    spring.length = 1.0;
    model.springs.push_back(spring);
    CHECK_NOTHROW(make(model));
    model.springs[0].ends[0].arm.x() = 0.1;
    CHECK_THROWS_WITH(
        make(model),
        Contains("spring.s is tied to the ground off the axis: in a frame that turns about [0, 0, 1]"));
    model.springs.clear();
    // Water at rest is the same from everywhere.
    model.surroundings.water = Water{.density = 1.0};
    CHECK_NOTHROW(make(model));
    model.surroundings.water->current.field = [](double, const Vec3&) { return Vec3(1.0, 0.0, 0.0); };
    CHECK_THROWS_WITH(make(model), Contains("the current of fluid is not alike to all sides"));
    // Along the axis, and faster with the distance from it.
    model.surroundings.water->current.field = [](double, const Vec3& r) {
        return Vec3(0.0, 0.0, 1.0 + r.x() * r.x() + r.y() * r.y());
    };
    CHECK_NOTHROW(make(model));
    model.surroundings.water->current.field = [](double, const Vec3& r) {
        return Vec3(0.0, 0.0, 1.0 + r.x());
    };
    CHECK_THROWS_WITH(make(model), Contains("the current of fluid is not alike to all sides"));
    model.surroundings.water->current = {};
    model.surroundings.water->surface = 1.0;
    CHECK_NOTHROW(make(model));
    model.loads.clear();
    CHECK_THROWS_WITH(
        SteadyAnalysis(model, make_static_settings(1), ramped_frame(Vec3::UnitX(), 1.0)),
        Contains("the surface of fluid is not alike to all sides of the axis of rotation [1, 0, 0]"));
    model.surroundings.water.reset();
    model.surroundings.seabed = Seabed{};
    CHECK_NOTHROW(make(model));
    model.surroundings.seabed->normal = Vec3(0.0, 0.6, 0.8);
    CHECK_THROWS_WITH(make(model), Contains("seabed is not alike to all sides"));
    model.surroundings.seabed.reset();
    // Between the cross-coupled forces of a bearing and a spring along x.
    add_ramp(model, last_node(model), Vec3::Zero(), Vec3::Zero());
    model.loads.back().key = "load[0]";
    const MotionLoad bearing([](double, const Vec3& r, const Vec3& v) {
        return Vec3(-2.0 * r.y() - v.x(), 2.0 * r.x() - v.y(), 0.0);
    });
    const MotionLoad sideways([](double, const Vec3& r, const Vec3&) { return Vec3(-r.x(), 0.0, 0.0); });
    MotionLoad by_turn = bearing;
    by_turn.turns = true;
    model.loads.back().by_motion = bearing;
    CHECK_NOTHROW(make(model));
    model.loads.back().by_motion = sideways;
    CHECK_THROWS_WITH(make(model), Contains("load[0] depends on where its point is"));
    model.loads.back().by_motion = by_turn;
    CHECK_THROWS_WITH(make(model), Contains("load[0] depends on how its point has turned"));
    model.loads.pop_back();
    DistributedLoad along;
    along.key = "load[1]";
    along.by_motion = bearing;
    model.distributed_loads.push_back(along);
    CHECK_NOTHROW(make(model));
    model.distributed_loads.back().by_motion = sideways;
    CHECK_THROWS_WITH(make(model), Contains("load[1] depends on where its point is"));
}

TEST_CASE("a mass on a spring to the axis goes to where the spring holds it", "[analyses][springs]") {
    constexpr double mass = 0.5, stiffness = 40.0, omega = 4.0;
    Model model;
    model.nodes.push_back({"bob", Vec3(1.0, 0.0, 0.0)});
    Body body;
    body.mass = mass;
    body.inertia = Mat3::Identity();
    model.bodies.push_back(body);
    Support support;
    support.fixed = {false, true, true, true, true, true};
    model.supports.push_back(support);
    Spring spring;
    spring.ends = {Anchor{}, Anchor{0}};
    spring.stiffness = stiffness;
    spring.damping = 3.0;  // the length stays
    spring.length = 1.0;
    model.springs.push_back(spring);
    const SteadyRun run(model, ramped_frame(Vec3::UnitZ(), omega), make_static_settings(4));
    // k (r − ℓ₀) = m Ω² r.
    const double r = stiffness / (stiffness - mass * omega * omega);
    CHECK(run.analysis().state().trial[0].r.x() == Approx(r).epsilon(1e-11));
}
