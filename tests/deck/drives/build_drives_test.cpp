#include <cmath>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

std::string with(const std::string& lines) { return rod_deck + lines; }

const std::string tendon = "[tendon.pull]\non = \"r\"\ntension = 3\n";

Tendon read_tendon(const std::string& lines) { return read(with(tendon + lines)).model.tendons.at(0); }

bool has_node_at(const Model& model, double s) {
    for (std::size_t i = 0; i < model.rods[0].arc_length.size(); i += 2) {
        if (std::abs(model.rods[0].arc_length[i] - s) < 1e-9) return true;
    }
    return false;
}

// Two stages, of statics and in time.
const std::string stages = R"([[stage]]
name = "pull"
kind = "static"
[[stage]]
name = "swing"
kind = "dynamic"
end_time = 2.0
steps = 10
)";

std::string with_stages(const std::string& lines) {
    return rod_deck.substr(0, rod_deck.find("[analysis]")) + lines + stages;
}

}  // namespace

TEST_CASE("A tendon has its path by functions, with an exact slope", "[deck]") {
    const Tendon helix = read_tendon("offset = [\"0.1*cos(3*s)\", \"0.1*sin(3*s) + s/(10.5 - s)\"]\n");
    CHECK(helix.rod == 0);
    CHECK(helix.from == 0.0);
    CHECK(helix.to == 10.0);
    CHECK(helix.tension(0.5) == 3.0);
    for (const double s : {1e-3, 0.3, 2.0, 7.7, 9.99}) {
        const TendonPlace place = helix.path(s);
        const double rest = 10.5 - s;
        const Vec3 at(0.0, 0.1 * std::cos(3.0 * s), 0.1 * std::sin(3.0 * s) + s / rest);
        const Vec3 slope(0.0, -0.3 * std::sin(3.0 * s), 0.3 * std::cos(3.0 * s) + 10.5 / (rest * rest));
        CHECK((place.at - at).norm() < 1e-14 * at.norm());
        CHECK((place.slope - slope).norm() < 2e-11 * slope.norm());
    }
    const Tendon straight = read_tendon("offset = [0.25, \"-s/20\"]\n");
    CHECK(straight.path(4.0).at == Vec3(0.0, 0.25, -0.2));
    CHECK((straight.path(4.0).slope - Vec3(0.0, 0.0, -0.05)).norm() < 1e-13);
}

TEST_CASE("The slope of a path is found where it turns often and near its ends", "[deck]") {
    const Tendon tight = read_tendon("offset = [\"cos(40*pi*s/10)\", \"sqrt(s*(10 - s))\"]\n");
    const double k = 4.0 * std::acos(-1.0);
    for (const double s : {0.02, 0.9, 5.3, 9.98}) {
        const Vec3 slope(0.0, -k * std::sin(k * s), (5.0 - s) / std::sqrt(s * (10.0 - s)));
        CHECK((tight.path(s).slope - slope).norm() < 1e-8 * slope.norm());
    }
}

TEST_CASE("A tendon by rows is straight between them, with a node at each", "[deck]") {
    const Problem problem = read(with(tendon + "offset = [[0.11, 0, 1], [0.35, 2, 1], [0.95, 2, -1]]\n"));
    const Tendon& by_rows = problem.model.tendons[0];
    CHECK(by_rows.from == Approx(1.1));
    CHECK(by_rows.to == Approx(9.5));
    for (const double s : {1.1, 3.5, 9.5}) CHECK(has_node_at(problem.model, s));
    CHECK((by_rows.path(2.3).at - Vec3(0.0, 1.0, 1.0)).norm() < 1e-14);
    CHECK((by_rows.path(2.3).slope - Vec3(0.0, 2.0 / 2.4, 0.0)).norm() < 1e-14);
    CHECK((by_rows.path(6.5).at - Vec3(0.0, 2.0, 0.0)).norm() < 1e-14);
    CHECK((by_rows.path(6.5).slope - Vec3(0.0, 0.0, -2.0 / 6.0)).norm() < 1e-14);
}

TEST_CASE("A node is placed where a tendon starts and ends", "[deck]") {
    const Problem problem = read(with(tendon + "offset = [0, 1]\nfrom = 0.123\nto = 0.777\n"));
    CHECK(has_node_at(problem.model, 1.23));
    CHECK(has_node_at(problem.model, 7.77));
    CHECK(problem.model.rods[0].element_count() == 10);
    CHECK(problem.model.tendons[0].from == Approx(1.23));
}

