#include "assembly/sample_model.hpp"

#include "state/increment.hpp"
#include "tools/rod_models.hpp"

namespace gxrod::tools {

namespace {

Rod make_rod(const Quat& axes, const Vec3& start, std::vector<Node>& nodes) {
    Rod rod;
    rod.name = "arm";
    rod.kind = ElementKind::simo;
    std::vector<double> arc_length;
    for (int i = 0; i <= rod_end; ++i) {
        nodes.push_back({"arm node " + std::to_string(i), start + axes * Vec3(0.5 * i, 0.0, 0.0)});
        rod.nodes.push_back(i);
        arc_length.push_back(0.5 * i);
    }
    set_line_elements(rod, arc_length, std::vector<Quat>(arc_length.size(), axes));
    return rod;
}

Body make_body(RandomValues& random, int node, const Vec3& centre_of_mass) {
    Body body;
    body.name = "body at " + std::to_string(node);
    body.node = node;
    body.mass = random.number(0.5, 2.0);
    body.inertia = random.positive_definite<3>();
    body.centre_of_mass = centre_of_mass;
    body.attitude = random.rotation();
    return body;
}

NodalLoad make_load(RandomValues& random, int node, Frame frame) {
    NodalLoad load;
    load.node = node;
    load.frame = frame;
    load.axes = random.rotation();
    for (int i = 0; i < 3; ++i) {
        const double force = random.number(-3.0, 3.0);
        load.force[i] = TimeFunction([force](double t) { return (1.0 + t) * force; });
        load.moment[i] = random.number(-2.0, 2.0);
    }
    return load;
}

}  // namespace

Model make_sample_model() {
    RandomValues random(81);
    Model model;
    model.gravity = Vec3(0.1, 0.4, -9.0);
    Section section{"tube", random.positive_definite<6>(), Mat6::Zero()};
    section.mass.topLeftCorner<3, 3>() = 1.3 * Mat3::Identity();
    section.mass.bottomRightCorner<3, 3>() = random.positive_definite<3>();
    model.sections.push_back(section);
    model.rods.push_back(make_rod(random.rotation(), random.vector(), model.nodes));
    model.nodes.push_back({"lone", random.vector()});
    for (Node& node : model.nodes) {
        node.velocity = random.vector();
        node.angular_velocity = random.vector();
    }
    model.bodies.push_back(make_body(random, rod_end, random.vector()));
    model.bodies.push_back(make_body(random, lone_node, random.vector()));
    model.loads.push_back(make_load(random, 1, Frame::spatial));
    model.loads.push_back(make_load(random, 2, Frame::follower));
    model.loads.push_back(make_load(random, rod_end, Frame::body));
    model.loads.push_back(make_load(random, lone_node, Frame::follower));
    model.supports.push_back({0, {true, true, true, false, false, false}});
    model.supports.push_back({lone_node, {false, false, false, true, true, false}});
    return model;
}

namespace {

Support make_moving_hinge(RandomValues& random) {
    Support support{.axes = random.rotation()};
    support.fixed = {true, false, true, true, true, false};
    support.moved[1] = true;
    support.motion[1] = TimeFunction([](double t) { return 0.1 * t * t; });
    return support;
}

DistributedLoad make_distributed_load(RandomValues& random, Frame frame) {
    DistributedLoad load;
    load.frame = frame;
    for (int i = 0; i < 3; ++i) {
        const double force = random.number(-3.0, 3.0);
        const double moment = random.number(-2.0, 2.0);
        load.force[i] = LineFunction([force](double t, double s) { return force * (1.0 + t * s); });
        load.moment[i] = LineFunction([moment](double t, double s) { return moment * (t - s * s); });
    }
    return load;
}

}  // namespace

Model make_turned_model(ElementKind kind, int order) {
    RandomValues random(82);
    const Quat axes = random.rotation();
    const Line arc = [&](double s) {
        return Placement{axes * Vec3(std::sin(s), 1.0 - std::cos(s), 0.2 * s),
                         axes * exp_quaternion(s * Vec3(0.2, 0.0, 1.0))};
    };
    Section section{"tube", random.positive_definite<6>()};
    const Mat3 spin_d = spin(random.vector(0.5));
    section.mass << 1.3 * Mat3::Identity(), -1.3 * spin_d, 1.3 * spin_d,
        random.positive_definite<3>() - 1.3 * spin_d * spin_d;
    section.kelvin_voigt = 0.2;
    section.mass_proportional = 0.6;
    Model model = make_rod_model(arc, 1.2, {2, order, kind}, section);
    model.gravity = Vec3(0.1, 0.4, -9.0);
    const int end = last_node(model);
    model.supports.push_back(make_moving_hinge(random));
    model.supports.push_back({.node = end, .fixed = {false, true}, .axes = random.rotation()});
    model.bodies.push_back(make_body(random, end, random.vector()));
    for (const Frame frame : {Frame::spatial, Frame::follower, Frame::body}) {
        model.loads.push_back(make_load(random, end, frame));
        model.distributed_loads.push_back(make_distributed_load(random, frame));
    }
    return model;
}

State make_turned_state(const System& system, unsigned seed) {
    RandomValues random(seed);
    State state = system.initial_state();
    const Quat common = random.rotation();
    const Vec3 turn = random.number(0.2, 1.5) * random.direction();
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        NodeMotion& previous = state.previous[i];
        previous.r += random.vector(0.1);
        previous.Lambda = exp_quaternion(random.vector(0.3)) * common;
        previous.v = random.vector();
        previous.a = random.vector();
        previous.omega = random.vector();
        previous.alpha = random.vector();
        place(previous, previous.r + random.vector(0.1), turn + random.vector(0.3), state.trial[i]);
    }
    for (SectionHistory& history : state.sections) history = {random.rotation(), random.vector(0.4)};
    return state;
}

State make_sample_state(const System& system, unsigned seed) {
    RandomValues random(seed);
    State state = system.initial_state();
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        NodeMotion& previous = state.previous[i];
        previous.r += random.vector(0.2);
        previous.Lambda = random.rotation();
        previous.v = random.vector();
        previous.a = random.vector();
        previous.omega = random.vector();
        previous.alpha = random.vector();
        place(previous,
              previous.r + random.vector(0.2),
              random.number(0.2, 1.2) * random.direction(),
              state.trial[i]);
    }
    for (SectionHistory& history : state.sections) history = {random.rotation(), random.vector(0.4)};
    return state;
}

}  // namespace gxrod::tools
