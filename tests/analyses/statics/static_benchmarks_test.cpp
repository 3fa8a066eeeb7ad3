// Static rods against exact solutions: rates of order 2p in the mesh, and the digits.
#include <numbers>

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

using std::numbers::pi;
constexpr ElementKind kinds[] = {ElementKind::objective, ElementKind::simo};

// S1: a cantilever of length 10 that an end couple bends by so many turns.
Model make_roll_up(double turns, const Mesh& mesh) {
    Model model = make_rod_model(along_x, 10.0, mesh, make_section({1e4, 1e4, 1e4, 100.0, 100.0, 100.0}));
    clamp(model, 0);
    add_ramp(model, last_node(model), Vec3::Zero(), Vec3(0.0, 0.0, turns * 2.0 * pi * 100.0 / 10.0));
    return model;
}

// S2: a cantilever of length 1 with EI = 1 under a dead transverse force at its end.
constexpr double shear_stiffness = 200.0;
Model make_elastica(double force, const Mesh& mesh) {
    constexpr double S = shear_stiffness;
    Model model = make_rod_model(along_x, 1.0, mesh, make_section({S, S, S, 1.0, 1.0, 1.0}));
    clamp(model, 0);
    add_ramp(model, last_node(model), Vec3(0.0, force, 0.0), Vec3::Zero());
    return model;
}

struct Elastica {
    double force, rotation, w, u;
};
// Inextensible and unshearable; with EA = GA = S rotation and u stay and w grows by P L/S.
const std::vector<Elastica> references{{1.0, 0.4613519497, 0.3017207738, 0.0564332363},
                                       {2.0, 0.7817498316, 0.4934574804, 0.1606417208},
                                       {5.0, 1.2153681176, 0.7137915236, 0.3876283607},
                                       {10.0, 1.4302855388, 0.8106090249, 0.5549955978}};

double measure_elastica(const Elastica& reference, const Mesh& mesh) {
    const Model model = make_elastica(reference.force, mesh);
    const StaticRun run = run_static(model, make_static_settings(4));
    const Vec3 expected(
        1.0 - reference.u, reference.w + reference.force / shear_stiffness, reference.rotation);
    const Vec3 found(run.tip().r.x(), run.tip().r.y(), log(run.tip().Lambda).z());
    return (found - expected).norm();
}

std::vector<double> compute_rates(const std::vector<double>& errors) {
    std::vector<double> rates;
    for (std::size_t i = 1; i < errors.size(); ++i) rates.push_back(std::log2(errors[i - 1] / errors[i]));
    return rates;
}

}  // namespace

TEST_CASE("S1: a cantilever rolls up into a circle to round-off", "[analyses][static]") {
    for (const ElementKind kind : kinds) {
        for (int order = 1; order <= 4; ++order) {
            INFO((kind == ElementKind::simo ? "simo" : "objective") << ", order " << order);
            const Model model = make_roll_up(1.0, {12 / order, order, kind});
            const StaticRun run = run_static(model, make_static_settings(10));
            CHECK(run.tip().r.norm() < 1e-10);
            CHECK(run.tip().Lambda.angularDistance(Quat::Identity()) < 1e-10);
            CHECK(run.rejected_steps == 0);
            for (const SectionValues& values : run.elements) {
                CHECK((values.moment - Vec3(0.0, 0.0, 20.0 * pi)).norm() < 1e-8);
                CHECK(values.force.norm() < 1e-8);
            }
        }
    }
}

TEST_CASE("S1: half-way the circle is met at the order 2p", "[analyses][static]") {
    const Vec3 half(0.0, 2.0 * 10.0 / pi, 0.0);
    for (const auto& [order, elements] : {std::pair(1, 8), {2, 4}, {3, 2}, {4, 2}}) {
        std::vector<double> errors;
        for (const int factor : {1, 2, 4}) {
            const Model model = make_roll_up(0.5, {factor * elements, order});
            errors.push_back((run_static(model, make_static_settings(4)).tip().r - half).norm());
        }
        INFO("order " << order << ": " << errors[0] << " " << errors[1] << " " << errors[2]);
        CHECK(compute_rates(errors).back() == Approx(2.0 * order).margin(0.15));
    }
}

TEST_CASE("S1: a circle opens to a semicircle", "[analyses][static]") {
    const Line circle = [](double s) {
        const double angle = 2.0 * pi * s / 10.0;
        return Placement{10.0 / (2.0 * pi) * Vec3(std::sin(angle), 1.0 - std::cos(angle), 0.0),
                         exp_quaternion(angle * Vec3::UnitZ())};
    };
    for (const ElementKind kind : kinds) {
        std::vector<double> errors;
        for (const int elements : {4, 8, 16}) {
            Model model = make_rod_model(
                circle, 10.0, {elements, 3, kind}, make_section({1e4, 1e4, 1e4, 100.0, 100.0, 100.0}));
            clamp(model, 0);
            add_ramp(model, last_node(model), Vec3::Zero(), Vec3(0.0, 0.0, -10.0 * pi));
            const StaticRun run = run_static(model, make_static_settings(4));
            const double rotation_error = log(run.tip().Lambda).z() + pi;
            errors.push_back(std::hypot((run.tip().r - Vec3(0.0, 20.0 / pi, 0.0)).norm(), rotation_error));
        }
        INFO("errors " << errors[0] << " " << errors[1] << " " << errors[2]);
        CHECK(compute_rates(errors).back() == Approx(6.0).margin(0.3));
    }
}

TEST_CASE("S2: the elastica is met at the order 2p", "[analyses][static]") {
    for (const ElementKind kind : kinds) {
        for (const auto& [order, elements] : {std::pair(1, 16), {2, 8}, {3, 4}, {4, 1}}) {
            std::vector<double> errors;
            for (const int factor : {1, 2, 4}) {
                errors.push_back(measure_elastica(references[2], {factor * elements, order, kind}));
            }
            INFO("order " << order << ": " << errors[0] << " " << errors[1] << " " << errors[2]);
            CHECK(compute_rates(errors).back() == Approx(2.0 * order).margin(0.3));
        }
    }
}

TEST_CASE("S2: elements of order 4 reach every digit of the elastica", "[analyses][static]") {
    for (const Elastica& reference : references) {
        INFO("P L^2/EI = " << reference.force);
        CHECK(measure_elastica(reference, {16, 4}) < 1.5e-10);
    }
}
