// Whirl of rotors on bearings against closed forms.
#include <algorithm>
#include <cmath>
#include <complex>

#include "analyses/shapes/eigenvalues.hpp"
#include "analyses/shapes/gravity_excitation.hpp"
#include "analyses/shapes/response.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/steady_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

using Complex = std::complex<double>;

constexpr double EI = 1.0, GA = 400.0, length = 1.0;
constexpr double mass = 2.0, polar = 0.3, diametral = 0.2;

struct Bearings {
    std::array<double, 2> stiffness{0.0, 0.0};  // along y and z; 0: rigid
    std::array<double, 2> damping{0.0, 0.0};
};

// A disc in the middle of a shaft without mass, on two bearings, driven through a coupling at its start. Its
// material is damped: resultants have `inner` × their rate.
Model make_rotor(const Bearings& bearings, double inner) {
    Section section = make_section({1e4, GA, GA, 5.0, EI, EI});
    section.kelvin_voigt = inner;
    Model model = make_rod_model(along_x, length, {4, 3}, section);
    const int end = last_node(model), middle = end / 2;
    REQUIRE(model.nodes[static_cast<std::size_t>(middle)].position.x() == Approx(0.5 * length));
    model.bodies.push_back({.name = "disc",
                            .node = middle,
                            .mass = mass,
                            .inertia = Vec3(polar, diametral, diametral).asDiagonal()});
    model.nodes.push_back({"motor", Vec3::Zero()});
    const int motor = last_node(model);
    clamp(model, motor);
    Bushing coupling{.name = "coupling", .ends = {Anchor{motor}, Anchor{0}}};
    coupling.stiffness(0, 0) = 1e3;
    coupling.stiffness(3, 3) = 10.0;
    model.bushings.push_back(coupling);
    for (const int node : {0, end}) {
        const Vec3 place = model.nodes[static_cast<std::size_t>(node)].position;
        if (bearings.stiffness[0] == 0.0) {
            Joint& ball = model.joints.emplace_back();
            ball.name = "bearing";
            ball.a.anchor = {-1, place};
            ball.b.anchor.node = node;
            continue;
        }
        Bushing bushing{.name = "bearing", .ends = {Anchor{-1, place}, Anchor{node}}};
        bushing.carrier = BushingAxes::ground;
        for (const int i : {0, 1}) {
            bushing.stiffness(1 + i, 1 + i) = bearings.stiffness[static_cast<std::size_t>(i)];
            bushing.damping(1 + i, 1 + i) = bearings.damping[static_cast<std::size_t>(i)];
        }
        model.bushings.push_back(bushing);
    }
    return model;
}

TurningFrame make_frame(const Model& model, double speed, bool is_at_rest) {
    TurningFrame frame = ramped_frame(Vec3::UnitX(), speed);
    if (is_at_rest) frame.spinning.assign(model.nodes.size(), true);
    return frame;
}

std::vector<Complex> find_whirl(const Model& model, const TurningFrame& frame, int count) {
    const SteadyRun run(model, frame, make_static_settings(1));
    const SteadyAnalysis& analysis = run.analysis();
    std::vector<Complex> lambdas;
    for (const Eigenmode& mode :
         find_eigenvalues(
             analysis.system(), analysis.state(), 1.0, {.count = count}, &analysis.frame_columns())
             .modes)
        lambdas.push_back(mode.lambda());
    return lambdas;
}

// The eigenvalue λ of y + iz ~ exp(λt), as it is seen at rest; in a frame that turns it is λ − iΩ.
void check_whirl(const std::vector<Complex>& found,
                 Complex expected,
                 const TurningFrame& frame,
                 double tolerance) {
    if (!frame.is_at_rest()) expected -= Complex(0.0, frame.speed(1.0));
    const Complex shown(expected.real(), std::abs(expected.imag()));
    double nearest = 1e300;
    for (const Complex& one : found) nearest = std::min(nearest, std::abs(one - shown));
    INFO("expected " << shown.real() << " + " << shown.imag() << "i");
    CHECK(nearest < tolerance * std::abs(shown));
}

