#include <cmath>
#include <fstream>
#include <sstream>

#include "analyses/dynamic.hpp"
#include "deck/decks.hpp"
#include "model/evaluation_error.hpp"
#include "tools/catch.hpp"
#include "tools/mechanism_decks.hpp"
#include "tools/recorded_motion.hpp"

// Mechanisms whose motion is known: rigid ones from recursive Newton-Euler equations and from redundant
// bodies with projected multipliers, both integrated by DOP853 to 1e-13; rods from shooting and spectral
// elements.
using namespace gxrod;
using Catch::Contains;
using namespace gxrod::tools;

namespace {

using Row = RecordedMotion::Row;

// The text of a deck of the examples, or of the tests' own.
std::string read_deck(const std::string& name) {
    std::ifstream file(find_mechanism_deck(name));
    std::ostringstream text;
    text << file.rdbuf();
    REQUIRE(!text.str().empty());
    return text.str();
}

using Motion = RecordedMotion;

double distance(const Row& a, const Row& b) {
    REQUIRE(a.size() == b.size());
    double square = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(square);
}

struct SchemeOrder {
    std::string scheme;
    double least_ratio;  // of errors when steps are halved
    int steps;
};

const std::vector<SchemeOrder> schemes{{"newmark-simplified", 3.6, 100},
                                       {"newmark-ibrahimbegovic", 3.6, 100},
                                       {"generalized-alpha", 3.6, 100},
                                       {"sdirk-4", 12.0, 50},
                                       {"runge-kutta-4", 12.0, 100}};

std::vector<std::string> with(const SchemeOrder& scheme, int refinement) {
    std::vector<std::string> overrides{
        "analysis.integrator=\"" + scheme.scheme + "\"",
        "analysis.end_time=1.0",
        "analysis.time_step=" + std::to_string(1.0 / (scheme.steps * refinement))};
    if (scheme.scheme != "runge-kutta-4") overrides.push_back("analysis.newton.tolerance=1e-12");
    return overrides;
}

}  // namespace

TEST_CASE("Chains of bars on hinges move at the order of every scheme, forces included",
          "[analyses][joints]") {
    struct Chain {
        std::string deck;
        Row tip, shoulder, force;
    };
    const std::vector<Chain> chains{{"double_pendulum",
                                     {-1.66211513582, -1.04146663719, 0.0},
                                     {-2.778512564986},
                                     {18.7389221008, 8.9534291851, 0.0}},
                                    {"triple_pendulum",
                                     {-1.48509771171, -2.60627447494, .01344364582},
                                     {-2.081781941849},
                                     {34.7557129365, 72.9096448026, -2.9101869418}}};
    for (const Chain& chain : chains) {
        for (const SchemeOrder& scheme : schemes) {
            INFO(chain.deck << ", " << scheme.scheme);
            const auto errors = [&](int refinement) {
                const Motion motion(read_deck(chain.deck), with(scheme, refinement));
                return Row{distance(motion.at(1.0, "tip/position"), chain.tip),
                           distance(motion.at(1.0, "shoulder/angle"), chain.shoulder),
                           distance(motion.at(1.0, "shoulder/force"), chain.force)};
            };
            const Row coarse = errors(1);
            const Row fine = errors(2);
            for (std::size_t i = 0; i < coarse.size(); ++i) CHECK(coarse[i] > scheme.least_ratio * fine[i]);
            CHECK(fine[0] < 1e-3);
        }
    }
}

