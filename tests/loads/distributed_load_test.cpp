// Forces and moments along rods: what they put on nodes, against integrals known exactly.
#include "loads/distributed_load.hpp"
#include "assembly/system_measures.hpp"

#include "assembly/system.hpp"
#include "numerics/gauss_legendre.hpp"
#include "numerics/lagrange.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double length = 1.4;
constexpr double at_time = 0.0;  // of loads whose moments are given
const std::vector<std::pair<std::string, Frame>> frames{
    {"dead", Frame::spatial}, {"follower", Frame::follower}, {"body", Frame::body}};

using Distribution = std::function<Vec6(double, double)>;  // force and moment of t and s

DistributedLoad make_load(const Distribution& q, Frame frame) {
    DistributedLoad load;
    load.frame = frame;
    for (int i = 0; i < 3; ++i) {
        load.force[i] = LineFunction([q, i](double t, double s) { return q(t, s)[i]; });
        load.moment[i] = LineFunction([q, i](double t, double s) { return q(t, s)[i + 3]; });
    }
    return load;
}

// What the model's distributed loads put on nodes.
std::vector<Vec6> compute_loads(const Model& model, const State& state, double time) {
    return SystemMeasures(System(model)).compute_load_forces(state, time);
}

// ∫ N_I q ds over one straight element of a rod, by a rule of many points.
template <int Nodes>
std::vector<Vec6> integrate(const std::function<Vec6(double)>& q, double start, double size) {
    std::vector<Vec6> nodal(Nodes, Vec6::Zero());
    for (const auto& [xi, weight] : compute_gauss_rule<12>()) {
        const NodeValues<Nodes> shape = compute_shape_functions<Nodes>(xi);
        const Vec6 value = q(start + 0.5 * (1.0 + xi) * size);
        for (int i = 0; i < Nodes; ++i) nodal[i] += 0.5 * size * weight * shape[i] * value;
    }
    return nodal;
}

template <int Nodes>
void check_polynomial() {
    constexpr int order = Nodes - 1;
    INFO("order " << order);
    RandomValues random(101);
    const Vec6 a = random.matrix<6, 1>();
    const Vec6 b = random.matrix<6, 1>();
    // Nodes points integrate N_I times a polynomial of degree order + 1.
    const Distribution q = [&](double t, double s) { return Vec6(t * a + b * std::pow(s, order + 1)); };
    Model model = make_rod_model(along_x, length, {2, order}, make_section({1, 1, 1, 1, 1, 1}));
    model.distributed_loads.push_back(make_load(q, Frame::spatial));
    const double size = 0.5 * length;
    std::vector<Vec6> expected(model.nodes.size(), Vec6::Zero());
    for (int e = 0; e < 2; ++e) {
        const auto share = integrate<Nodes>([&](double s) { return q(0.6, s); }, e * size, size);
        for (int i = 0; i < Nodes; ++i) expected[e * order + i] += share[i];
    }
    const auto nodal = compute_loads(model, System(model).initial_state(), 0.6);
    for (std::size_t i = 0; i < nodal.size(); ++i) {
        CHECK((nodal[i] - expected[i]).norm() < 1e-14);
    }
}

// Of radius 1.
Placement arc(double s) {
    return {Vec3(std::sin(s), 1.0 - std::cos(s), 0.0), exp_quaternion(s * Vec3::UnitZ())};
}

// Nodes of one element, turned by much and against each other.
std::vector<NodeMotion> make_motions(std::size_t count) {
    RandomValues random(102);
    const Quat common = random.rotation();
    std::vector<NodeMotion> motions(count);
    for (NodeMotion& motion : motions) {
        motion.r = random.vector();
        motion.Lambda = exp_quaternion(random.vector(0.4)) * common;
    }
    return motions;
}

LoadedElement make_element(const DistributedLoad& load, int nodes) {
    RandomValues random(103);
    LoadedElement element;
    element.load = &load;
    for (int i = 0; i < nodes; ++i) {
        element.nodes.push_back(nodes - 1 - i);
        element.triads.push_back(random.rotation());
    }
    return element;
}

LoadMoments make_moments(const LoadedElement& element) {
    RandomValues random(106);
    LoadMoments moments(moment_count(*element.load, element.nodes.size()));
    for (Vec6& moment : moments) moment = random.matrix<6, 1>();
    return moments;
}

}  // namespace

TEST_CASE("dead loads that are polynomials of arc length come to nodes exactly", "[loads]") {
    check_polynomial<2>();
    check_polynomial<3>();
    check_polynomial<4>();
    check_polynomial<5>();
}

