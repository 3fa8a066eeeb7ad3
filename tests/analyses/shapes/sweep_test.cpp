#include "analyses/shapes/sweep.hpp"

#include <memory>

#include "analyses/shapes/mode_tracking.hpp"
#include "analyses/shapes/onset.hpp"
#include "tools/catch.hpp"
#include "tools/dense_algebra.hpp"
#include "tools/rod_models.hpp"
#include "tools/steady_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

using Complex = std::complex<double>;

std::vector<double> make_values(double from, double to, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(from + (to - from) * i / (count - 1));
    return values;
}

// Two oscillators by their matrices at a value of the parameter.
std::vector<Complex> find_pair(double damping, double coupling, double value) {
    // λ² + damping λ + [[1, −c v], [c v, 2]]: the undamped ones merge at c v = 1/2.
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(4, 4);
    A.topRightCorner(2, 2).setIdentity();
    A(2, 0) = -1.0;
    A(3, 1) = -2.0;
    A(2, 1) = coupling * value;
    A(3, 0) = -coupling * value;
    A(2, 2) = A(3, 3) = -damping;
    std::vector<Complex> lambdas = find_eigenvalues(A);
    std::erase_if(lambdas, [](Complex lambda) { return lambda.imag() < 0.0; });
    return lambdas;
}

// Blades on a hub whose speed is the parameter, each from the state before.
class Rotor {
  public:
    explicit Rotor(const Model& model) : model_(model) {}

    SweepState at(double speed) {
        const double from = speed_;
        const TurningFrame frame{
            .axis = Vec3::UnitZ(), .through = Vec3::Zero(), .speed = TimeFunction([from, speed](double t) {
                                                                return from + t * (speed - from);
                                                            })};
        auto next = std::make_unique<SteadyAnalysis>(model_, make_static_settings(1), frame);
        EquilibriumReport report = analysis_ ? next->start_after(*analysis_) : next->start();
        while (report.converged() && !next->finished()) report = next->advance();
        if (!report.converged()) return {.failure = "no equilibrium"};
        analysis_ = std::move(next);
        speed_ = speed;
        return {.failure = "",
                .system = &analysis_->system(),
                .state = &analysis_->state(),
                .time = 1.0,
                .frame = &analysis_->frame_columns()};
    }

  private:
    const Model& model_;
    std::unique_ptr<SteadyAnalysis> analysis_;
    double speed_ = 0.0;
};

Model make_blade() {
    const Line line = [](double s) { return Placement{Vec3(0.2 + s, 0.0, 0.0), Quat::Identity()}; };
    Model model = make_rod_model(
        line, 1.0, {8, 4}, make_section({1e4, 4e3, 4e3, 0.8, 1.0, 4.0}, {1.0, 1.0, 1.0, 5e-4, 1e-4, 4e-4}));
    model.rods[0].name = "blade";
    clamp(model, 0);
    return model;
}

}  // namespace

TEST_CASE("the modes of a blade are followed over its speed", "[analyses]") {
    const Model model = make_blade();
    Rotor rotor(model);
    SweepSettings settings;
    settings.eigenvalues.count = 4;
    const SweepRecord record = sweep_eigenvalues(
        make_values(0.0, 10.0, 6), [&](double speed) { return rotor.at(speed); }, settings);
    REQUIRE(record.points.size() == 6);
    REQUIRE(record.words.size() == 4);
    CHECK(record.words[0] == "1st bending about y of blade");
    CHECK(record.words[1] == "1st bending about z of blade");
    for (const SweepRecord::Point& point : record.points) {
        INFO("speed " << point.value);
        CHECK(point.failure.empty());
        CHECK_FALSE(point.is_growing);
        REQUIRE(point.lambda.size() == 4);
        for (const double corruption : point.corruption) CHECK(corruption < 0.2);
    }
    // Flap rises above lag in between.
    const std::vector<Complex>& first = record.points.front().lambda;
    const std::vector<Complex>& last = record.points.back().lambda;
    CHECK(first[0].imag() == Approx(3.5131597338).epsilon(1e-8));
    CHECK(first[1].imag() == Approx(7.0092876523).epsilon(1e-8));
    CHECK(last[0].imag() == Approx(12.4532489861).epsilon(1e-8));
    CHECK(last[1].imag() == Approx(9.7069294310).epsilon(1e-8));
    CHECK(record.onsets.empty());
    CHECK(record.equilibria == 6);
}

