#include "analyses/static_work.hpp"

#include <cmath>
#include <functional>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// One force along x that moves its node along it, both functions of the load factor.
struct Path {
    std::function<double(double)> force, position;

    LoadStep step(double from, double to) const {
        LoadStep step{{Vec6::Zero()}, {Vec6::Zero()}, to - from};
        step.force_change[0][0] = force(to) - force(from);
        step.movement[0][0] = position(to) - position(from);
        return step;
    }
    StepWork work(double before, double from, double to) const {
        std::vector<Vec6> forces{Vec6::Zero()};
        forces[0][0] = force(from);
        return compute_step_work(forces, step(from, to), before < from ? step(before, from) : LoadStep{});
    }
};

}  // namespace

TEST_CASE("the work of a first load step lies between that of its first and its last force", "[analyses]") {
    // A slack cable: nearly all of the way is made at once.
    const Path slack{[](double t) { return t; }, [](double t) { return std::pow(t, 0.01); }};
    const StepWork work = slack.work(0.0, 0.0, 0.5);
    const double exact = 0.01 / 1.01 * std::pow(0.5, 1.01);
    CHECK(work.work == Approx(0.25 * std::pow(0.5, 0.01)));
    CHECK(std::abs(work.work - exact) < work.uncertainty);
}

TEST_CASE("work along a straight line or a parabola is exact", "[analyses]") {
    const Path line{[](double t) { return 2.0 + 3.0 * t; }, [](double t) { return 5.0 * t; }};
    const StepWork straight = line.work(0.2, 0.5, 0.9);
    CHECK(straight.work == Approx(5.0 * (2.0 * 0.4 + 1.5 * (0.81 - 0.25))));
    CHECK(straight.uncertainty == Approx(0.5 * 1.2 * 2.0));
    const Path parabola{[](double t) { return t; }, [](double t) { return t * t; }};
    const StepWork bent = parabola.work(0.2, 0.5, 0.9);  // ∫ t 2t dt
    CHECK(bent.work == Approx(2.0 / 3.0 * (0.729 - 0.125)));
    CHECK(parabola.work(0.5, 0.5, 0.9).work != Approx(bent.work).epsilon(1e-3));
}

TEST_CASE("a smooth path stays within its bounds, also where its force is largest", "[analyses]") {
    const Path arch{[](double t) { return std::sin(4.0 * t); }, [](double t) { return t + 0.2 * t * t; }};
    // ∫ sin(4t) (1 + 0.4 t) dt
    const auto antiderivative = [](double t) {
        return -std::cos(4.0 * t) / 4.0 + 0.4 * (std::sin(4.0 * t) / 16.0 - t * std::cos(4.0 * t) / 4.0);
    };
    for (const double step : {0.2, 0.1, 0.05}) {
        for (double t = 0.0; t < 1.5; t += step) {
            const StepWork work = arch.work(t > 0.0 ? t - step : t, t, t + step);
            const double exact = antiderivative(t + step) - antiderivative(t);
            INFO("from " << t << " by " << step);
            CHECK(std::abs(work.work - exact) < work.uncertainty);
        }
    }
}