TEST_CASE("loads along a deformed rod add up to their force and moment", "[loads]") {
    // A constant dead force f and moment m per length: L f, and about the origin L (r̄ × f + m), r̄ the mean of
    // the interpolated line.
    for (int order = 1; order <= 4; ++order) {
        INFO("order " << order);
        const Vec3 f(0.3, -2.0, 1.0);
        const Vec3 m(1.0, 0.4, -0.7);
        const Distribution q = [&](double, double) {
            Vec6 value;
            value << f, m;
            return value;
        };
        Model model = make_rod_model(along_x, length, {2, order}, make_section({1, 1, 1, 1, 1, 1}));
        model.distributed_loads.push_back(make_load(q, Frame::spatial));
        State state = System(model).initial_state();
        RandomValues random(104);
        for (NodeMotion& motion : state.trial) motion.r += random.vector(0.3);
        // A unit density along the rod has its first moment as gravity's potential.
        Section& section = model.sections[0];
        section.mass.topLeftCorner<3, 3>().setIdentity();
        Vec3 mean;
        for (int i = 0; i < 3; ++i) {
            model.gravity = TimeVector(Vec3(-Vec3::Unit(i)));
            mean[i] = SystemMeasures(System(model)).compute_balance(state, 0.0).gravity_potential / length;
        }
        model.gravity = TimeVector(Vec3::Zero());
        Vec6 total = Vec6::Zero();
        const auto nodal = compute_loads(model, state, 0.0);
        for (std::size_t i = 0; i < nodal.size(); ++i) {
            total.head<3>() += nodal[i].head<3>();
            total.tail<3>() += state.trial[i].r.cross(Vec3(nodal[i].head<3>())) + nodal[i].tail<3>();
        }
        CHECK((total.head<3>() - length * f).norm() < 1e-13);
        CHECK((total.tail<3>() - length * (mean.cross(f) + m)).norm() < 1e-13);
    }
}

TEST_CASE("along a curved rod s is the arc length from its start", "[loads]") {
    // q = sin s e_y over a quarter circle and more, whose integral is 1 − cos L.
    const Distribution q = [](double t, double s) { return Vec6(t * std::sin(s) * Vec6::Unit(1)); };
    const auto compute_error = [&](int elements, int order) {
        Model model = make_rod_model(arc, length, {elements, order}, make_section({1, 1, 1, 1, 1, 1}));
        model.distributed_loads.push_back(make_load(q, Frame::spatial));
        double total = 0.0;
        for (const Vec6& force : compute_loads(model, System(model).initial_state(), 2.0)) total += force[1];
        return std::abs(total - 2.0 * (1.0 - std::cos(length)));
    };
    // The line through the nodes has its own length, of order 2 × order with nodes at Gauss-Lobatto points.
    for (int order = 1; order <= 4; ++order) {
        INFO("order " << order << ", errors " << compute_error(1, order) << " " << compute_error(2, order));
        CHECK(std::log2(compute_error(1, order) / compute_error(2, order)) ==
              Approx(2.0 * order).margin(0.3));
    }
    CHECK(compute_error(2, 4) < 3e-8);
}

TEST_CASE("follower and body loads turn with the section", "[loads]") {
    // A rod that is turned as one: the load too.
    const Distribution q = [](double t, double s) {
        Vec6 value;
        value << t, -2.0 * s, 1.0, 0.5, s * s, -t * s;
        return value;
    };
    const Quat turn = RandomValues(105).rotation();
    for (int order = 1; order <= 4; ++order) {
        Model dead = make_rod_model(arc, length, {3, order}, make_section({1, 1, 1, 1, 1, 1}));
        Model follower = dead;
        Model body = dead;
        dead.distributed_loads.push_back(make_load(q, Frame::spatial));
        follower.distributed_loads.push_back(make_load(q, Frame::follower));
        body.distributed_loads.push_back(make_load(q, Frame::body));
        State state = System(dead).initial_state();
        const auto at_start = compute_loads(dead, state, 0.8);
        for (NodeMotion& motion : state.trial) motion.Lambda = turn;
        const auto dead_after = compute_loads(dead, state, 0.8);
        const auto follower_after = compute_loads(follower, state, 0.8);
        for (std::size_t i = 0; i < at_start.size(); ++i) {
            CHECK((dead_after[i] - at_start[i]).norm() < 1e-14);
            CHECK((follower_after[i].head<3>() - turn * Vec3(at_start[i].head<3>())).norm() < 1e-14);
            CHECK((follower_after[i].tail<3>() - turn * Vec3(at_start[i].tail<3>())).norm() < 1e-14);
        }
    }
    // A body load of constant components stays in the section axes: along an arc, N_I times the tangent.
    const Distribution along = [](double, double) { return Vec6(Vec6::Unit(0)); };
    Model model = make_rod_model(arc, length, {4, 3}, make_section({1, 1, 1, 1, 1, 1}));
    model.distributed_loads.push_back(make_load(along, Frame::body));
    Vec3 total = Vec3::Zero();
    for (const Vec6& force : compute_loads(model, System(model).initial_state(), 0.0)) {
        total += force.head<3>();
    }
    CHECK((total - Vec3(std::sin(length), 1.0 - std::cos(length), 0.0)).norm() < 1e-5);
}

