// A ball slides through tubes that bend, against a particle on the surface that its centre keeps to.
#include <functional>

#include "analyses/contact/contact_run.hpp"

namespace gxrod::test {
namespace {

constexpr double gravity = 9.81;

// A curve by an angle, with its derivative.
struct AngleCurve {
    std::function<Vec3(double)> at, slope;
};

// A particle at a distance from a curve: without friction, pulled by gravity. The surface's normal is found
// from the closest point of the curve, its curvature by differences.
class Particle {
  public:
    Particle(AngleCurve curve, double distance, const Vec3& position, const Vec3& velocity)
        : curve_(std::move(curve)), x_(position), v_(velocity) {
        // To the surface, and along it.
        const Vec3 offset = x_ - curve_.at(find_angle(x_));
        x_ += (distance / offset.norm() - 1.0) * offset;
        v_ -= normal(x_) * normal(x_).dot(v_);
    }
    void advance(double time, int steps) {
        const double h = time / steps;
        for (int i = 0; i < steps; ++i) {
            const Vec3 a1 = acceleration(x_, v_);
            const Vec3 v2 = v_ + 0.5 * h * a1, a2 = acceleration(x_ + 0.5 * h * v_, v2);
            const Vec3 v3 = v_ + 0.5 * h * a2, a3 = acceleration(x_ + 0.5 * h * v2, v3);
            const Vec3 v4 = v_ + h * a3, a4 = acceleration(x_ + h * v3, v4);
            x_ += h / 6.0 * (v_ + 2.0 * v2 + 2.0 * v3 + v4);
            v_ += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
        }
    }
    const Vec3& position() const { return x_; }
    const Vec3& velocity() const { return v_; }

  private:
    double find_angle(const Vec3& x) const {
        for (int iteration = 0; iteration < 50; ++iteration) {
            const auto slope = [&](double angle) { return (curve_.at(angle) - x).dot(curve_.slope(angle)); };
            constexpr double small = 1e-5;
            const double by_angle = (slope(angle_ + small) - slope(angle_ - small)) / (2.0 * small);
            const double change = slope(angle_) / by_angle;
            angle_ -= change;
            if (std::abs(change) < 1e-13) break;
        }
        return angle_;
    }
    Vec3 normal(const Vec3& x) const { return (x - curve_.at(find_angle(x))).normalized(); }
    // n · a = −v · dn along v.
    Vec3 acceleration(const Vec3& x, const Vec3& v) const {
        const Vec3 n = normal(x);
        constexpr double small = 1e-5;
        const Vec3 turning = (normal(x + small * v) - normal(x - small * v)) / (2.0 * small);
        const Vec3 pull(0, 0, -gravity);
        return pull - n * (n.dot(pull) + v.dot(turning));
    }

    AngleCurve curve_;
    Vec3 x_, v_;
    mutable double angle_ = 0.0;
};

constexpr double ball_radius = 0.05, bore = 0.08, skin = 1e-3;
// What is left of the skin below a few weights.
constexpr double kept = 0.965 * skin * ball_radius;

std::string sliding_ball(const std::string& tube, const Vec3& at, const Vec3& velocity, double end) {
    return fmt::format(R"(
gravity = [0, 0, -9.81]
[body.ball]
mass = 0.5
inertia = [5e-4, 5e-4, 5e-4]
at = [{}, {}, {}]
velocity = [{}, {}, {}]
sphere = {{ radius = {}, force = 5e3 }}
[contact]
skin = {}
[obstacle.tube]
tube = {{ {}, radius = {}, side = "inside" }}
[analysis]
kind = "dynamic"
end_time = {}
time_step = 2e-4
)",
                       at.x(),
                       at.y(),
                       at.z(),
                       velocity.x(),
                       velocity.y(),
                       velocity.z(),
                       ball_radius,
                       skin,
                       tube,
                       bore,
                       end);
}

// How far the ball is from where the particle is, at most.
double find_distance(
    const std::string& tube, const AngleCurve& curve, const Vec3& at, const Vec3& velocity, double end) {
    Particle particle(curve, bore - ball_radius - kept, at, velocity);
    ContactRun run(sliding_ball(tube, particle.position(), particle.velocity(), end));
    double furthest = 0.0;
    while (!run.is_finished()) {
        const double before = run.time();
        run.step();
        particle.advance(run.time() - before, 1);
        furthest = std::max(furthest, (run.at("ball").r - particle.position()).norm());
    }
    CHECK(run.least_gap() > 0.0);
    CHECK(std::abs(run.ledger().energy_error) < 1e-6);
    return furthest;
}

}  // namespace

TEST_CASE("A ball swings in a tube along an arc", "[analyses][touch][bodies]") {
    const AngleCurve circle{[](double angle) { return Vec3(std::sin(angle), 0, -std::cos(angle)); },
                            [](double angle) { return Vec3(std::cos(angle), 0, std::sin(angle)); }};
    const std::string arc =
        "arc = { centre = [0, 0, 0], axis = [0, -1, 0], from = [-1, 0, 0], angle = \"pi\" }";
    // Sideways, too.
    const double error = find_distance(arc, circle, Vec3(-0.05, 0.012, -1.02), Vec3(2.5, 0, 0), 0.4);
    INFO(error);
    CHECK(error < 1e-4);
}

TEST_CASE("A ball slides down a tube along a helix", "[analyses][touch][bodies]") {
    const AngleCurve helix{
        [](double angle) { return Vec3(std::cos(angle), std::sin(angle), -0.5 * angle / (2.0 * M_PI)); },
        [](double angle) { return Vec3(-std::sin(angle), std::cos(angle), -0.5 / (2.0 * M_PI)); }};
    const std::string curve =
        "helix = { centre = [0, 0, 0], axis = [0, 0, -1], from = [1, 0, 0], turns = 2, pitch = 0.5 }";
    // The angle runs the other way about the axis that points down.
    AngleCurve down{[&](double angle) { return Vec3(helix.at(angle).cwiseProduct(Vec3(1, -1, 1))); },
                    [&](double angle) { return Vec3(helix.slope(angle).cwiseProduct(Vec3(1, -1, 1))); }};
    const double error = find_distance(curve, down, Vec3(1.01, 0, -0.03), Vec3(0, -1.0, 0), 0.5);
    INFO(error);
    CHECK(error < 1e-4);
}

}  // namespace gxrod::test
