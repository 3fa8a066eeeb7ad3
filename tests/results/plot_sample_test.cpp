#include <cmath>
#include <csignal>
#include <cstdlib>
#include <numbers>

#include "results/results_file.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

// A made-up motion that is worth drawing: a helical rod that sways and unwinds, and a spinning top next to
// it.

using namespace gxrod;

namespace {

constexpr int elements = 60;
constexpr int steps = 400;
constexpr double end_time = 10.0;
using std::numbers::pi;

Vec3 centreline(double s, double time) {
    const double sway = std::sin(2.0 * pi * time / end_time);
    const double angle = 2.0 * pi * s * (1.5 - 0.6 * time / end_time);
    return {std::cos(angle) + 1.5 * sway * s * s, std::sin(angle), 3.0 * s * (1.0 + 0.2 * std::abs(sway))};
}

Quat section_axes(double s, double time) {
    constexpr double h = 1e-5;
    Mat3 axes;
    axes.col(0) = (centreline(s + h, time) - centreline(s - h, time)).normalized();
    axes.col(1) = Vec3::UnitZ().cross(axes.col(0)).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return Quat(axes);
}

Quat top_attitude(double time) {
    using Eigen::AngleAxisd;
    const double tilt = 0.7 + 0.12 * std::cos(6.0 * time);
    return AngleAxisd(1.2 * time + 0.15 * std::sin(6.0 * time), Vec3::UnitZ()) *
           AngleAxisd(tilt, Vec3::UnitY()) * AngleAxisd(20.0 * time, Vec3::UnitZ());
}

double arc(int node) { return static_cast<double>(node) / elements; }

Model make_model() {
    Model model;
    Rod rod;
    rod.name = "spring";
    std::vector<double> arc_length;
    std::vector<Quat> triads;
    for (int i = 0; i <= elements; ++i) {
        Node node;
        node.position = centreline(arc(i), 0.0);
        model.nodes.push_back(node);
        rod.nodes.push_back(i);
        triads.push_back(section_axes(arc(i), 0.0));
        arc_length.push_back(arc(i));
    }
    set_line_elements(rod, arc_length, triads);
    model.sections = {Section{"wire", Mat6::Identity(), Mat6::Identity()}};
    model.rods = {rod};
    Node pivot;
    pivot.position = Vec3(-2.5, 0.0, 0.0);
    model.nodes.push_back(pivot);
    Body top;
    top.name = "top";
    top.node = elements + 1;
    top.centre_of_mass = Vec3(0.0, 0.0, 1.0);
    top.attitude = top_attitude(0.0);
    model.bodies = {top};
    return model;
}

OutputSettings make_output() {
    HistoryRequest tip{.name = "tip",
                       .at = "spring.end",
                       .target = WatchedPoint{{0, elements - 1, 1.0}, elements},
                       .quantities = {"displacement", "velocity", "moment"}};
    HistoryRequest top{.name = "top",
                       .at = "top",
                       .target = WatchedBody{.index = 0, .node = elements + 1},
                       .quantities = {"centre_of_mass", "angular_velocity_material", "quaternion"}};
    OutputSettings output;
    output.histories = {tip, top};
    return output;
}

struct Motion {
    std::vector<NodeMotion> nodes;
    std::vector<SectionValues> sections;
    std::vector<Vec6> reactions;
    std::vector<PointValues> points;  // "tip"
};

Motion move(const Model& model, double time) {
    Motion motion;
    motion.nodes.resize(model.nodes.size());
    motion.reactions.resize(model.nodes.size(), Vec6::Zero());
    for (int i = 0; i <= elements; ++i) {
        const auto index = static_cast<std::size_t>(i);
        NodeMotion& node = motion.nodes[index];
        node.r = centreline(arc(i), time);
        node.v = (centreline(arc(i), time + 1e-5) - centreline(arc(i), time - 1e-5)) / 2e-5;
        node.Lambda = section_axes(arc(i), time) * model.rods[0].triad_at(i).conjugate();
    }
    for (int e = 0; e < elements; ++e) {
        const double s = arc(e) + 0.5 / elements;
        const double sway = std::sin(2.0 * pi * time / end_time);
        motion.sections.push_back({Vec3(sway, 0.2 * sway, 0.1),
                                   Vec3(0.3 * sway, 0.5 * (1.0 - s), sway * s),
                                   Vec3(1e-3 * sway, 0.0, 0.0),
                                   Vec3(0.0, 0.0, 0.2 * sway),
                                   section_axes(s, time)});
    }
    const SectionValues& last = motion.sections.back();
    motion.points.push_back(
        {{}, Vec3::Zero(), Quat::Identity(), last.force, last.moment, last.strain, last.curvature, {}});
    NodeMotion& pivot = motion.nodes.back();
    pivot.r = model.nodes.back().position;
    pivot.Lambda = top_attitude(time) * model.bodies[0].attitude.conjugate();
    pivot.omega = top_attitude(time) * Vec3(1.2 * std::cos(20.0 * time), 1.2 * std::sin(20.0 * time), 20.0);
    return motion;
}

LedgerRow make_ledger(double time) {
    LedgerRow row;
    row.external_work = 12.0 * (1.0 - std::exp(-0.5 * time));
    row.kinetic_energy = row.external_work * std::pow(std::cos(1.5 * time), 2);
    row.strain_energy = 0.97 * (row.external_work - row.kinetic_energy);
    row.dissipated_energy = 0.03 * (row.external_work - row.kinetic_energy);
    row.energy_error = 1e-7 * std::sin(3.0 * time) * time;
    row.linear_momentum = Vec3(std::sin(time), 0.4 * std::cos(time), 0.1 * time);
    row.angular_momentum = Vec3(0.5 * std::cos(2 * time), 0.5 * std::sin(2 * time), 3.0);
    return row;
}

}  // namespace

// Not a test: writes a results file for tests/apps/gxrod_plot_test.py, at $GXROD_PLOT_SAMPLE. It is killed
// while it writes if $GXROD_PLOT_SAMPLE_KILLED is set.
TEST_CASE("Write results to draw", "[.plot-sample]") {
    const char* path = std::getenv("GXROD_PLOT_SAMPLE");
    REQUIRE(path);
    const char* killed = std::getenv("GXROD_PLOT_SAMPLE_KILLED");
    const Model model = make_model();
    ResultsFile file({path, Existing::replace},
                     {"spring.toml",
                      "title = \"Swaying spring and spinning top\"\n",
                      "Swaying spring and spinning top",
                      "m kg s"},
                     model,
                     make_output());
    for (int step = 0; step <= steps; ++step) {
        if (killed && step == std::atoi(killed)) {
            file.flush();
            std::raise(SIGKILL);
        }
        const double time = end_time * step / steps;
        const Motion motion = move(model, time);
        const Snapshot snapshot{time, motion.nodes, motion.sections, motion.reactions, motion.points};
        file.record_step(snapshot, make_ledger(time), {end_time / steps, 3, 1e-10, 0});
        if (step % 4 == 0) file.write_frame(snapshot);
    }
    file.close(RunStatus::complete, "end_time reached");
}
