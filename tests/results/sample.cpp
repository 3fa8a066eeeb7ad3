#include "results/sample.hpp"

#include <stdlib.h>

#include <cmath>
#include <stdexcept>

#include "rotation/rotation_map.hpp"

namespace gxrod::sample {

Model make_model() {
    Model model;
    for (int i = 0; i < 4; ++i) {
        Node node;
        node.name = "node " + std::to_string(i);
        node.position = Vec3(i, 0.5 * i, i == 3 ? 2.0 : 0.0);
        model.nodes.push_back(node);
    }
    Section section{"tube", Mat6::Identity(), Mat6::Identity()};
    section.stiffness.diagonal() << 1e4, 1e4, 1e4, 500.0, 400.0, 600.0;
    model.sections = {section};

    Rod beam;
    beam.name = "beam";
    beam.nodes = {0, 1, 2};
    set_line_elements(
        beam,
        {0.0, 1.0, 2.0},
        {exp_quaternion({0.1, 0.2, 0.3}), exp_quaternion({0.2, 0.2, 0.3}), exp_quaternion({0.3, 0.2, 0.3})});
    model.rods = {beam};

    Body tip;
    tip.name = "tip";
    tip.node = 2;
    tip.attitude = exp_quaternion({0.0, 0.0, 1.5});
    Body gyro;
    gyro.name = "gyro";
    gyro.node = 3;
    gyro.mass = 2.0;
    gyro.inertia = Mat3::Identity();
    gyro.centre_of_mass = Vec3(0.0, 0.1, 0.4);
    gyro.attitude = exp_quaternion({0.0, 1.0, 0.0});
    model.bodies = {tip, gyro};
    return model;
}

OutputSettings make_output() {
    const std::vector<std::string> of_node{"position",
                                           "displacement",
                                           "rotation_vector",
                                           "quaternion",
                                           "orientation",
                                           "velocity",
                                           "angular_velocity",
                                           "angular_velocity_material",
                                           "acceleration"};
    std::vector<std::string> of_rod = of_node;
    of_rod.insert(of_rod.end(),
                  {"force",
                   "moment",
                   "force_spatial",
                   "moment_spatial",
                   "strain",
                   "curvature",
                   "reaction_force",
                   "reaction_moment"});
    std::vector<std::string> of_body = of_node;
    of_body.push_back("centre_of_mass");

    HistoryRequest middle{
        .name = "middle", .at = "beam@0.5", .target = WatchedPoint{{0, 0, 1.0}, 1}, .quantities = of_rod};
    HistoryRequest root{
        .name = "root", .at = "beam.start", .target = WatchedPoint{{0, 0, -1.0}, 0}, .quantities = of_rod};
    HistoryRequest tip{
        .name = "tip", .at = "tip", .target = WatchedBody{.index = 0, .node = 2}, .quantities = of_body};
    HistoryRequest gyro{
        .name = "gyro", .at = "gyro", .target = WatchedBody{.index = 1, .node = 3}, .quantities = of_body};
    OutputSettings output;
    output.histories = {middle, root, tip, gyro};
    return output;
}

DeckRecord make_deck() {
    DeckRecord deck{"sample.toml", "title = \"Sample\"\n# ½ metre\n", "Sample", "m kg s"};
    deck.integrators = "sdirk-4";
    return deck;
}

Motion::Motion(double t) : time(t) {
    const Model model = make_model();
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const double k = 1.0 + static_cast<double>(i);
        NodeMotion node;
        node.r = model.nodes[i].position + t * Vec3(k, 2.0 * k, 3.0 * k);
        node.Lambda = exp_quaternion(t * Vec3(0.3, 0.2 * k, -0.4));
        node.v = Vec3(k, std::sin(t), 0.5);
        node.a = Vec3(0.1 * k, std::cos(t), -0.5);
        node.omega = Vec3(0.3, 0.2 * k, t);
        node.alpha = Vec3(t, 1.0, k);
        nodes.push_back(node);
        Vec6 reaction = Vec6::Zero();
        if (i == 0) reaction << 1.0 + t, 2.0, 3.0, 4.0, 5.0, 6.0;
        reactions.push_back(reaction);
    }
    for (int e = 0; e < 2; ++e) {
        const double k = 10.0 * (1 + e);
        elements.push_back({Vec3(k + t, k + 1, k + 2),
                            Vec3(k + 3, k + 4 + t, k + 5),
                            Vec3(0.1 * k, 0.2 * k, 0.3 * k + t),
                            Vec3(0.4 * k, 0.5 * k + t, 0.6 * k),
                            exp_quaternion(Vec3(0.1 * k, t, 0.2))});
    }
    for (int p = 0; p < 2; ++p) {
        const double k = 100.0 * (1 + p);
        PointValues point;
        point.motion.r = Vec3(k + t, 2.0, 3.0);
        point.motion.v = Vec3(4.0, k + t, 5.0);
        point.motion.a = Vec3(6.0, 7.0, k + t);
        point.motion.omega = Vec3(k - t, 8.0, 9.0);
        point.motion.Lambda = exp_quaternion(Vec3(0.001 * k, t, 0.1));
        point.start = Vec3(k, 1.0, 1.0);
        point.triad = exp_quaternion(Vec3(0.2, 0.001 * k, 0.3));
        point.force = Vec3(k + 1, t, 2);
        point.moment = Vec3(k + 2, t, 3);
        point.strain = Vec3(k + 3, t, 4);
        point.curvature = Vec3(k + 4, t, 5);
        points.push_back(point);
    }
}