// IFToMM's library of benchmarks, after Haug.
TEST_CASE("A spatial slider-crank turns as two independent programs have it", "[analyses][joints]") {
    const Motion motion(
        read_deck("spatial_slider_crank"),
        {"analysis.integrator=\"sdirk-4\"", "analysis.time_step=0.0025", "analysis.newton.tolerance=1e-13"});
    const std::vector<std::array<double, 3>> reference{{.1, .551866774634, .2263597501652},
                                                       {.2, 1.230383231216, .2605214773272},
                                                       {.5, 5.299639570424, .1877293203432},
                                                       {1., 10.564933385735, .2295123714226}};
    for (const auto& [time, turn, x] : reference) {
        INFO(time);
        CHECK(motion.at(time, "shaft/angle")[0] == Approx(turn).epsilon(0).margin(5e-7));
        CHECK(motion.at(time, "slider/position")[0] == Approx(x).epsilon(0).margin(2e-8));
    }
    CHECK(motion.at(.5, "shaft/angle_rate")[0] == Approx(13.18079149751).epsilon(3e-7));
    CHECK(distance(motion.at(.5, "pin/force"), {18.111334502, -18.551144255, -12.561423752}) < 1e-4);
    CHECK(distance(motion.at(.5, "shaft/force"), {18.111334502, -18.551144255, -11.384223752}) < 1e-4);
    const Row guide = motion.at(.5, "guide/force");
    CHECK(guide[1] == Approx(14.078286164).epsilon(1e-5));
    CHECK(guide[2] == Approx(37.535537444).epsilon(1e-5));
    CHECK(motion.largest("/histories/shaft/gap") < 1e-13);
    CHECK(motion.largest("/ledger/energy_error") < 1e-6);
}

// Thirty equations, one of which follows from the others (IFToMM A04).
TEST_CASE("Bricard's mechanism moves although one equation is redundant", "[analyses][joints]") {
    const Motion motion(
        read_deck("bricard"),
        {"analysis.integrator=\"sdirk-4\"", "analysis.time_step=0.005", "analysis.newton.tolerance=1e-12"});
    CHECK(distance(motion.at(1., "p3/position"), {.510501461149, -1.649167599409, .140123114530}) < 2e-7);
    CHECK(distance(motion.at(2., "p3/position"), {-.969340344778, -1.221246894956, .754278010780}) < 4e-7);
    CHECK(motion.at(2., "p0/angle")[0] == Approx(2.893328205981).epsilon(0).margin(4e-7));
    CHECK(motion.largest("/histories/p0/gap") < 1e-12);
    const Motion simple(read_deck("bricard"), {"analysis.end_time=0.5"});
    CHECK(distance(simple.at(.5, "p3/position"), {.968283679100, -1.224625159458, .750146609411}) < 1e-3);
}

TEST_CASE("A gyroscope in gimbals turns its rings", "[analyses][joints]") {
    const Motion motion(read_deck("gimbals"),
                        {"analysis.integrator=\"sdirk-4\"",
                         "analysis.end_time=1.0",
                         "analysis.time_step=0.002",
                         "analysis.newton.tolerance=1e-12"});
    CHECK(motion.at(1., "column/angle")[0] == Approx(1.000976591610).epsilon(0).margin(1e-6));
    // The trunnion's turn is counted from the start, .3 from the outer ring's plane.
    CHECK(motion.at(1., "trunnion/angle")[0] + .3 == Approx(.289191946090).epsilon(0).margin(1e-6));
    CHECK(motion.at(1., "bearing/angle")[0] == Approx(99.762396080509).epsilon(0).margin(1e-5));
    CHECK(distance(motion.at(1., "column/force"), {.9344698743, 4.0914500435, 29.0234156591}) < 1e-3);
    CHECK(distance(motion.at(1., "column/moment"), {.3020953601, -.1935568039, 0}) < 1e-3);
}

// Through a position where they could as well fold up; 35 equations of rank 29.
TEST_CASE("Two four-bars pass through their toggle position", "[analyses][joints]") {
    const Motion motion(
        read_deck("double_four_bar"),
        {"analysis.end_time=1.0", "analysis.time_step=0.005", "analysis.newton.tolerance=1e-12"});
    CHECK(distance(motion.at(.5, "top/position"), {.6952866331644, .71873256343574, 0}) < 1e-3);
    CHECK(distance(motion.at(1., "top/position"), {-.19502030194944, -.98079920566217, 0}) < 2e-3);
}

