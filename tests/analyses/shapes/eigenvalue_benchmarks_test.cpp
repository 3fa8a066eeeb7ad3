// Flutter, damping and steady rotation of continuous rods: spectral elements and shooting, by two programs.
#include <algorithm>
#include <complex>
#include <numbers>

#include "analyses/shapes/eigenvalues.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

using Complex = std::complex<double>;

// Of Beck's and others' columns, along x in the plane xy.
struct FlutterColumn {
    double EA = 1e4, GA = 4e3, rotary = 1e-4;
    double kelvin_voigt = 0.0, mass_proportional = 0.0;
    double tip_mass = 0.0;
    bool is_distributed = false;  // the load
};

constexpr FlutterColumn stiff_column{.EA = 1e6, .GA = 4e5, .rotary = 1e-6};

Model make_column(const FlutterColumn& column, double P) {
    Section section = make_section({column.EA, column.GA, column.GA, 1.0, 1.0, 1.0},
                                   {1.0, 1.0, 1.0, 2.0 * column.rotary, column.rotary, column.rotary});
    section.kelvin_voigt = column.kelvin_voigt;
    section.mass_proportional = column.mass_proportional;
    Model model = make_rod_model(along_x, 1.0, {12, 4}, section);
    model.plane = Plane{.normal = 2};
    clamp(model, 0);
    if (column.tip_mass > 0.0)
        model.bodies.push_back({.name = "tip", .node = last_node(model), .mass = column.tip_mass});
    if (column.is_distributed) {
        DistributedLoad load;
        load.frame = Frame::follower;
        load.force[0] = LineFunction([P](double t, double) { return -P * t; });
        model.distributed_loads.push_back(load);
    } else {
        add_ramp(model, last_node(model), {-P, 0.0, 0.0}, Vec3::Zero(), Frame::follower);
    }
    return model;
}

std::vector<Complex> find_lambdas(const FlutterColumn& column, double P, int count = 4) {
    const Model model = make_column(column, P);
    const StaticRun run = run_static(model, make_static_settings(1));
    const System system(model);
    const EigenvaluesRecord record =
        find_eigenvalues(system, run.state, 1.0, {.count = count, .counts = false});
    REQUIRE(record.failure.empty());
    std::vector<Complex> lambdas;
    for (const Eigenmode& mode : record.modes) lambdas.push_back(mode.lambda());
    return lambdas;
}

// Of the two lowest frequencies, whose squares merge: what is zero where they do, smooth in P. Δ = (λ₁² −
// λ₂²)².
double find_discriminant(const FlutterColumn& column, double P) {
    std::vector<Complex> lambdas = find_lambdas(column, P);
    // After flutter the pair are λ and −conj λ, which has Im ≥ 0 too.
    const Complex difference = lambdas[0] * lambdas[0] - lambdas[1] * lambdas[1];
    return (difference * difference).real();
}

double find_zero(const std::function<double(double)>& f, double from, double to) {
    double f_from = f(from), f_to = f(to);
    REQUIRE(f_from * f_to < 0.0);
    // Regula falsi (Illinois).
    for (int i = 0; i < 60 && std::abs(to - from) > 1e-11 * std::abs(to); ++i) {
        const double middle = (from * f_to - to * f_from) / (f_to - f_from);
        const double f_middle = f(middle);
        if (f_middle == 0.0) return middle;
        if (f_middle * f_to < 0.0) {
            from = to;
            f_from = f_to;
        } else {
            f_from *= 0.5;
        }
        if (std::abs(middle - to) < 1e-11 * std::abs(to)) return middle;
        to = middle;
        f_to = f_middle;
    }
    return to;
}

double find_flutter_load(const FlutterColumn& column, double from, double to) {
    return find_zero([&](double P) { return find_discriminant(column, P); }, from, to);
}

double find_onset(const FlutterColumn& column, double from, double to) {
    const auto growth = [&](double P) {
        double largest = -1e300;
        for (const Complex& lambda : find_lambdas(column, P)) largest = std::max(largest, lambda.real());
        return largest;
    };
    return find_zero(growth, from, to);
}

Complex find_nearest(const EigenvaluesRecord& record, const Complex& expected) {
    Complex nearest = 0.0;
    for (const Eigenmode& mode : record.modes) {
        if (std::abs(mode.lambda() - expected) < std::abs(nearest - expected)) nearest = mode.lambda();
    }
    return nearest;
}

}  // namespace

