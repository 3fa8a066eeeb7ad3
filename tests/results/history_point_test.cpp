#include "results/history_point.hpp"

#include <catch2/catch.hpp>

#include "results/sample.hpp"
#include "rotation/rotation_map.hpp"

using namespace gxrod;
using sample::Motion;

namespace {

constexpr std::size_t middle = 0, root = 1, tip = 2, gyro = 3;  // in sample::make_output()

HistoryPoint make_point(const Model& model, std::size_t request) {
    return {model, sample::make_output().histories[request]};
}

Vec3 vector_of(HistoryPoint point, Quantity quantity, const Motion& motion) {
    const HistoryPoint::Row row = point.compute(quantity, motion.snapshot());
    return {row[0], row[1], row[2]};
}

// The rotation matrix of a recorded quaternion, w x y z.
Mat3 matrix_of(HistoryPoint point, Quantity quantity, const Motion& motion) {
    const HistoryPoint::Row row = point.compute(quantity, motion.snapshot());
    return Quat(row[0], row[1], row[2], row[3]).toRotationMatrix();
}

}  // namespace

TEST_CASE("Position, displacement and rates of a point are those of its node", "[results]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    const HistoryPoint point = make_point(model, gyro);
    const NodeMotion& node = motion.nodes[3];
    CHECK(vector_of(point, Quantity::position, motion) == node.r);
    CHECK((vector_of(point, Quantity::displacement, motion) - 0.7 * Vec3(4, 8, 12)).norm() < 1e-14);
    CHECK(vector_of(point, Quantity::velocity, motion) == node.v);
    CHECK(vector_of(point, Quantity::acceleration, motion) == node.a);
    CHECK(vector_of(point, Quantity::angular_velocity, motion) == node.omega);
}

TEST_CASE("The rotation of a rod's point is that since the reference configuration", "[results]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    const HistoryPoint point = make_point(model, middle);
    const Vec3 phi = 0.7 * Vec3(0.3, 0.4, -0.4);
    const Mat3 section = exp_matrix(phi) * exp_matrix({0.2, 0.2, 0.3});
    CHECK((vector_of(point, Quantity::rotation_vector, motion) - phi).norm() < 1e-15);
    CHECK((matrix_of(point, Quantity::quaternion, motion) - exp_matrix(phi)).norm() < 1e-14);
    CHECK((matrix_of(point, Quantity::orientation, motion) - section).norm() < 1e-14);
    CHECK((vector_of(point, Quantity::angular_velocity_material, motion) -
           section.transpose() * motion.nodes[1].omega)
              .norm() < 1e-14);
}

TEST_CASE("The rotation of a body is its attitude, on a rod's node too", "[results]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    const HistoryPoint point = make_point(model, tip);
    const Mat3 attitude = exp_matrix(0.7 * Vec3(0.3, 0.6, -0.4)) * exp_matrix({0.0, 0.0, 1.5});
    CHECK((exp_matrix(vector_of(point, Quantity::rotation_vector, motion)) - attitude).norm() < 1e-14);
    CHECK((matrix_of(point, Quantity::quaternion, motion) - attitude).norm() < 1e-14);
    CHECK((matrix_of(point, Quantity::orientation, motion) - attitude).norm() < 1e-14);
    CHECK((vector_of(point, Quantity::angular_velocity_material, motion) -
           attitude.transpose() * motion.nodes[2].omega)
              .norm() < 1e-14);
}

TEST_CASE("The centre of mass turns with its body", "[results]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    const Mat3 attitude = exp_matrix(0.7 * Vec3(0.3, 0.8, -0.4)) * exp_matrix({0.0, 1.0, 0.0});
    const Vec3 expected = motion.nodes[3].r + attitude * Vec3(0.0, 0.1, 0.4);
    CHECK((vector_of(make_point(model, gyro), Quantity::centre_of_mass, motion) - expected).norm() < 1e-14);
}

TEST_CASE("Section values are those of the end element, or the mean of two neighbours", "[results]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    const SectionValues& first = motion.elements[0];
    const SectionValues& second = motion.elements[1];

    const HistoryPoint start = make_point(model, root);
    CHECK(vector_of(start, Quantity::force, motion) == first.force);
    CHECK(vector_of(start, Quantity::moment, motion) == first.moment);
    CHECK(vector_of(start, Quantity::strain, motion) == first.strain);
    CHECK(vector_of(start, Quantity::curvature, motion) == first.curvature);
    CHECK(vector_of(start, Quantity::force_spatial, motion) == first.axes * first.force);
    CHECK(vector_of(start, Quantity::moment_spatial, motion) == first.axes * first.moment);

    const HistoryPoint inside = make_point(model, middle);
    CHECK(vector_of(inside, Quantity::force, motion) == 0.5 * (first.force + second.force));
    CHECK(vector_of(inside, Quantity::curvature, motion) == 0.5 * (first.curvature + second.curvature));
    const Vec3 spatial = 0.5 * (first.axes * first.moment + second.axes * second.moment);
    CHECK((vector_of(inside, Quantity::moment_spatial, motion) - spatial).norm() < 1e-13);

    HistoryRequest end = sample::make_output().histories[middle];
    end.node = 2;
    end.position_in_rod = 2;
    CHECK(vector_of(HistoryPoint(model, end), Quantity::strain, motion) == second.strain);
}

TEST_CASE("Section values of a later rod, and inside an element of higher order, are its own", "[results]") {
    Model model = sample::make_model();
    Rod curve = model.rods[0];
    curve.name = "curve";
    curve.order = 2;
    model.rods.push_back(curve);
    Motion motion(0.7);
    motion.elements.push_back({Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9), Vec3(1, 1, 1), Quat::Identity()});
    HistoryRequest request = sample::make_output().histories[middle];
    request.rod = 1;
    for (const int position : {0, 1, 2}) {
        request.node = position;
        request.position_in_rod = position;
        CHECK(vector_of(HistoryPoint(model, request), Quantity::moment, motion) == Vec3(4, 5, 6));
    }
}

TEST_CASE("Reactions are those of the point's node", "[results]") {
    const Model model = sample::make_model();
    const Motion motion(0.7);
    CHECK(vector_of(make_point(model, root), Quantity::reaction_force, motion) == Vec3(1.7, 2, 3));
    CHECK(vector_of(make_point(model, root), Quantity::reaction_moment, motion) == Vec3(4, 5, 6));
    CHECK(vector_of(make_point(model, middle), Quantity::reaction_force, motion) == Vec3::Zero());
}

TEST_CASE("Quaternions do not change sign from step to step, rotation vectors stay within pi", "[results]") {
    const Model model = sample::make_model();
    HistoryPoint point = make_point(model, middle);
    Motion motion(0.0);
    HistoryPoint::Row last{1.0, 0.0, 0.0, 0.0};
    for (int step = 1; step <= 300; ++step) {
        const Quat turned = exp_quaternion({0.0, 0.0, 0.1 * step});
        motion.nodes[1].Lambda = step % 3 == 0 ? Quat(-turned.coeffs()) : turned;
        const HistoryPoint::Row row = point.compute(Quantity::quaternion, motion.snapshot());
        double distance = 0.0;
        for (std::size_t i = 0; i < 4; ++i) distance += std::pow(row[i] - last[i], 2);
        CHECK(std::sqrt(distance) < 0.06);
        CHECK(vector_of(point, Quantity::rotation_vector, motion).norm() <= M_PI);
        last = row;
    }
}