// Fifty equations of rank 41 (Schiehlen, Multibody Systems Handbook, 1990).
TEST_CASE("Andrews' squeezer is driven by a moment against a spring", "[analyses][joints]") {
    const Motion motion(
        read_deck("squeezer"),
        {"analysis.integrator=\"sdirk-4\"", "analysis.time_step=1e-4", "analysis.newton.tolerance=1e-12"});
    CHECK(motion.at(.03, "O/angle")[0] == Approx(15.8724850852).epsilon(1e-6));
    CHECK(distance(motion.at(.03, "F/position"), {-.0349216183953, -.0022408410821, 0}) < 1e-7);
    CHECK(motion.at(.03, "O/angle_rate")[0] == Approx(1139.92030226).epsilon(1e-5));
}

TEST_CASE("Beams on hinges bend as shooting has it", "[analyses][joints]") {
    SECTION("a Gerber beam") {
        const Motion light(read_deck("gerber_beam"), {"parameters.P=1"});
        CHECK(distance(light.at(1., "hinge/position"), {.984273955724, -.161229179099, 0}) < 1e-9);
        CHECK(distance(light.at(1., "load/position"), {1.480536454695, -.100930472047, 0}) < 1e-9);
        CHECK(light.at(1., "jump/angle")[0] == Approx(.343415684249).epsilon(1e-9));
        CHECK(light.at(1., "roller/reaction_force")[1] == Approx(.503365459035).epsilon(1e-9));
        CHECK(light.at(1., "roller/position")[0] == Approx(1.970163015181).epsilon(1e-9));
        CHECK(light.at(1., "clamp/moment_spatial")[2] == Approx(-.488824444185).epsilon(1e-7));
        const Motion heavy(read_deck("gerber_beam"), {"parameters.P=4"});
        CHECK(distance(heavy.at(1., "hinge/position"), {.855532290515, -.470493121348, 0}) < 1e-8);
        CHECK(heavy.at(1., "jump/angle")[0] == Approx(1.020591534395).epsilon(1e-8));
        CHECK(heavy.at(1., "roller/position")[0] == Approx(1.723980092974).epsilon(1e-8));
    }
    SECTION("an arch of three hinges") {
        const Motion arch(read_deck("three_hinged_arch"));
        CHECK(distance(arch.at(1., "load/displacement"), {.010128883161, -.010041428296, 0}) < 1e-9);
        CHECK(distance(arch.at(1., "crown/displacement"), {.007324358031, .002451488538, 0}) < 1e-9);
        CHECK(arch.at(1., "jump/angle")[0] == Approx(-.021250583516).epsilon(0).margin(1e-9));
        const Row foot = arch.at(1., "foot/force_spatial");
        CHECK(foot[0] == Approx(-.371153228800).epsilon(1e-6));
        CHECK(foot[1] == Approx(-.782827221175).epsilon(1e-6));
    }
    SECTION("a frame in space") {
        const Motion frame(read_deck("hinged_frame"));
        CHECK(distance(frame.at(1., "hinge/position"), {.96130517605, .03693643322, -.24979870201}) < 1e-8);
        CHECK(frame.at(1., "jump/angle")[0] == Approx(-.04190717815).epsilon(0).margin(1e-8));
        CHECK(distance(frame.at(1., "clamp/force_spatial"), {.02806732441, .20974498209, -.82868640648}) <
              1e-6);
        CHECK(distance(frame.at(1., "clamp/moment_spatial"), {.11249976301, .77567588492, .18167765768}) <
              1e-6);
    }
    SECTION("a sprung hinge") {
        const Motion sprung(read_deck("sprung_hinge"));
        CHECK(distance(sprung.at(1., "hinge/position"), {.489336264967, -.091212341236, 0}) < 1e-9);
        CHECK(sprung.at(1., "jump/angle")[0] == Approx(-.206040888107).epsilon(1e-9));
        CHECK(distance(sprung.at(1., "tip/position"), {.901418041181, -.374032658428, 0}) < 1e-9);
        CHECK(sprung.at(1., "jump/moment")[2] == Approx(2 * .206040888107).epsilon(1e-9));
    }
    SECTION("a hinge with a bushing") {
        const std::string bushing =
            "\n[bushing.spring]\nbetween = [\"first.end\", \"second.start\"]\nstiffness = { rz = \"k\" }";
        const Motion sprung(
            test::replaced(read_deck("sprung_hinge"), "spring = { stiffness = \"k\" }", bushing));
        CHECK(distance(sprung.at(1., "hinge/position"), {.489336264967, -.091212341236, 0}) < 1e-9);
        CHECK(sprung.at(1., "jump/angle")[0] == Approx(-.206040888107).epsilon(1e-9));
        CHECK(distance(sprung.at(1., "tip/position"), {.901418041181, -.374032658428, 0}) < 1e-9);
        CHECK(std::abs(sprung.at(1., "jump/moment")[2]) < 1e-9);
    }
    SECTION("a four-bar linkage whose hinge is askew") {
        const Motion linkage(read_deck("askew_four_bar"));
        CHECK(distance(linkage.at(1., "C/position"), {.317111150851, .091898029287, -.002374130366}) < 1e-8);
        CHECK(distance(linkage.at(1., "A/moment_spatial"), {10.139495594, 60.497559892, 3.815632349}) < 1e-4);
        CHECK(distance(linkage.at(1., "A/force_spatial"), {-29.27821060, 15.89846812, -280.54380717}) < 1e-3);
    }
}

