#include "loads/drive_values.hpp"

#include <cmath>

#include "model/evaluation_error.hpp"
#include "numerics/gauss_legendre.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double length = 3.0;

Section any_section() { return make_section({1, 1, 1, 1, 1, 1}); }

Model make_model(const Mesh& mesh) { return make_rod_model(along_x, length, mesh, any_section()); }

LineFunction line(const std::function<double(double, double)>& function) {
    return LineFunction(function, nullptr, {InTime::varying, false});
}

Tendon make_tendon(double from, double to, const TimeFunction& tension) {
    return {.name = "cable", .rod = 0, .from = from, .to = to, .tension = tension, .path = [](double s) {
                return TendonPlace{Vec3(0.0, std::sin(s), s * s), Vec3(0.0, std::cos(s), 2.0 * s)};
            }};
}

// ∫ f ds by values at force points, with the weights of Gauss' rule.
double integrate(const Rod& rod, const std::function<double(std::size_t point)>& value) {
    const auto order = static_cast<std::size_t>(rod.order);
    const std::vector<QuadraturePoint> rule = list_gauss_rule(rod.order);
    double sum = 0.0;
    for (std::size_t e = 0; e < static_cast<std::size_t>(rod.element_count()); ++e) {
        const double size = rod.arc_length[e * (order + 1) + order] - rod.arc_length[e * (order + 1)];
        for (std::size_t p = 0; p < order; ++p) sum += 0.5 * size * rule[p].weight * value(e * order + p);
    }
    return sum;
}

}  // namespace

TEST_CASE("force points are those of Gauss' rule in each element", "[loads]") {
    // So polynomials of degree 2 · order − 1 are integrated exactly, in elements of any lengths.
    for (int order = 1; order <= 4; ++order) {
        Model model = make_model({5, order});
        Rod& rod = model.rods[0];
        for (double& s : rod.arc_length) s = s * (s + 1.0) / (length + 1.0);
        const std::vector<double> points = list_force_points(rod);
        REQUIRE(points.size() == static_cast<std::size_t>(5 * order));
        for (int power = 0; power < 2 * order; ++power) {
            const double sum = integrate(rod, [&](std::size_t i) { return std::pow(points[i], power); });
            CHECK(sum == Approx(std::pow(length, power + 1) / (power + 1)).epsilon(1e-13));
        }
    }
}

TEST_CASE("actuations add up at the force points of their rod, at each time", "[loads]") {
    Model model = make_model({4, 3});
    model.rods.push_back(model.rods[0]);
    Actuation bending{.key = "actuation[0]", .rod = 1};
    bending.strain[5] = line([](double t, double s) { return t * s; });
    bending.strain[1] = 0.5;
    Actuation growth{.key = "actuation[1]", .rod = 1};
    growth.strain[0] = line([](double t, double s) { return s - t; });
    growth.strain[5] = 1.0;
    model.actuations = {bending, growth};
    DriveValues values(model);
    CHECK_FALSE(values.empty());
    CHECK_FALSE(values.is_driven(0));
    REQUIRE(values.is_driven(1));
    CHECK(values.of(0, 2).empty());
    const std::vector<double> points = list_force_points(model.rods[1]);
    for (const double t : {0.0, 2.0, 0.7}) {
        values.move_to(t);
        for (int e = 0; e < 4; ++e) {
            const auto drives = values.of(1, e);
            REQUIRE(drives.size() == 3);
            for (std::size_t p = 0; p < 3; ++p) {
                const double s = points[static_cast<std::size_t>(e) * 3 + p];
                Vec6 expected;
                expected << s - t, 0.5, 0.0, 0.0, 0.0, t * s + 1.0;
                CHECK((drives[p].strain - expected).norm() < 1e-14);
                CHECK(drives[p].pulls.empty());
            }
        }
    }
}

