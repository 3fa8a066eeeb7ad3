// Frequencies of continuous rods: transfer matrices, spectral elements and shooting, by two programs each.
#include <algorithm>
#include <numbers>

#include "analyses/shapes/modes.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double cycle = 2.0 * std::numbers::pi;
using std::numbers::pi;

// Each of these is a frequency of the model, and there is no mode that was not found.
void check_frequencies(const ModesRecord& record,
                       const std::vector<double>& expected,
                       double unit,
                       double tolerance) {
    CHECK(record.is_complete);
    for (const double frequency : expected) {
        double nearest = 0.0;
        for (const Mode& mode : record.modes) {
            const double found = mode.omega / unit;
            if (std::abs(found - frequency) < std::abs(nearest - frequency)) nearest = found;
        }
        CHECK(nearest == Approx(frequency).epsilon(tolerance));
    }
}

ModesRecord find_modes_at_rest(const Model& model, int count) {
    const System system(model);
    return find_modes(system, system.initial_state(), 0.0, {.count = count});
}

ModesRecord find_modes_of(const Model& model, const StaticRun& run, int count) {
    const System system(model);
    return find_modes(system, run.state, 1.0, {.count = count});
}

Section make_steel_section(double A, double Iy, double Iz, double J, double k) {
    constexpr double E = 2.1e11, G = E / 2.6, rho = 7850.0;
    return make_section({E * A, k * G * A, k * G * A, G * J, E * Iy, E * Iz},
                        {rho * A, rho * A, rho * A, rho * (Iy + Iz), rho * Iy, rho * Iz});
}

// Solid, round, of radius r.
Section make_steel_wire(double r) {
    const double I = pi * std::pow(r, 4) / 4.0;
    return make_steel_section(pi * r * r, I, I, 2.0 * I, 0.9);
}

// Holds what of a rod along x leaves the plane xy.
void keep_in_plane(Model& model) {
    for (int node = 0; node <= last_node(model); ++node)
        model.supports.push_back({.node = node, .fixed = {false, false, true, true, true, false}});
}

void hold(Model& model, int node, const HeldComponents& more) {
    for (Support& support : model.supports) {
        if (support.node != node) continue;
        for (int i = 0; i < 6; ++i) support.fixed[i] = support.fixed[i] || more[i];
        return;
    }
    model.supports.push_back({.node = node, .fixed = more});
}

}  // namespace

TEST_CASE("M1: a Timoshenko cantilever", "[analyses]") {
    constexpr double b = 0.05, h = 0.1;
    Model model = make_rod_model(
        along_x,
        1.0,
        {20, 4},
        make_steel_section(b * h, b * h * h * h / 12.0, h * b * b * b / 12.0, 2.8612e-6, 5.0 / 6.0));
    clamp(model, 0);
    const ModesRecord record = find_modes_at_rest(model, 8);
    // Torsion: ¼ √(GJ/ρI).
    const double torsion =
        0.25 * std::sqrt(2.1e11 / 2.6 * 2.8612e-6 / (7850.0 * b * h / 12.0 * (h * h + b * b)));
    CHECK(torsion == Approx(594.3645192755));
    check_frequencies(record,
                      {41.6927962022,
                       82.8943626933,
                       258.2412346932,
                       496.8145316089,
                       594.3645192755,
                       710.0464526770,
                       1293.0485382587},
                      cycle,
                      1e-9);
}

TEST_CASE("M4: arcs and a free ring", "[analyses]") {
    const Line arc = [](double s) {
        return Placement{Vec3(std::sin(s), 1.0 - std::cos(s), 0.0), exp_quaternion(Vec3(0.0, 0.0, s))};
    };
    const Section wire = make_steel_wire(0.05);
    Model model = make_rod_model(arc, 0.5 * pi, {24, 4}, wire);
    clamp(model, 0);
    check_frequencies(find_modes_at_rest(model, 4),
                      {29.8029734524, 30.7593800113, 141.1624666218, 145.8185747120},
                      cycle,
                      1e-9);
    clamp(model, last_node(model));
    check_frequencies(
        find_modes_at_rest(model, 4), {168.6828222822, 443.3373090583, 469.5689228338}, cycle, 2e-9);

    Model ring = make_rod_model(arc, 2.0 * pi, {40, 4}, wire);
    const int last = last_node(ring);
    ring.nodes.pop_back();
    for (int& node : ring.rods[0].element_nodes) node %= last;
    ring.rods[0].nodes.back() = 0;
    ring.rods[0].nodes.pop_back();
    const ModesRecord record = find_modes_at_rest(ring, 10);
    check_frequencies(record, {53.386760725, 54.948225830}, cycle, 2e-9);
    CHECK(record.modes[6].omega == Approx(record.modes[7].omega).epsilon(1e-9));
    CHECK(record.modes[8].omega == Approx(record.modes[9].omega).epsilon(1e-9));
}

