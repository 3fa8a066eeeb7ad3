// [[contact.pair]]: friction of some of what touches, and what passes through.
#include "analyses/contact/contact_run.hpp"

namespace gxrod::test {
namespace {

constexpr double tilt = 0.25, fall = 9.81;

std::string incline() {
    return fmt::format("gravity = [{:.15g}, 0, {:.15g}]\n", fall * std::sin(tilt), -fall * std::cos(tilt));
}

double find_way(double friction, double time) {
    return 0.5 * fall * (std::sin(tilt) - friction * std::cos(tilt)) * time * time;
}

// Rods next to each other on an incline, along which they slide with friction below tan 0.25 = 0.255.
std::string sliders(const std::string& pairs) {
    std::string deck = incline() + R"(
[section.s]
shape = { circle = { radius = 0.05 } }
material = { E = 1e9, nu = 0.3, density = 1000 }
[obstacle.floor]
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
friction = 0.4
[contact]
each_other = false
self = false
)" + pairs + R"(
[analysis]
kind = "dynamic"
end_time = 0.5
time_step = 0.01
)";
    int y = 0;
    for (const char* name : {"holds", "slides", "falls", "part"}) {
        deck += rod(
            name, fmt::format("0, {}, 0.050979", y).c_str(), fmt::format("1, {}, 0.050979", y).c_str(), 4);
        ++y;
    }
    return deck;
}

// A rod that lies across two held ones on the incline.
std::string crossing(const std::string& pairs) {
    std::string deck = incline() + R"(
[section.s]
shape = { circle = { radius = 0.02 } }
material = { E = 2e9, nu = 0.3, density = 1000 }
[contact]
friction = 0.3
)" + pairs + R"(
[analysis]
kind = "dynamic"
end_time = 0.4
time_step = 0.002
)" + rod("top", "-0.5, 0, 0.0403917", "0.5, 0, 0.0403917", 4);
    for (const auto& [name, x] : {std::pair("r1", "-0.25"), std::pair("r2", "0.25")}) {
        deck += rod(name, fmt::format("{}, -0.1, 0", x).c_str(), fmt::format("{}, 0.1, 0", x).c_str(), 2);
        for (const char* end : {"start", "end"})
            deck += fmt::format("[[support]]\nat = \"{}.{}\"\nfix = \"all\"\n", name, end);
    }
    return deck;
}

std::string pair(const char* a, const char* b, const char* what) {
    return fmt::format("[[contact.pair]]\nbetween = [\"{}\", \"{}\"]\n{}\n", a, b, what);
}

}  // namespace

TEST_CASE("Rods slide on an obstacle, hold or pass through it as their pairs say", "[analyses][touch]") {
    ContactRun run(sliders(pair("*", "floor", "friction = 0.3") + pair("floor", "slides", "friction = 0.2") +
                           pair("falls", "*", "off = true") +
                           pair("part@0.25..0.75", "floor", "friction = 0.1")));
    run.finish();
    CHECK(std::abs(run.at("holds.start").r.x()) < 1e-5);
    CHECK(run.at("slides.start").r.x() == Approx(find_way(0.2, 0.5)).epsilon(1e-4));
    // 0.1 on the middle half, 0.3 on the rest: friction tilts what the floor bears, which does not change the
    // mean.
    CHECK(run.at("part.start").r.x() == Approx(find_way(0.2, 0.5)).epsilon(1e-2));
    const Vec3 fallen = run.at("falls.start").r - Vec3(0, 2, 0.050979);
    CHECK(fallen.x() == Approx(0.5 * fall * std::sin(tilt) * 0.25));
    CHECK(fallen.z() == Approx(-0.5 * fall * std::cos(tilt) * 0.25));
    CHECK(run.least_gap() > 0.0);

    for (const ContactTouch& touch : run.touches()) {
        INFO(touch.rods[0] << " at " << touch.places[0]);
        const double from_middle = std::abs(touch.places[0] - 0.5);
        const bool is_low = from_middle < 0.25;
        const double cone = touch.rods[0] == 1 ? 0.2 : is_low ? 0.1 : 0.3;
        REQUIRE(touch.rods[0] != 2);
        CHECK(touch.slides == (touch.rods[0] != 0));
        if (touch.slides && std::abs(from_middle - 0.25) > 0.01)
            CHECK(touch.friction_force.norm() == Approx(cone * touch.normal_force.norm()));
    }
}

TEST_CASE("The last pair that fits counts", "[analyses][touch]") {
    const std::string slides = pair("slides", "floor", "friction = 0.2");
    ContactRun first(sliders(slides + pair("*", "floor", "friction = 0.3")));
    first.finish();
    CHECK(std::abs(first.at("slides.start").r.x()) < 1e-5);
    // As if there were no exception: with the friction of the floor.
    ContactRun again(sliders(slides + pair("s*s", "f*r", "off = false")));
    again.finish();
    CHECK(std::abs(again.at("slides.start").r.x()) < 1e-5);
}

TEST_CASE("A rod slides on rods with the friction of their pairs", "[analyses][touch]") {
    const double mass = M_PI * 0.02 * 0.02 * 1000.0;
    SECTION("of both") {
        ContactRun run(crossing(pair("top", "r*", "friction = 0.2")));
        run.finish();
        CHECK(run.at("top.start").r.x() + 0.5 == Approx(find_way(0.2, 0.4)).epsilon(5e-3));
        CHECK(run.ledger().contact_loss ==
              Approx(0.2 * mass * fall * std::cos(tilt) * find_way(0.2, 0.4)).epsilon(0.05));
        for (const ContactTouch& touch : run.touches()) CHECK(touch.slides);
    }
    SECTION("of each, and of none with itself") {
        ContactRun run(crossing(pair("r1", "top", "friction = 0") + pair("top", "top", "off = true")));
        run.finish();
        // r2 alone rubs, a radius below the line. By moments it bears (1/4 + s)/(1/2 − 0.3 · 0.02) of the
        // weight after the way s, so that s″ = a − b s.
        const double share = 1.0 / (0.5 - 0.3 * 0.02);
        const double b = 0.3 * share * fall * std::cos(tilt), a = fall * std::sin(tilt) - 0.25 * b;
        const double way = a / b * (1.0 - std::cos(std::sqrt(b) * 0.4));
        CHECK(run.at("top.start").r.x() + 0.5 == Approx(way).epsilon(5e-3));
    }
    SECTION("none: it falls between them") {
        ContactRun run(crossing(pair("top", "r*", "off = true")));
        run.finish();
        CHECK(run.at("top.start").r.z() - 0.0403917 ==
              Approx(-0.5 * fall * std::cos(tilt) * 0.16).epsilon(1e-6));
        CHECK(run.touches().empty());
    }
}

}  // namespace gxrod::test
