#include "study/method_traits.hpp"

#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("the order of a scheme, which Newmark's have with gamma = 1/2 alone", "[study]") {
    DynamicSettings settings;
    settings.end_time = 1.0;
    settings.steps = 10;
    for (const auto& [scheme, order] : {std::pair{Scheme::newmark_simplified, 2.0},
                                        {Scheme::newmark_ibrahimbegovic, 2.0},
                                        {Scheme::generalized_alpha, 2.0},
                                        {Scheme::sdirk_4, 4.0},
                                        {Scheme::runge_kutta_4, 4.0}}) {
        settings.scheme = scheme;
        CHECK(order_of(settings) == order);
    }
    settings.gamma = 0.6;
    CHECK(order_of(settings) == 4.0);
    settings.scheme = Scheme::generalized_alpha;
    CHECK(order_of(settings) == 2.0);
    settings.scheme = Scheme::newmark_simplified;
    CHECK(order_of(settings) == 1.0);
    CHECK(order_of(StaticSettings{}) == 1.0);
}

TEST_CASE("runs are compared where steps end, and of steps by their error at even times", "[study]") {
    DynamicSettings settings;
    settings.end_time = 2.0;
    settings.steps = 4;
    CHECK(choose_times(settings) == std::vector<double>{0.0, 0.5, 1.0, 1.5, 2.0});
    settings.adaptive = AdaptiveSettings{};
    const std::vector<double> times = choose_times(settings);
    CHECK(times.size() == 1001);
    CHECK(times[500] == 1.0);
    CHECK(times.back() == 2.0);
}
