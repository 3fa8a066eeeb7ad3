#include "study/trace_sampler.hpp"

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

double cubic(double t) { return 1.0 + t * (2.0 - t * (3.0 - 0.5 * t)); }

}  // namespace

TEST_CASE("where a step ends at a sample, the row itself is taken", "[study]") {
    const std::vector<double> times{0.0, 0.5, 1.0};
    TraceSampler sampler(times, 1.0);
    sampler.add(0.0, {{1.0, 2.0, 3.0, 4.0}});
    sampler.add(0.25, {{9.0, 9.0, 9.0, 9.0}});
    sampler.add(0.5 + 1e-13, {{5.0, 6.0, 7.0, 8.0}});
    REQUIRE(sampler.samples().size() == 2);
    CHECK(sampler.samples()[0][0] == HistoryRow{1.0, 2.0, 3.0, 4.0});
    CHECK(sampler.samples()[1][0] == HistoryRow{5.0, 6.0, 7.0, 8.0});
}

TEST_CASE("between steps a cubic is met exactly", "[study]") {
    const std::vector<double> times{0.0, 0.61, 0.62, 0.95, 1.0};
    TraceSampler sampler(times, 1.0);
    for (const double t : {0.0, 0.1, 0.35, 0.6, 0.7, 1.0}) sampler.add(t, {{cubic(t), 0.0, -cubic(t), 1.0}});
    REQUIRE(sampler.samples().size() == times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
        CHECK(sampler.samples()[i][0][0] == Approx(cubic(times[i])));
        CHECK(sampler.samples()[i][0][2] == Approx(-cubic(times[i])));
        CHECK(sampler.samples()[i][0][3] == Approx(1.0));
    }
}

TEST_CASE("a run that ends early has the samples it reached", "[study]") {
    const std::vector<double> times{0.0, 0.5, 1.0};
    TraceSampler sampler(times, 1.0);
    sampler.add(0.0, {{0.0, 0.0, 0.0, 0.0}});
    sampler.add(0.7, {{0.7, 0.0, 0.0, 0.0}});
    REQUIRE(sampler.samples().size() == 2);
    CHECK(sampler.samples()[1][0][0] == Approx(0.5));
}