TEST_CASE("Heat is taken up by the expansion of sections", "[deck]") {
    const std::string heat =
        "[[actuation]]\non = \"r\"\ntemperature = \"20*t + s\"\ntemperature_gradient = [1, \"s\"]\n";
    const std::string expanding = replaced(rod_deck, "[rod.r]", "expansion = \"1e-5*(1 + s)\"\n[rod.r]");
    const Model model = read(expanding + heat).model;
    CHECK(model.rods[0].varying.at_forces.at(3).expansion == Approx(4.5e-5));
    CHECK(model.actuations.at(0).temperature(2.0, 3.0) == 43.0);
    CHECK(model.actuations[0].temperature_gradient[1](0.0, 3.0) == 3.0);
    CHECK_THAT(faults_of(with(heat)),
               Contains("x.toml:15") && Contains("actuation[0].temperature") && Contains("has no expansion"));
}

TEST_CASE("Values from inside act in stages as loads do", "[deck]") {
    const Problem problem = read(with_stages(R"([tendon.pull]
on = "r"
offset = [0, 0.1]
tension = 4
factor = { swing = "1 + t" }
[[actuation]]
on = "r"
stretch = "s"
[[actuation]]
on = "r"
shear = [1, 2]
stages = "swing"
[[magnetic]]
on = "r"
moment = ["1 + s", 0, 0]
field = [0, 7, "x*t"]
)"));
    const Model& first = problem.model;
    const Actions& second = problem.stages.at(1).actions;
    // In statics values without t grow, and stay.
    CHECK(first.actuations.at(0).strain[0](0.25, 8.0) == 2.0);
    CHECK(second.actuations.at(0).strain[0](0.25, 8.0) == 8.0);
    CHECK(first.actuations.size() == 1);
    REQUIRE(second.actuations.size() == 2);
    CHECK(second.actuations[1].strain[2](0.0, 0.0) == 2.0);
    // A tendon that is not yet pulled is there.
    CHECK(first.tendons.at(0).tension(1.0) == 0.0);
    CHECK(second.tendons.at(0).tension(0.5) == 6.0);
    // The field grows, the moment does not.
    const DistributedLoad& grown = first.distributed_loads.at(0);
    REQUIRE(grown.field);
    CHECK(grown.frame == Frame::body);
    CHECK(grown.moment[0](0.25, 2.0) == 3.0);
    CHECK(grown.field->at(0.5, Vec3(3.0, 0.0, 0.0)) == Vec3(0.0, 3.5, 1.5));
    CHECK(second.distributed_loads.at(0).field->at(0.5, Vec3(3.0, 0.0, 0.0)) == Vec3(0.0, 7.0, 1.5));
}

TEST_CASE("A tendon with a winch has no tension of its own, and lets go in stages that do not name it",
          "[deck]") {
    const std::string drawn = "[tendon.pull]\non = \"r\"\noffset = [0, 0.1]\n";
    const Problem problem = read(with_stages(drawn + "shortening = 4\nstages = \"pull\"\n"));
    const Tendon& first = problem.model.tendons.at(0);
    REQUIRE(first.winch);
    CHECK(first.winch->pulls_only);
    CHECK(first.winch->stiffness == 0.0);
    CHECK(first.winch->shortening(0.25) == 1.0);
    CHECK_FALSE(first.winch->is_released);
    CHECK(first.tension.is_zero());
    CHECK(problem.stages.at(1).actions.tendons.at(0).winch->is_released);
    // A length without t is reached from the one at the start, and stays.
    const Problem by_length = read(with_stages(drawn + "length = 9\n"));
    CHECK((*by_length.model.tendons.at(0).winch->length)(0.25) == 9.0);
    CHECK(by_length.model.tendons[0].winch->share(0.25) == 0.25);
    CHECK(by_length.stages.at(1).actions.tendons.at(0).winch->share(0.25) == 1.0);
    CHECK(read(with_stages(drawn + "length = \"10 - t\"\n")).model.tendons.at(0).winch->share(0.25) == 1.0);
    CHECK_FALSE(read_tendon("offset = [0, 1]\n").winch);
}

TEST_CASE("A field that is the same everywhere needs no place", "[deck]") {
    const Model model =
        read(with("[[magnetic]]\non = \"r\"\nmoment = [1, 0, 0]\nfield = [\"t\", 2, 0]\n")).model;
    CHECK_FALSE(model.distributed_loads.at(0).field->by_place);
}

TEST_CASE("What is wrong with drives is said where it stands", "[deck]") {
    const auto faults = [](const std::string& lines) { return faults_of(with(lines)); };
    CHECK_THAT(faults("[tendon.pull]\non = \"q\"\noffset = [0, 1]\ntension = 1\n"),
               Contains("x.toml:14") && Contains("tendon.pull.on") && Contains("no rod \"q\""));
    CHECK_THAT(faults(tendon + "offset = [0, 1]\nfrom = 0.5\nto = 0.5\n"),
               Contains("x.toml:18") && Contains("expected from < to"));
    CHECK_THAT(faults(tendon + "offset = [[0, 0, 1], [0.5, 0, 1]]\nto = 0.4\n"),
               Contains("tendon.pull.to") && Contains("goes with functions"));
    CHECK_THAT(faults(tendon + "offset = [[0, 0, 1], [0, 0, 1]]\n"),
               Contains("tendon.pull.offset[1]") && Contains("fractions must increase"));
    CHECK_THAT(faults(tendon + "offset = [[0, 0, 1], [1, 0]]\n"),
               Contains("tendon.pull.offset[1]") && Contains("a row [fraction, y, z]"));
    CHECK_THAT(faults(tendon + "offset = [[0, 0, 1]]\n"), Contains("rows [fraction, y, z], two at least"));
    CHECK_THAT(faults(tendon + "offset = [0, 1, 2]\n"),
               Contains("an array of 2 numbers or expressions in s"));
    CHECK_THAT(faults(tendon + "offset = [0, \"t\"]\n"),
               Contains("tendon.pull.offset") && Contains("not allowed here"));
    CHECK_THAT(faults(tendon + "offset = [0, \"log(s - 5)\"]\n"),
               Contains("x.toml:16") && Contains("tendon.pull.offset[1]") && Contains("at s = "));
    CHECK_THAT(faults(tendon), Contains("tendon.pull.offset: missing"));
    CHECK_THAT(faults("[tendon.r]\non = \"r\"\noffset = [0, 1]\ntension = 1\n"),
               Contains("has this name too"));
    CHECK_THAT(faults(tendon + "offset = [0, 1]\nstages = \"one\"\n"),
               Contains("tendon.pull.stages") && Contains("no stage \"one\""));
    CHECK_THAT(faults("[tendon.pull]\non = \"r\"\noffset = [0, 1]\ntension = \"1/(t - 0.5)\"\n"),
               Contains("tendon.pull.tension") && Contains("is inf at t = 0.5"));
    const std::string drawn = "[tendon.pull]\non = \"r\"\noffset = [0, 1]\n";
    CHECK_THAT(faults(drawn), Contains("expected tension or shortening or length"));
    CHECK_THAT(faults(tendon + "offset = [0, 1]\nshortening = 0\n"), Contains("tendon.pull"));
    CHECK_THAT(faults(tendon + "offset = [0, 1]\nstiffness = 1\n"),
               Contains("tendon.pull.stiffness") && Contains("goes with shortening or length"));
    CHECK_THAT(faults(drawn + "length = 9\nfactor = 2\n"),
               Contains("tendon.pull.factor") && Contains("expected shortening"));
    CHECK_THAT(faults(drawn + "shortening = 1\n"),
               Contains("tendon.pull.shortening") && Contains("expected 0 there"));
    CHECK_THAT(faults(drawn + "shortening = \"t < 0.5 ? 0 : 1\"\n"), Contains("jumps from 0 to 1"));
    CHECK(faults(drawn + "shortening = 1\nstiffness = 5\n") == "");
    CHECK_THAT(faults(drawn + "shortening = \"1/(t - 0.5)\"\nstiffness = 5\n"),
               Contains("tendon.pull.shortening") && Contains("is inf at t = 0.5"));
    const auto explicit_faults = [&](const std::string& lines) {
        return faults_of(replaced(rod_deck, "steps = 10", "steps = 10\nintegrator = \"runge-kutta-4\"") +
                         drawn + lines);
    };
    CHECK_THAT(explicit_faults("shortening = 0\n"),
               Contains("tendon.pull") && Contains("expected a stiffness, or slack = false"));
    CHECK(explicit_faults("shortening = 0\nstiffness = 5\n") == "");
    CHECK(explicit_faults("shortening = 0\nslack = false\n") == "");
    const auto history = [&](const std::string& at, const std::string& quantity) {
        return faults(tendon + "offset = [0, 1]\n[[history]]\nname = \"h\"\nat = \"" + at +
                      "\"\nquantities = [\"" + quantity + "\"]\n");
    };
    CHECK(history("pull", "tendon_length") == "");
    CHECK_THAT(history("pull", "position"),
               Contains("a tendon has tendon_length, tendon_tension and tendon_end_tension only"));
    CHECK_THAT(history("pull", "contact_force"),
               Contains("a tendon has tendon_length, tendon_tension and tendon_end_tension only"));
    CHECK(history("pull", "tendon_end_tension") == "");
    CHECK_THAT(history("r.end", "tendon_tension"), Contains("only tendons have it"));
    CHECK_THAT(faults("[[actuation]]\non = \"r\"\n"), Contains("actuation[0]: missing; expected stretch or"));
    CHECK_THAT(faults("[[actuation]]\non = \"r\"\ncurvature = [0, 0, \"1/(s - 5)\"]\n"),
               Contains("x.toml:15") && Contains("actuation[0].curvature[2]") && Contains("s = 5"));
    CHECK_THAT(faults("[[actuation]]\non = \"r\"\nstretch = \"1/(s - 5)\"\n"),
               Contains("actuation[0].stretch") && Contains("s = 5"));
    CHECK_THAT(faults("[[actuation]]\non = \"r\"\nshear = [1]\n"), Contains("an array of 2 numbers"));
    CHECK_THAT(faults("[[magnetic]]\non = \"r\"\nmoment = [1, 0, 0]\nfield = [0, 0, \"vx\"]\n"),
               Contains("magnetic[0].field[2]") && Contains("vx"));
    CHECK_THAT(faults("[[magnetic]]\non = \"r\"\nfield = [0, 0, 1]\n"),
               Contains("magnetic[0].moment: missing"));
    CHECK_THAT(faults("[[magnetic]]\non = \"r\"\nmoment = [1, 0, 0]\nfield = [0, 0, \"1/(t - 0.5)\"]\n"),
               Contains("magnetic[0].field[2]") && Contains("is inf at t = 0.5"));
}

TEST_CASE("Keys of friction that a tendon cannot have are faults", "[deck]") {
    const auto faults = [](const std::string& lines) { return faults_of(with(lines + "offset = [0, 1]\n")); };
    CHECK(faults(tendon + "friction = 0.2\npulled_at = \"to\"\nstiffness = 7\n") == "");
    CHECK(faults(tendon + "friction = 0\n") == "");
    CHECK_THAT(faults(tendon + "friction = -0.1\n"),
               Contains("x.toml:16") && Contains("tendon.pull.friction") && Contains("at least 0"));
    CHECK_THAT(faults(tendon + "mu = 0.1\n"), Contains("tendon.pull.mu") && Contains("friction"));
    CHECK_THAT(faults(tendon + "friction = 0.1\npulled_at = \"start\"\n"),
               Contains("tendon.pull.pulled_at") && Contains("\"from\"") && Contains("\"to\""));
    CHECK_THAT(faults(tendon + "pulled_at = \"to\"\n"),
               Contains("tendon.pull.pulled_at") && Contains("goes with friction"));
    CHECK_THAT(faults(tendon + "friction = 0.1\nslack = false\n"), Contains("tendon.pull.slack"));
    CHECK_THAT(faults("[tendon.pull]\non = \"r\"\nshortening = 0\nfriction = 0.1\n"),
               Contains("tendon.pull.friction") && Contains("goes with a tension"));
    const std::string pushed = "[tendon.pull]\non = \"r\"\nfriction = 0.1\ntension = ";
    CHECK_THAT(
        faults(pushed + "-3\n"),
        Contains("tendon.pull.tension") && Contains("is -3 at t = 0; ") && Contains("expected at least 0"));
    CHECK_THAT(faults(pushed + "\"1 - 2*t\"\n"), Contains("is -1 at t = 1; "));
    CHECK_THAT(faults(pushed + "3\nfactor = -1\n"), Contains("is -3 at t = 0; "));
    CHECK(faults(pushed + "\"sin(pi*t)\"\n") == "");  // but for round-off at its end
}

TEST_CASE("A tendon that asks for more nodes than there are elements says so", "[deck]") {
    std::string rows = "offset = [[0, 0, 1]";
    for (int i = 1; i <= 12; ++i) rows += ", [" + std::to_string(i / 12.0) + ", 0, 1]";
    CHECK_THAT(faults_of(with(tendon + rows + "]\n")), Contains("expected at least 12"));
}

}  // namespace gxrod::test
