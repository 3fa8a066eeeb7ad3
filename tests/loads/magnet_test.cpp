#include "loads/magnet.hpp"

#include <algorithm>
#include <cmath>

#include "loads/distributed_load.hpp"
#include "loads/load_values.hpp"
#include "numerics/lagrange.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// The field of a magnetic point dipole, far from its source: free of divergence and of rotation.
Vec3 dipole(const Vec3& position) {
    const Vec3 source(-4.0, 1.0, 2.0);
    const Vec3 p(2.0, 30.0, -5.0);
    const Vec3 r = position - source;
    const double d = r.norm();
    return 3.0 * p.dot(r) * r / std::pow(d, 5) - p / std::pow(d, 3);
}

MagneticField field_by_place() {
    return {.uniform = {TimeFunction([](double t) { return 0.1 * t; }), 0.3, -0.2},
            .by_place = [](double t, const Vec3& position) { return Vec3((1.0 + t) * dipole(position)); }};
}

MagneticField uniform_field(const Vec3& value) { return {.uniform = {value[0], value[1], value[2]}}; }

// What it is after a displacement and a spin.
Magnet moved(const Magnet& magnet, const Vec6& by) {
    Magnet result = magnet;
    result.position += by.head<3>();
    result.moment = exp_quaternion(by.tail<3>()) * magnet.moment;
    return result;
}

double potential(const Magnet& magnet) {
    return -magnet.moment.dot(magnet.field.at(magnet.time, magnet.position));
}

template <int Nodes>
ShapeValues shapes_of(double xi) {
    const NodeValues<Nodes> shape = compute_shape_functions<Nodes>(xi);
    const NodeValues<Nodes> slope = compute_shape_slopes<Nodes>(xi);
    ShapeValues values{};
    std::copy_n(shape.begin(), Nodes, values.value.begin());
    std::copy_n(slope.begin(), Nodes, values.slope.begin());
    return values;
}

// A rod of three elements along x whose magnetic moment is (1 + s, 0.5, −0.25) t in its own axes.
Model make_needle(const MagneticField& field, int order) {
    Model model = make_rod_model(along_x, 2.0, {3, order}, make_section({1, 1, 1, 1, 1, 1}));
    DistributedLoad load{.key = "magnetic[0]", .rod = 0, .force = {}, .moment = {}, .frame = Frame::body};
    const auto by_time = [](double slope, double constant) {
        return LineFunction([=](double t, double s) { return t * (constant + slope * s); });
    };
    load.moment = {by_time(1.0, 1.0), by_time(0.0, 0.5), by_time(0.0, -0.25)};
    load.field = field;
    model.distributed_loads = {load};
    return model;
}

LoadValues find_values(const Model& model) {
    constexpr std::array<ShapeFunctions, 4> shapes{shapes_of<2>, shapes_of<3>, shapes_of<4>, shapes_of<5>};
    const Rod& rod = model.rods[0];
    const auto nodes = static_cast<std::size_t>(rod.order) + 1;
    std::vector<LoadedElement> elements;
    for (std::size_t first = 0; first < rod.element_nodes.size(); first += nodes) {
        LoadedElement element;
        element.load = &model.distributed_loads[0];
        element.shapes = shapes[nodes - 2];
        for (std::size_t i = first; i < first + nodes; ++i) {
            element.nodes.push_back(rod.element_nodes[i]);
            element.triads.push_back(rod.triads[i]);
            element.arc_lengths.push_back(rod.arc_length[i]);
            element.positions.push_back(model.nodes[element.nodes.back()].position);
        }
        elements.push_back(std::move(element));
    }
    return LoadValues(model, std::move(elements));
}

std::vector<NodeMotion> make_motions(const Model& model, double displacement, double turn) {
    RandomValues random(151);
    std::vector<NodeMotion> motions(model.nodes.size());
    for (std::size_t i = 0; i < motions.size(); ++i) {
        motions[i].r = model.nodes[i].position + random.vector(displacement);
        motions[i].Lambda = exp_quaternion(random.vector(turn));
    }
    return motions;
}

}  // namespace

TEST_CASE("a magnet's force and couple are derivatives of its potential", "[loads]") {
    RandomValues random(149);
    for (const MagneticField& field : {field_by_place(), uniform_field(Vec3(0.2, -1.0, 0.4))}) {
        const Magnet magnet{field, 0.7, random.vector(), random.vector(), 0.5};
        Vec6 expected;
        for (int i = 0; i < 6; ++i) {
            expected[i] =
                -differentiate([&](double x) { return potential(moved(magnet, x * Vec6::Unit(i))); });
        }
        CHECK(relative_difference(compute_magnetic_load(magnet), expected) < 1e-10);
    }
}