// Of a λ² + b λ + c = 0.
std::array<Complex, 2> solve(Complex a, Complex b, Complex c) {
    const Complex root = std::sqrt(b * b - 4.0 * a * c);
    return {(-b + root) / (2.0 * a), (-b - root) / (2.0 * a)};
}

}  // namespace

TEST_CASE("R1: whirl of a Jeffcott rotor with gyroscopic moment and a damped shaft", "[analyses]") {
    constexpr double inner = 0.01;
    const double bending = 1.0 / (std::pow(length, 3) / (48.0 * EI) + length / (4.0 * GA));
    const double tilt = 1.0 / (length / (12.0 * EI) + 1.0 / (GA * length));
    const Model model = make_rotor({}, inner);
    for (const double speed : {0.0, 3.0, 12.0}) {
        for (const bool is_at_rest : {false, true}) {
            INFO("speed " << speed << (is_at_rest ? ", at rest" : ", turning"));
            const TurningFrame frame = make_frame(model, speed, is_at_rest);
            const std::vector<Complex> found = find_whirl(model, frame, 10);
            const Complex i(0.0, 1.0);
            for (const Complex& whirl : solve(mass, inner * bending, bending * (1.0 - i * speed * inner)))
                check_whirl(found, whirl, frame, 1e-7);
            for (const Complex& whirl :
                 solve(diametral, inner * tilt - i * speed * polar, tilt * (1.0 - i * speed * inner)))
                check_whirl(found, whirl, frame, 1e-7);
        }
    }
}

TEST_CASE("R2: a rotor loses stability where Ω = ω₀ (1 + c_e/c_i)", "[analyses]") {
    // A disc on a shaft that is a spring with a damper in axes that turn with it, and a damper at rest.
    constexpr double stiffness = 8.0, inner = 0.2, outer = 0.3;
    Model model;
    model.nodes.push_back({"disc", Vec3::Zero()});
    model.bodies.push_back(
        {.name = "disc", .mass = mass, .inertia = Vec3(polar, diametral, diametral).asDiagonal()});
    Support support;
    support.fixed = {true, false, false, true, true, true};
    model.supports.push_back(support);
    Bushing shaft{.name = "shaft", .ends = {Anchor{}, Anchor{0}}, .carrier = BushingAxes::b};
    shaft.stiffness(1, 1) = shaft.stiffness(2, 2) = stiffness;
    shaft.damping(1, 1) = shaft.damping(2, 2) = inner;
    Bushing air{.name = "air", .ends = {Anchor{}, Anchor{0}}, .carrier = BushingAxes::ground};
    air.damping(1, 1) = air.damping(2, 2) = outer;
    model.bushings = {shaft, air};
    const double critical = std::sqrt(stiffness / mass) * (1.0 + outer / inner);
    for (const bool is_at_rest : {false, true}) {
        const auto growth = [&](double speed) {
            const TurningFrame frame = make_frame(model, speed, is_at_rest);
            const std::vector<Complex> found = find_whirl(model, frame, 4);
            const Complex i(0.0, 1.0);
            for (const Complex& whirl : solve(mass, inner + outer, stiffness - i * speed * inner))
                check_whirl(found, whirl, frame, 1e-10);
            double largest = -1e300;
            for (const Complex& one : found) largest = std::max(largest, one.real());
            return largest;
        };
        CHECK(growth(0.999 * critical) < 0.0);
        CHECK(growth(1.001 * critical) > 0.0);
        CHECK(std::abs(growth(critical)) < 1e-9);
    }
}