TEST_CASE("heat stretches and bends as the section's points would stretch", "[loads]") {
    // A point (y, z) of the section has the strain Γx + Ky z − Kz y, and takes expansion × its temperature.
    Model model = make_model({2, 2});
    Rod& rod = model.rods[0];
    for (std::size_t i = 0; i < list_force_points(rod).size(); ++i) {
        Section section = any_section();
        section.expansion = 1e-5 * static_cast<double>(i + 1);
        rod.varying.at_forces.push_back(section);
    }
    rod.varying.at_nodes.resize(6);
    Actuation heat{.key = "actuation[0]", .rod = 0, .temperature = line([](double t, double) { return t; })};
    heat.temperature_gradient = {line([](double, double s) { return 3.0 * s; }),
                                 line([](double t, double s) { return t - s; })};
    model.actuations = {heat};
    DriveValues values(model);
    values.move_to(40.0);
    const std::vector<double> points = list_force_points(rod);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec6 E = values.of(0, static_cast<int>(i / 2))[i % 2].strain;
        for (const auto& [y, z] : {std::pair(0.0, 0.0), std::pair(0.2, 0.0), std::pair(-0.3, 0.7)}) {
            const double temperature = 40.0 + 3.0 * points[i] * y + (40.0 - points[i]) * z;
            const double expected = rod.varying.at_forces[i].expansion * temperature;
            CHECK(E[0] + E[4] * z - E[5] * y == Approx(expected).epsilon(1e-13));
        }
        CHECK(E[1] == 0.0);
        CHECK(E[2] == 0.0);
        CHECK(E[3] == 0.0);
    }
    // Without varying sections it is the rod's.
    rod.varying = {};
    model.sections[0].expansion = 2e-5;
    DriveValues constant(model);
    constant.move_to(40.0);
    CHECK(constant.of(0, 1)[1].strain[0] == Approx(2e-5 * 40.0));
}

TEST_CASE("a tendon passes the elements between its ends, whole", "[loads]") {
    Model model = make_model({6, 2});
    model.tendons = {make_tendon(0.0, length, ramp(5.0)), make_tendon(1.0, 2.0, -3.0)};
    DriveValues values(model);
    values.move_to(2.0);
    const std::vector<double> points = list_force_points(model.rods[0]);
    for (int e = 0; e < 6; ++e) {
        const bool is_inside = e == 2 || e == 3;
        for (std::size_t p = 0; p < 2; ++p) {
            const auto& pulls = values.of(0, e)[p].pulls;
            REQUIRE(pulls.size() == (is_inside ? 2U : 1U));
            const double s = points[static_cast<std::size_t>(e) * 2 + p];
            CHECK(pulls[0].tension == 10.0);
            CHECK(pulls[0].at == Vec3(0.0, std::sin(s), s * s));
            CHECK(pulls[0].slope == Vec3(0.0, std::cos(s), 2.0 * s));
            if (is_inside) CHECK(pulls[1].tension == -3.0);
        }
    }
}

TEST_CASE("drives are evaluated again only at another time, or when told to forget", "[loads]") {
    Model model = make_model({2, 1});
    double input = 1.0;
    int calls = 0;
    Actuation muscle{.key = "actuation[0]", .rod = 0};
    muscle.strain[4] = line([&](double, double) { return ++calls, input; });
    model.actuations = {muscle};
    model.tendons = {make_tendon(0.0, length, TimeFunction([&](double) { return input; }))};
    DriveValues values(model);
    values.move_to(1.0);
    const int once = calls;
    CHECK(once == 2);
    input = 7.0;
    values.move_to(1.0);
    CHECK(calls == once);
    CHECK(values.of(0, 1)[0].strain[4] == 1.0);
    values.forget();
    values.move_to(1.0);
    CHECK(values.of(0, 1)[0].strain[4] == 7.0);
    CHECK(values.of(0, 0)[0].pulls[0].tension == 7.0);
    input = 8.0;
    values.move_to(0.0);
    CHECK(values.of(0, 0)[0].pulls[0].tension == 8.0);
}

TEST_CASE("a value that fails leaves no values of that time", "[loads]") {
    Model model = make_model({2, 1});
    bool fails = true;
    Actuation muscle{.key = "actuation[0]", .rod = 0};
    muscle.strain[0] = line([&](double t, double) {
        if (t > 1.0 && fails) throw EvaluationError("actuation[0].stretch: too late");
        return t;
    });
    model.actuations = {muscle};
    DriveValues values(model);
    values.move_to(1.0);
    CHECK_THROWS_AS(values.move_to(2.0), EvaluationError);
    fails = false;
    values.move_to(2.0);
    CHECK(values.of(0, 1)[0].strain[0] == 2.0);
}

TEST_CASE("a model that nothing drives has no drives", "[loads]") {
    const Model model = make_model({2, 1});
    DriveValues values(model);
    values.move_to(0.0);
    CHECK(values.empty());
    CHECK_FALSE(values.is_driven(0));
    CHECK(values.of(0, 0).empty());
}