TEST_CASE("a magnet's tangent is the derivative of its force and couple", "[loads]") {
    RandomValues random(150);
    for (const MagneticField& field : {field_by_place(), uniform_field(Vec3(0.2, -1.0, 0.4))}) {
        const Magnet magnet{field, 0.7, random.vector(), random.vector(), 0.5};
        Mat6 expected;
        for (int i = 0; i < 6; ++i) {
            expected.col(i) = differentiate(
                [&](double x) { return Vec6(compute_magnetic_load(moved(magnet, x * Vec6::Unit(i)))); });
        }
        const Mat6 tangent = compute_magnetic_tangent(magnet);
        // The second derivatives of the field are differences of second order.
        CHECK(relative_difference(tangent, expected) < 1e-6);
        CHECK(relative_difference(tangent.rightCols<3>(), expected.rightCols<3>()) < 1e-9);
        // But for half of the couple's own spin it is symmetric, as of a potential on rotations.
        Mat6 skew = tangent - tangent.transpose();
        skew.bottomRightCorner<3, 3>() += spin(compute_magnetic_load(magnet).tail<3>());
        CHECK(skew.norm() < 1e-9 * tangent.norm());
    }
}

TEST_CASE("without gradient there is no force", "[loads]") {
    const MagneticField field = uniform_field(Vec3(0.0, 2.0, 0.0));
    const Vec6 load = compute_magnetic_load({field, 0.0, Vec3(1.0, 2.0, 3.0), Vec3(3.0, 0.0, 0.0), 1.0});
    CHECK(load.head<3>() == Vec3::Zero());
    CHECK(load.tail<3>() == Vec3(0.0, 0.0, 6.0));
}

TEST_CASE("a magnetic rod's couples add up to that of its whole moment", "[loads]") {
    const Vec3 B(0.3, -0.7, 1.1);
    for (int order = 1; order <= 4; ++order) {
        const Model model = make_needle(uniform_field(B), order);
        LoadValues values = find_values(model);
        for (const double t : {1.0, 3.0}) {
            values.move_to(t);
            Vec6 sum = Vec6::Zero();
            for (const Vec6& force : values.add_distributed(make_motions(model, 0.2, 0.0))) sum += force;
            Vec6 expected;
            expected << Vec3::Zero(), t * Vec3(4.0, 1.0, -0.5).cross(B);
            CHECK(relative_difference(sum, expected) < 1e-13);
        }
    }
}

TEST_CASE("a magnetic rod's forces have a potential, and a tangent", "[loads]") {
    const double t = 0.6;
    for (const int order : {1, 3}) {
        INFO("order " << order);
        const Model model = make_needle(field_by_place(), order);
        LoadValues values = find_values(model);
        values.move_to(t);
        const LoadedElement& element = values.elements()[1];
        const LoadAtTime load{t, values.moments(1)};
        const std::vector<NodeMotion> motions = make_motions(model, 0.2, 0.5);
        const auto move = [&](int unknown, double amount) {
            std::vector<NodeMotion> result = motions;
            const Vec6 by = amount * Vec6::Unit(unknown % 6);
            NodeMotion& motion = result[element.nodes[unknown / 6]];
            motion.r += by.head<3>();
            motion.Lambda = exp_quaternion(by.tail<3>()) * motion.Lambda;
            return result;
        };
        // Each node is a magnet of the moment ∫ N_I μ ds.
        const auto energy = [&](const std::vector<NodeMotion>& moved) {
            double sum = 0.0;
            for (std::size_t i = 0; i < element.nodes.size(); ++i) {
                const NodeMotion& motion = moved[element.nodes[i]];
                const Vec3 moment = motion.Lambda * (element.triads[i] * load.moments[i].tail<3>());
                sum -= moment.dot(element.load->field->at(t, motion.r));
            }
            return sum;
        };
        const LoadVector force = compute_distributed_load(element, load, motions);
        std::vector<NodeLinearization> linearizations(motions.size(), {.placement = 1.0});
        const LoadMatrix tangent = compute_distributed_load_tangent(element, load, motions, linearizations);
        for (int i = 0; i < force.size(); ++i) {
            CHECK(force[i] ==
                  Approx(-differentiate([&](double x) { return energy(move(i, x)); })).margin(1e-10));
            const Eigen::VectorXd expected = differentiate([&](double x) {
                return Eigen::VectorXd(compute_distributed_load(element, load, move(i, x)));
            });
            CHECK((tangent.col(i) - expected).norm() < 1e-6 * tangent.norm());
        }
        // Rates and accelerations push nothing.
        for (NodeLinearization& one : linearizations) one = {0.0, 1.0, 1.0};
        CHECK(compute_distributed_load_tangent(element, load, motions, linearizations).isZero(0.0));
    }
}