TEST_CASE("the onset of flutter is found where undamped frequencies merge, or damped motions begin to grow",
          "[analyses]") {
    const auto undamped = [](double value) { return find_pair(0.0, 1.0, value); };
    const std::optional<Onset> merging = find_onset(undamped, 0.3, 0.9);
    REQUIRE(merging);
    CHECK(merging->is_flutter);
    CHECK(merging->is_merging);
    CHECK(merging->value == Approx(0.5).epsilon(1e-9));
    CHECK(merging->omega == Approx(std::sqrt(1.5)).epsilon(1e-8));
    // Both damped by c: λ² + cλ = −1.5 ± i √(v² − ¼) grows where Im² > 1.5 c².
    constexpr double damping = 0.2;
    const auto damped = [](double value) { return find_pair(damping, 1.0, value); };
    const std::optional<Onset> growing = find_onset(damped, 0.3, 0.9);
    REQUIRE(growing);
    CHECK(growing->is_flutter);
    CHECK_FALSE(growing->is_merging);
    CHECK(growing->value == Approx(std::sqrt(0.25 + 1.5 * damping * damping)).epsilon(1e-9));
    CHECK(growing->omega == Approx(std::sqrt(1.5)).epsilon(1e-8));
    // λ² = v − 2.
    const auto diverging = [](double value) {
        const Complex lambda = std::sqrt(Complex(value - 2.0));
        return lambda.imag() > 0.0 ? std::vector<Complex>{lambda, {0.0, 3.0}}
                                   : std::vector<Complex>{lambda, -lambda, {0.0, 3.0}};
    };
    const std::optional<Onset> divergence = find_onset(diverging, 1.0, 4.0);
    REQUIRE(divergence);
    CHECK_FALSE(divergence->is_flutter);
    CHECK(divergence->value == Approx(2.0).epsilon(1e-9));
}

TEST_CASE("a sweep over a load finds that at which a column flutters", "[analyses]") {
    // P9a.
    Model model =
        make_rod_model(along_x,
                       1.0,
                       {12, 4},
                       make_section({1e4, 4e3, 4e3, 1.0, 1.0, 1.0}, {1.0, 1.0, 1.0, 2e-4, 1e-4, 1e-4}));
    model.plane = Plane{.normal = 2};
    clamp(model, 0);
    const Model unloaded = model;
    std::unique_ptr<StaticAnalysis> analysis;
    const auto find_state = [&](double P) -> SweepState {
        analysis.reset();
        model = unloaded;
        add_ramp(model, last_node(model), {-P, 0.0, 0.0}, Vec3::Zero(), Frame::follower);
        analysis = std::make_unique<StaticAnalysis>(model, make_static_settings(1));
        EquilibriumReport report = analysis->start();
        while (report.converged() && !analysis->finished()) report = analysis->advance();
        return {.failure = report.converged() ? "" : "no equilibrium",
                .system = &analysis->system(),
                .state = &analysis->state(),
                .time = 1.0};
    };
    SweepSettings settings;
    settings.eigenvalues.count = 2;
    const SweepRecord record = sweep_eigenvalues(make_values(10.0, 25.0, 4), find_state, settings);
    REQUIRE(record.onsets.size() == 1);
    CHECK(record.onsets[0].begins);
    CHECK(record.onsets[0].is_flutter);
    CHECK(record.onsets[0].is_merging);
    CHECK(record.onsets[0].value == Approx(19.9166940433).epsilon(2e-9));
    CHECK(record.onsets[0].omega == Approx(10.968801873).epsilon(1e-8));
    CHECK(record.points[2].is_growing);
    CHECK(record.points[0].lambda[0].imag() == Approx(5.1769330890).epsilon(1e-8));
}