TEST_CASE("Rods on joints move as spectral elements have it", "[analyses][joints]") {
    SECTION("on an oblique hinge") {
        const Motion rods(
            read_deck("two_rods_on_oblique_hinge"),
            {"analysis.integrator=\"sdirk-4\"", "analysis.end_time=1.0", "analysis.time_step=0.005"});
        CHECK(distance(rods.at(1., "hinge/position"), {.6085388, -.7973633, .0297739}) < 1e-5);
        CHECK(distance(rods.at(1., "tip/position"), {1.5379640, -1.1625638, -.0522997}) < 1e-5);
        CHECK(rods.at(1., "jump/angle")[0] == Approx(.456851).epsilon(0).margin(2e-5));
    }
    SECTION("on balls") {
        const Motion chain(
            read_deck("rubber_chain"),
            {"analysis.integrator=\"sdirk-4\"", "analysis.end_time=0.3", "analysis.time_step=1e-3"});
        CHECK(distance(chain.at(.3, "end1/position"), {.0700182, -.1867994, .0187706}) < 1e-6);
        CHECK(distance(chain.at(.3, "end2/position"), {.1427486, -.3721596, .0392964}) < 1e-6);
        CHECK(distance(chain.at(.3, "end3/position"), {.3112763, -.4756377, .0676624}) < 1e-6);
    }
}

namespace {

// A flywheel with the moment of inertia 0.5 about the z axis.
std::string flywheel(const std::string& rate, const std::string& laws, const std::string& analysis) {
    return "[body.wheel]\nmass = 1\ninertia = [1, 1, 0.5]\nangular_velocity = [0, 0, " + rate +
           "]\n[joint.axle]\ntype = \"hinge\"\nbetween = [\"ground\", \"wheel\"]\naxis = [0, 0, 1]\n" + laws +
           "[analysis]\nkind = \"dynamic\"\n" + analysis +
           "[[history]]\nname = \"axle\"\nat = \"axle\"\nquantities = [\"angle\", \"angle_rate\", "
           "\"moment\"" +
           (laws.find("friction") == 0 ? ", \"friction\"" : "") +
           (laws.find("move") == 0 ? ", \"drive\"" : "") + "]\n";
}

}  // namespace