TEST_CASE("P9a: Beck's column", "[analyses]") {
    struct Row {
        double P, first, second;
    };
    for (const Row& row : {Row{0.0, 3.5131597338, 21.9106231789},
                           Row{5.0, 4.2153199872, 20.3156816471},
                           Row{10.0, 5.1769330890, 18.4666032766},
                           Row{15.0, 6.6424272156, 16.1279336099},
                           Row{19.0, 8.9726419193, 13.1176119729}}) {
        INFO("P = " << row.P);
        const std::vector<Complex> lambdas = find_lambdas({}, row.P);
        CHECK(lambdas[0].imag() == Approx(row.first).epsilon(1e-9));
        CHECK(lambdas[1].imag() == Approx(row.second).epsilon(1e-9));
        CHECK(std::abs(lambdas[0].real()) < 1e-7);
    }
    CHECK(find_flutter_load({}, 19.5, 20.2) == Approx(19.9166940433).epsilon(2e-9));
    CHECK(find_flutter_load(stiff_column, 19.5, 20.2) == Approx(20.0495988973).epsilon(2e-9));
    const std::vector<Complex> beyond = find_lambdas({}, 1.001 * 19.9166940433);
    const auto growing = std::max_element(
        beyond.begin(), beyond.end(), [](Complex a, Complex b) { return a.real() < b.real(); });
    CHECK(std::abs(*growing - Complex(0.30638645, 10.96715131)) < 1e-6);
}

TEST_CASE("P9b and P9c: a distributed load that follows, and a mass at the tip", "[analyses]") {
    CHECK(find_flutter_load({.is_distributed = true}, 38.0, 41.0) == Approx(39.764833566).epsilon(1e-9));
    CHECK(find_flutter_load({.tip_mass = 0.5}, 15.5, 16.4) == Approx(15.990568170).epsilon(1e-9));
    CHECK(find_flutter_load({.tip_mass = 1.0}, 15.5, 16.5) == Approx(16.146174564).epsilon(1e-9));
}

TEST_CASE("P9d: little damping halves the load at which it flutters", "[analyses]") {
    CHECK(find_onset({.kelvin_voigt = 1e-4}, 9.0, 14.0) == Approx(10.900461679).epsilon(1e-9));
    CHECK(find_onset({.kelvin_voigt = 1e-3}, 9.0, 14.0) == Approx(10.900731288).epsilon(1e-9));
    CHECK(find_onset({.mass_proportional = 0.1}, 19.0, 20.2) == Approx(19.917224516).epsilon(1e-9));
    CHECK(find_onset({.kelvin_voigt = 1e-2}, 9.0, 14.0) == Approx(10.927689561).epsilon(1e-9));
    CHECK(find_onset({.kelvin_voigt = 5e-2}, 9.0, 14.0) == Approx(11.579680866).epsilon(1e-9));
    CHECK(find_onset({.mass_proportional = 1.0}, 19.0, 20.2) == Approx(19.969614631).epsilon(1e-9));
    CHECK(find_onset({.kelvin_voigt = 1e-3, .mass_proportional = 0.1}, 15.0, 19.0) ==
          Approx(17.451693620).epsilon(1e-9));
}

TEST_CASE("P13: vibrations about large deflections under a load that follows", "[analyses]") {
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
    for (const Row& row :
         {Row{2.0, {0.7670110664, -0.5741800677}, {3.706080195, 3.756366117, 19.266530690, 21.270091092}},
          Row{5.0, {0.1712283517, -0.7803167913}, {4.579752086, 4.909405275, 13.728035231, 18.754960083}}}) {
        INFO("P = " << row.P);
        model = unloaded;
        add_ramp(model, last_node(model), {0.0, 0.0, -row.P}, Vec3::Zero(), Frame::follower);
        const StaticRun run = run_static(model, make_static_settings(8));
        CHECK(run.tip().r[0] == Approx(row.tip[0]).epsilon(1e-9));
        CHECK(run.tip().r[2] == Approx(row.tip[1]).epsilon(1e-9));
        const System system(model);
        const EigenvaluesRecord record = find_eigenvalues(system, run.state, 1.0, {.count = 4});
        CHECK(record.is_complete);
        REQUIRE(record.modes.size() >= 4);
        for (std::size_t i = 0; i < 4; ++i)
            CHECK(record.modes[i].omega == Approx(row.omega[i]).epsilon(1e-9));
    }
}

TEST_CASE("P14: eigenvalues of a damped cantilever", "[analyses]") {
    const Model model = make_column({.kelvin_voigt = 2e-3, .mass_proportional = 0.2}, 0.0);
    const System system(model);
    const EigenvaluesRecord record = find_eigenvalues(system, system.initial_state(), 0.0, {.count = 3});
    CHECK(record.is_complete);
    CHECK(record.unstable == 0);
    for (const Complex& expected : {Complex(-0.1123422913, 3.5113630571),
                                    Complex(-0.5800754081, 21.9029431951),
                                    Complex(-3.8066013306, 60.7627444814)})
        CHECK(std::abs(find_nearest(record, expected) - expected) < 2e-9 * std::abs(expected));
}