LedgerRow make_ledger(double t) {
    LedgerRow row;
    row.kinetic_energy = 1.0 + t;
    row.strain_energy = 2.0 + t;
    row.external_work = 3.0 + t;
    row.work_uncertainty = 3.5 + t;
    row.dissipated_energy = 4.0 + t;
    row.numerical_dissipation = 4.5 + t;
    row.fluid_work = 0.5 + t;
    row.energy_error = 5.0 + t;
    row.linear_momentum = Vec3(6.0 + t, 7.0, 8.0);
    row.angular_momentum = Vec3(9.0 + t, 10.0, 11.0);
    return row;
}

SolverRow make_solver(double t) {
    return {0.25 + t, 3 + static_cast<int>(t), 1e-9 * (1.0 + t), static_cast<int>(2 * t)};
}

RestartRecord make_restart(double t) {
    RestartRecord record;
    const Motion motion(t);
    record.nodes = motion.nodes;
    for (NodeMotion& node : record.nodes) {
        node.r = Vec3(t, 2.0 * t, 3.0 * t);
        const double k = node.v.x();
        record.sections.push_back({node.Lambda, Vec3(k, t, 7.0)});
        record.carried.push_back({Vec3(k, 8.0, t), Vec3(t, 9.0, k)});
        record.ledger.forces.push_back(Vec6::Constant(k + t));
        record.ledger.force_change.push_back(Vec6::Constant(k - t));
        record.ledger.fluid_forces.push_back(Vec6::Constant(k + 2.0 * t));
        record.memory.push_back(k - 2.0 * t);
        record.ledger.movement.push_back(Vec6::Constant(2.0 * k - t));
        record.path.tangent.push_back(Vec6::Constant(3.0 * k - t));
    }
    record.ledger.initial_energy = 1.5;
    record.ledger.initial_potential = 2.5;
    record.ledger.work = 3.5 + t;
    record.ledger.dissipated = 4.5;
    record.ledger.dissipated_by_scheme = 4.75;
    record.ledger.fluid_work = 3.25;
    record.ledger.driving_power = 5.5;
    record.ledger.damping_power = 6.5;
    record.ledger.load_step = 0.875;
    record.ledger.strain_energy = 6.75 + t;
    record.ledger.largest_energy = 7.25;
    record.steps = {true, t, true, 0.01, 0.0625, 0.3, true, 17};
    record.inputs = {{1.0, 0.5, 1.5, 2.5, 3.5 + t, 4.5}, {0.0, -1.0, 0.0, 0.0, 0.0, 0.0}};
    record.path.load_factor = 1.125 + t;
    record.path.load_scale = 2.125;
    record.path.load_rate = 3.125;
    record.path.load_sense = -1;
    record.path.points = 22;
    record.stage = 2;
    record.axis_start = 4.125;
    record.is_framed = true;
    record.totals = {18, 19, 20, 7.5, 8.5, {21, {0.25, 0.75, 9.5}}};
    return record;
}

ScratchFolder::ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "gxrod_results_XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no scratch folder");
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace gxrod::sample