TEST_CASE("Springs, friction and motors act on turns of any number", "[analyses][joints]") {
    const std::string fine =
        "integrator = \"sdirk-4\"\nend_time = 2\ntime_step = 0.01\nnewton = { tolerance = 1e-12 }\n";
    SECTION("a clock spring") {
        // Wound up by 20 rad: θ = 20 cos 4t − 20.
        const Motion free(flywheel("0", "spring = { stiffness = 8, rest = -20 }\n", fine));
        CHECK(free.at(1., "axle/angle")[0] == Approx(-13.072872417272238 - 20).epsilon(0).margin(1e-4));
        CHECK(free.largest("/ledger/energy_error") < 1e-3);
        const Motion damped(flywheel("0", "spring = { stiffness = 8, damping = 0.4, rest = -20 }\n", fine));
        CHECK(damped.at(2., "axle/angle")[0] == Approx(20 * -.002596842616620 - 20).epsilon(0).margin(1e-4));
        CHECK(damped.largest("/ledger/energy_error") < 1e-3);
    }
    SECTION("friction brings it to a stop, and holds it") {
        const Motion wheel(flywheel("20", "friction = { moment = 2 }\n", "end_time = 6\ntime_step = 0.01\n"));
        CHECK(wheel.at(4., "axle/angle_rate")[0] == Approx(4.).epsilon(1e-6));
        CHECK(wheel.at(6., "axle/angle")[0] == Approx(50.).epsilon(1e-4));
        CHECK(wheel.at(4., "axle/friction")[0] == Approx(-2.).epsilon(1e-12));
        CHECK(wheel.largest("/ledger/energy_error") < 0.05);
    }
    SECTION("a motor") {
        const Motion wheel(flywheel("0", "move = \"1.5*t^2\"\n", fine));
        CHECK(wheel.at(2., "axle/angle")[0] == Approx(6.).epsilon(1e-12));
        CHECK(wheel.at(2., "axle/drive")[0] == Approx(1.5).epsilon(1e-8));
        CHECK(wheel.at(2., "axle/moment")[2] == Approx(1.5).epsilon(1e-8));
        CHECK(wheel.largest("/ledger/energy_error") < 3e-8);
        CHECK(wheel.largest("/ledger/external_work") == Approx(.25 * 36).epsilon(1e-7));
    }
    SECTION("a drive") {
        const Motion wheel(flywheel("0", "drive = 1.5\n", fine));
        CHECK(wheel.at(2., "axle/angle")[0] == Approx(6.).epsilon(1e-9));
        CHECK(wheel.largest("/ledger/energy_error") < 1e-7);
    }
    SECTION("a limit") {
        // It goes in and comes out with the same speed, like half a vibration at √(k/J) = 20 rad/s.
        const Motion wheel(flywheel("1", "limits = { upper = 0, stiffness = 200 }\n", fine));
        CHECK(wheel.at(.05, "axle/angle")[0] == Approx(std::sin(1.) / 20).epsilon(1e-4));
        CHECK(wheel.at(2., "axle/angle_rate")[0] == Approx(-1.).epsilon(1e-3));
    }
}

TEST_CASE("A nut runs down a screw, masses whirl on a rod", "[analyses][joints]") {
    const std::string ending = "[analysis]\nkind = \"dynamic\"\nend_time = 1\ntime_step = 0.05\n";
    SECTION("screw") {
        const Motion nut(
            "gravity = [0, 0, -9.81]\n[body.nut]\nmass = 2\ninertia = [0.01, 0.01, 0.003]\n"
            "[joint.thread]\ntype = \"screw\"\nbetween = [\"ground\", \"nut\"]\naxis = [0, 0, 1]\nlead = "
            "0.02\n" +
            ending +
            "[[history]]\nname = \"nut\"\nat = \"thread\"\nquantities = [\"angle\", \"slide\", \"force\", "
            "\"moment\", \"angle_rate\"]\n");
        CHECK(nut.at(1., "nut/slide")[0] == Approx(-.5 * .065819460393173).epsilon(1e-9));
        CHECK(nut.at(1., "nut/angle_rate")[0] == Approx(-20.677793323444).epsilon(1e-9));
        CHECK(nut.at(1., "nut/force")[2] == Approx(19.488361079214).epsilon(1e-9));
        CHECK(nut.at(1., "nut/moment")[2] == Approx(-.06203337997).epsilon(1e-8));
    }
    SECTION("distance") {
        const Motion whirl(
            "[body.light]\nmass = 1\ninertia = [1, 1, 1]\nvelocity = [0, 7.5, 0]\nat = [1.5, 0, 0]\n"
            "[body.heavy]\nmass = 3\ninertia = [1, 1, 1]\nvelocity = [0, -2.5, 0]\nat = [-0.5, 0, 0]\n"
            "[joint.rod]\ntype = \"distance\"\nbetween = [\"light\", \"heavy\"]\n"
            "[analysis]\nkind = \"dynamic\"\nintegrator = \"sdirk-4\"\nend_time = 1\ntime_step = 0.005\n"
            "[[history]]\nname = \"rod\"\nat = \"rod\"\nquantities = [\"force\", \"gap\"]\n"
            "[[history]]\nname = \"light\"\nat = \"light\"\nquantities = [\"position\"]\n");
        CHECK(distance(whirl.at(1., "light/position"), {1.5 * std::cos(5.), 1.5 * std::sin(5.), 0}) < 1e-6);
        // The light one, A, pulls the heavy one towards it.
        CHECK(distance(whirl.at(1., "rod/force"), {37.5 * std::cos(5.), 37.5 * std::sin(5.), 0}) < 1e-4);
    }
}