TEST_CASE("M5: a pre-twisted cantilever", "[analyses]") {
    constexpr double L = 0.1524, b = 0.0254, h = 0.0017272, E = 206.85e9, G = 82.74e9, rho = 7857.6,
                     k = 0.847458;
    const double A = b * h, Iy = b * h * h * h / 12.0, Iz = h * b * b * b / 12.0;
    const double J = b * h * h * h / 3.0 * (1.0 - 0.63 * h / b);
    const Line twisted = [](double s) {
        return Placement{Vec3(s, 0.0, 0.0), exp_quaternion(Vec3(0.25 * pi * s / L, 0.0, 0.0))};
    };
    Model model =
        make_rod_model(twisted,
                       L,
                       {16, 4},
                       make_section({E * A, k * G * A, k * G * A, G * J, E * Iy, E * Iz},
                                    {rho * A, rho * A, rho * A, rho * (Iy + Iz), rho * Iy, rho * Iz}));
    clamp(model, 0);
    check_frequencies(find_modes_at_rest(model, 5),
                      {62.0303566652, 305.0148521096, 706.6384192563, 943.1263250207, 1199.8536795115},
                      cycle,
                      1e-8);
}

TEST_CASE("M6: a helical spring", "[analyses]") {
    constexpr double R = 0.05, turns = 3.0, height = 0.15;
    const double rise = height / (2.0 * pi * turns);
    const double speed = std::hypot(R, rise);
    const Line helix = [&](double s) {
        const double angle = s / speed;
        const Vec3 tangent(-R * std::sin(angle), R * std::cos(angle), rise);
        const Vec3 inward(-std::cos(angle), -std::sin(angle), 0.0);
        Mat3 axes;
        axes << tangent / speed, inward, (tangent / speed).cross(inward);
        return Placement{Vec3(R * std::cos(angle), R * std::sin(angle), rise * angle), Quat(axes)};
    };
    Model model = make_rod_model(helix, 2.0 * pi * turns * speed, {24, 4}, make_steel_wire(0.002));
    clamp(model, 0);
    clamp(model, last_node(model));
    check_frequencies(find_modes_at_rest(model, 6),
                      {44.865959524, 51.749387881, 57.855743593, 62.306374779, 78.913522288, 85.846329318},
                      cycle,
                      1e-8);
}

TEST_CASE("P12: prestressed beams", "[analyses]") {
    struct Row {
        bool is_clamped;
        double T;
        std::vector<double> omega;
    };
    const std::vector<Row> rows{
        {false, -5.0, {6.9171447145, 36.6356378356, 84.9746216257}},
        {false, 100.0, {32.7324082139, 73.4920762249, 127.3783782045, 196.4538926444}},
        {true, -5.0, {20.807203504571, 58.839844971474, 115.61590781386}},
        {true, 100.0, {40.522587746549, 89.633809334036, 152.03264639211, 229.10439446951}}};
    for (const Row& row : rows) {
        INFO((row.is_clamped ? "clamped" : "pinned") << ", T = " << row.T);
        Model model =
            make_rod_model(along_x,
                           1.0,
                           {24, 4},
                           make_section({1e4, 4e3, 4e3, 1.0, 1.0, 1.0}, {1.0, 1.0, 1.0, 2e-4, 1e-4, 1e-4}));
        keep_in_plane(model);
        hold(model, 0, {true, true, true, true, true, row.is_clamped});
        hold(model, last_node(model), {false, true, true, true, true, row.is_clamped});
        add_ramp(model, last_node(model), {row.T, 0.0, 0.0}, Vec3::Zero());
        const StaticRun run = run_static(model, make_static_settings(1));
        const ModesRecord record = find_modes_of(model, run, 6);
        check_frequencies(record, row.omega, 1.0, 2e-9);
        CHECK(record.is_symmetric);
    }
}