TEST_CASE("tangents of distributed loads are derivatives of their forces", "[loads]") {
    const Distribution q = [](double t, double s) {
        Vec6 value;
        value << t, -2.0 * s, 1.0, 0.5, s * s, -t * s;
        return value;
    };
    for (const auto& [name, frame] : frames) {
        const DistributedLoad load = make_load(q, frame);
        for (int nodes = 2; nodes <= 5; ++nodes) {
            INFO(name << ", " << nodes << " nodes");
            const LoadedElement element = make_element(load, nodes);
            const LoadMoments moments = make_moments(element);
            const auto motions = make_motions(element.nodes.size());
            const auto force_of = [&](const std::vector<NodeMotion>& moved) {
                std::vector<Vec6> nodal(moved.size(), Vec6::Zero());
                add_distributed_load(element, {at_time, moments}, moved, nodal);
                Eigen::VectorXd stacked(6 * nodes);
                for (int i = 0; i < nodes; ++i) stacked.segment<6>(6 * i) = nodal[element.nodes[i]];
                return stacked;
            };
            std::vector<NodeLinearization> linearizations(motions.size());
            for (NodeLinearization& linearization : linearizations) linearization.placement = 1.0;
            const LoadMatrix tangent =
                compute_distributed_load_tangent(element, {at_time, moments}, motions, linearizations);
            for (int unknown = 0; unknown < 6 * nodes; ++unknown) {
                const Eigen::VectorXd expected = differentiate([&](double amount) {
                    std::vector<NodeMotion> moved = motions;
                    const Vec6 step = amount * Vec6::Unit(unknown % 6);
                    apply_spin({}, step.head<3>(), Vec3::Zero(), moved[element.nodes[unknown / 6]]);
                    Quat& Lambda = moved[element.nodes[unknown / 6]].Lambda;
                    Lambda = exp_quaternion(step.tail<3>()) * motions[element.nodes[unknown / 6]].Lambda;
                    return Eigen::VectorXd(force_of(moved));
                });
                CHECK((tangent.col(unknown) - expected).norm() < 1e-10);
            }
            // Rates and accelerations push nothing.
            for (NodeLinearization& linearization : linearizations) linearization = {0.0, 1.0, 1.0};
            CHECK(compute_distributed_load_tangent(element, {at_time, moments}, motions, linearizations)
                      .isZero(0.0));
        }
    }
}

TEST_CASE("a load that turns is turned by each node and interpolated", "[loads]") {
    // Nodes turned differently: ∫ N_I Σ_J N_J Λ_J q ds, constant q, with ∫ N_I N_J ds = size/6 (1 + δ_IJ).
    RandomValues random(171);
    const Vec3 q = random.vector();
    Model model = make_rod_model(along_x, length, {1, 1}, make_section({1, 1, 1, 1, 1, 1}));
    model.distributed_loads.push_back(make_load(
        [q](double, double) {
            Vec6 value = Vec6::Zero();
            value.head<3>() = q;
            return value;
        },
        Frame::body));
    State state = System(model).initial_state();
    std::array<Vec3, 2> turned;
    for (int i = 0; i < 2; ++i) {
        state.trial[i].Lambda = random.rotation();
        turned[i] = state.trial[i].Lambda * q;
    }
    const auto nodal = compute_loads(model, state, 0.0);
    for (int i = 0; i < 2; ++i) {
        const Vec3 expected = length / 6.0 * (2.0 * turned[i] + turned[1 - i]);
        CHECK((nodal[i].head<3>() - expected).norm() < 1e-14);
        CHECK(nodal[i].tail<3>().norm() < 1e-15);
    }
}

TEST_CASE("A load per length is that of its time and place, in its own axes", "[loads]") {
    const auto q = [](double t, double s) {
        Vec6 value;
        value << t, s, t * s, 1.0, t + s, t - s;
        return value;
    };
    for (const auto& [name, frame] : frames) {
        INFO(name);
        CHECK(compute_load_per_length(make_load(q, frame), 0.3, 0.7) == q(0.3, 0.7));
    }
}