TEST_CASE("A stage begins where the one before leaves its motors", "[analyses][joints]") {
    const auto stages = [](const std::string& move) {
        return "[body.wheel]\nmass = 1\ninertia = [1, 1, 0.5]\n"
               "[joint.axle]\ntype = \"hinge\"\nbetween = [\"ground\", \"wheel\"]\naxis = [0, 0, 1]\n" +
               move +
               "[[stage]]\nname = \"turn\"\nkind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\n"
               "[[stage]]\nname = \"hold\"\nkind = \"dynamic\"\nend_time = 1\ntime_step = 0.1\n";
    };
    // Each stage has its own t.
    const RunSummary summary = run_problem(test::read(stages("move = \"t^2\"\n")));
    CHECK(summary.status != RunStatus::complete);
    CHECK_THAT(summary.reason, Contains("joint axle begins with a jump of 1 "));
}

// Initial velocities that joints do not allow.
namespace {

const std::string two_bodies = R"([body.a]
mass = 1
inertia = [1, 1, 1]
velocity = [0, 1, 0]
[body.b]
mass = 1
inertia = [1, 1, 1]
at = [1, 0, 0]
[joint.knee]
type = "hinge"
between = ["a", "b"]
at = [0.5, 0, 0]
axis = [0, 0, 1]
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.01
)";

}  // namespace

TEST_CASE("Velocities that do not fit a joint are refused, and the nearest ones named",
          "[analyses][joints]") {
    const Problem problem = test::read(two_bodies);
    DynamicAnalysis analysis(problem.model, test::dynamic_of(problem));
    CHECK_THROWS_AS(analysis.start(), EvaluationError);
    // The least change of kinetic energy: b's node moves with 0.4 and turns back with 0.2.
    CHECK_THROWS_WITH(DynamicAnalysis(problem.model, test::dynamic_of(problem)).start(),
                      Contains("do not fit joint knee") && Contains("velocity = [0, 0.4, 0]") &&
                          Contains("angular_velocity = [0, 0, -0.2] at b"));
}

TEST_CASE("The nearest velocities are taken where the deck says so", "[analyses][joints]") {
    const Problem problem = test::read(two_bodies, {"analysis.start=\"project\""});
    DynamicAnalysis analysis(problem.model, test::dynamic_of(problem));
    REQUIRE(analysis.start().converged());
    const NodeMotion& a = analysis.state().previous[0];
    const NodeMotion& b = analysis.state().previous[1];
    // Momentum stays, and the joint's point moves as one.
    CHECK((a.v + b.v - Vec3(0, 1, 0)).norm() < 1e-12);
    CHECK((a.v + a.omega.cross(Vec3(0.5, 0, 0)) - b.v - b.omega.cross(Vec3(-0.5, 0, 0))).norm() < 1e-12);
    CHECK(b.v.y() == Approx(0.4));
}