TEST_CASE("P13: vibrations about a large deflection", "[analyses]") {
    Model model =
        make_rod_model(along_x,
                       1.0,
                       {24, 4},
                       make_section({1e4, 4e3, 4e3, 0.8, 1.0, 1.0}, {1.0, 1.0, 1.0, 2e-4, 1e-4, 1e-4}));
    clamp(model, 0);
    const Model unloaded = model;
    struct Row {
        double P;
        std::vector<double> tip, omega;
    };
    const std::vector<Row> rows{
        {1.0,
         {0.9435299793, -0.3019412310},
         {3.663744465, 3.767800998, 21.620725163, 22.109606912, 59.533770913, 61.012098289}},
        {2.0,
         {0.8392754892, -0.4938238078},
         {3.987496796, 4.268621708, 21.257880493, 22.563172591, 57.651184273}},
        {5.0,
         {0.6122360517, -0.7145104204},
         {5.019748509, 5.630962618, 21.446982328, 24.235637822, 55.498411507}}};
    for (const Row& row : rows) {
        INFO("P = " << row.P);
        model = unloaded;
        add_ramp(model, last_node(model), {0.0, 0.0, -row.P}, Vec3::Zero());
        const StaticRun run = run_static(model, make_static_settings(4));
        CHECK(run.tip().r[0] == Approx(row.tip[0]).epsilon(1e-9));
        CHECK(run.tip().r[2] == Approx(row.tip[1]).epsilon(1e-9));
        const ModesRecord record = find_modes_of(model, run, static_cast<int>(row.omega.size()));
        REQUIRE(record.modes.size() == row.omega.size());
        CHECK(record.is_complete);
        CHECK(record.is_symmetric);
        for (std::size_t i = 0; i < row.omega.size(); ++i)
            CHECK(record.modes[i].omega == Approx(row.omega[i]).epsilon(1e-9));
    }
}

TEST_CASE("P11: a sagging cable and a hung chain", "[analyses]") {
    const auto make_cable = [](double EI, const Line& line) {
        return make_rod_model(
            line,
            1.0,
            {24, 4},
            make_section({1e4, 4e3, 4e3, 0.8 * EI, EI, EI}, {1.0, 1.0, 1.0, 2e-5, 1e-5, 1e-5}));
    };
    Model cable = make_cable(1e-2, along_x);
    cable.supports.push_back({.node = 0, .fixed = {true, true, true, true, false, true}});
    cable.supports.push_back({.node = last_node(cable), .fixed = {false, true, true, true, false, true}});
    cable.supports.back().moved[0] = true;
    cable.supports.back().motion[0] =
        TimeFunction([](double t) { return t < 0.25 ? 0.0 : -0.2 * (t - 0.25) / 0.75; });
    cable.gravity = TimeVector({TimeFunction(0.0), TimeFunction(0.0), TimeFunction([](double t) {
                                    return -10.0 * std::min(1.0, 4.0 * t);
                                })});
    const StaticRun run = run_static(cable, make_static_settings(20));
    CHECK(run.node(last_node(cable) / 2).r[2] == Approx(-0.2657215729).epsilon(1e-9));
    check_frequencies(
        find_modes_of(cable, run, 7),
        {7.415607194, 10.896960133, 14.681242670, 19.531788773, 23.145407810, 29.020145570, 32.910013133},
        1.0,
        2e-8);
    const Line down = [](double s) {
        return Placement{Vec3(0.0, 0.0, -s), exp_quaternion(Vec3(0.0, 0.5 * pi, 0.0))};
    };
    struct Row {
        double EI;
        std::vector<double> omega;
    };
    for (const Row& row : {Row{1e-3, {3.80151822, 8.77241666, 14.09142882, 20.00330205}},
                           Row{1e-2, {3.803814433, 9.046071746, 15.669065528, 23.902072024}}}) {
        Model chain = make_cable(row.EI, down);
        chain.supports.push_back({.node = 0, .fixed = {true, true, true, true, false, true}});
        chain.gravity = TimeVector({TimeFunction(0.0), TimeFunction(0.0), ramp(-10.0)});
        check_frequencies(
            find_modes_of(chain, run_static(chain, make_static_settings(1)), 8), row.omega, 1.0, 2e-8);
    }
}