TEST_CASE("R3: a rotor on anisotropic, damped bearings", "[analyses]") {
    const Bearings bearings{.stiffness = {30.0, 50.0}, .damping = {0.4, 0.9}};
    const double bending = 1.0 / (std::pow(length, 3) / (48.0 * EI) + length / (4.0 * GA));
    const Model model = make_rotor(bearings, 0.0);
    for (const double speed : {0.0, 5.0}) {
        const TurningFrame frame = make_frame(model, speed, true);
        const std::vector<Complex> found = find_whirl(model, frame, 12);
        for (const std::size_t i : {0, 1}) {
            // The shaft and both bearings in series: m λ² + k_s (2 c λ + 2 k)/(k_s + 2 c λ + 2 k) = 0, of
            // which the pair is found by Newton's method from the undamped one.
            const double k = 2.0 * bearings.stiffness[i], c = 2.0 * bearings.damping[i];
            Complex whirl(0.0, std::sqrt(bending * k / (bending + k) / mass));
            for (int step = 0; step < 50; ++step) {
                const Complex soft = k + c * whirl, sum = bending + soft;
                const Complex value = mass * whirl * whirl + bending * soft / sum;
                const Complex slope = 2.0 * mass * whirl + bending * bending * c / (sum * sum);
                whirl -= value / slope;
            }
            check_whirl(found, whirl, frame, 1e-7);
        }
        // The tilts are coupled by the disc's spin.
        const auto tilt = [&](std::size_t i, Complex lambda) {
            const Complex soft =
                (bearings.stiffness[i] + bearings.damping[i] * lambda) * 0.5 * length * length;
            const double stiff = 1.0 / (length / (12.0 * EI) + 1.0 / (GA * length));
            return stiff * soft / (stiff + soft);
        };
        int tilts = 0;
        for (const Complex& lambda : found) {
            const Complex product = (diametral * lambda * lambda + tilt(0, lambda)) *
                                    (diametral * lambda * lambda + tilt(1, lambda));
            const Complex coupling = speed * speed * polar * polar * lambda * lambda;
            if (lambda.imag() > 0.0 && std::abs(product + coupling) < 1e-5 * std::abs(product)) ++tilts;
        }
        if (speed > 0.0) CHECK(tilts == 2);
    }
    CHECK_THROWS_WITH(SteadyRun(model, make_frame(model, 5.0, false), make_static_settings(1)),
                      Catch::Contains("bushing.bearing is not equally stiff"));
}

TEST_CASE("R4: a shaft that spins sags under gravity across as one that does not", "[analyses]") {
    Model model = make_rotor({}, 0.0);
    constexpr double gravity = 0.005;  // so that the rigid bearings hardly pull
    model.gravity = TimeVector(Vec3(0.0, 0.0, -gravity));
    const SteadyRun run(model, make_frame(model, 20.0, true), make_static_settings(2));
    const double stiffness = 1.0 / (std::pow(length, 3) / (48.0 * EI) + length / (4.0 * GA));
    const std::size_t middle = model.bodies[0].node;
    const NodeMotion& disc = run.analysis().state().trial[middle];
    CHECK(disc.r.z() == Approx(-gravity * mass / stiffness).epsilon(1e-3));
    CHECK(std::abs(disc.r.y()) < 1e-9);
    CHECK(disc.omega.isApprox(Vec3(20.0, 0.0, 0.0)));
}

TEST_CASE("R5: gravity across a rotor in a turning frame, once a revolution", "[analyses]") {
    // As seen at rest the disc sags by a constant: in the frame it goes round.
    const Model model = make_rotor({}, 0.0);
    const double stiffness = 1.0 / (std::pow(length, 3) / (48.0 * EI) + length / (4.0 * GA));
    const Vec3 gravity(3.0, 0.0, -0.5);  // what is along the axis does not count
    for (const double speed : {0.1, 6.0, -6.0}) {
        INFO("speed " << speed);
        const TurningFrame frame = make_frame(model, speed, false);
        const SteadyRun run(model, frame, make_static_settings(1));
        const SteadyAnalysis& analysis = run.analysis();
        const RevolvingLoad load =
            compute_gravity_excitation(analysis.system(), analysis.state(), 1.0, frame, gravity);
        CHECK(load.omega == std::abs(speed));
        const Response response = find_response(analysis.system(),
                                                analysis.state(),
                                                1.0,
                                                {load.omega},
                                                load.forces,
                                                &analysis.frame_columns())
                                      .responses.at(0);
        const auto disc = static_cast<std::size_t>(model.bodies[0].node);
        const Vec3 real = response.motion.real[disc].head<3>(),
                   imaginary = response.motion.imaginary[disc].head<3>();
        const double sag = 0.5 * mass / stiffness;
        CHECK((real - Vec3(0.0, 0.0, -sag)).norm() < 1e-7 * sag);
        CHECK((imaginary - std::copysign(1.0, speed) * Vec3(0.0, sag, 0.0)).norm() < 1e-7 * sag);
    }
}
