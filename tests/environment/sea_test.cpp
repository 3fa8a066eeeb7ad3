#include "environment/sea.hpp"

#include <cmath>

#include "environment/dispersion.hpp"
#include "environment/spectrum.hpp"
#include "environment/splitmix64.hpp"
#include "environment/waves.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

double energy(const std::vector<WaveTrain>& trains) {
    double sum = 0.0;
    for (const WaveTrain& train : trains) sum += 0.5 * train.amplitude * train.amplitude;
    return sum;
}

IrregularSea make_sea() {
    IrregularSea sea;
    sea.significant_height = 4.0;
    sea.peak_period = 10.0;
    return sea;
}

std::vector<double> make_elevations(std::size_t count) {
    Splitmix64 random(11);
    std::vector<double> elevations;
    for (std::size_t i = 0; i < count; ++i) {
        elevations.push_back(0.3 + std::sin(0.7 * static_cast<double>(i)) + random.next_fraction());
    }
    return elevations;
}

}  // namespace

TEST_CASE("The generator is splitmix64", "[environment]") {
    // The values of S. Vigna's C source, which an implementation in Python gives too.
    Splitmix64 random(1234567);
    CHECK(random.next() == 6457827717110365317U);
    CHECK(random.next() == 3203168211198807973U);
    CHECK(random.next() == 9817491932198370423U);
    CHECK(random.next() == 4593380528125082431U);
    CHECK(random.next() == 16408922859458223821U);
    CHECK(Splitmix64(1).next_fraction() == 0x1.22145bd91204bp-1);
}

TEST_CASE("A seed is one sea, by an independent computation", "[environment]") {
    // By mpmath with 30 digits: generator, shares of the spectrum by its adaptive quadrature, bisection.
    IrregularSea sea = make_sea();
    sea.components = 20;
    sea.seed = 7;
    sea.spreading = 10.0;
    sea.direction = 0.25;
    const std::vector<WaveTrain> trains = make_irregular_sea(sea, {30.0, 9.81});
    REQUIRE(trains.size() == 20);
    CHECK(trains[0].frequency == Approx(0.48507329648521276).epsilon(1e-14));
    CHECK(trains[0].phase == Approx(0.10548396551191393).epsilon(1e-15));
    CHECK(trains[0].direction == Approx(0.25 + 0.564076369654723).epsilon(1e-13));
    CHECK(trains[10].frequency == Approx(0.67731343317729812).epsilon(1e-14));
    CHECK(trains[10].phase == Approx(0.3408016465196029).epsilon(1e-15));
    CHECK(trains[10].direction == Approx(0.25 - 0.131183122305615).epsilon(1e-13));
    CHECK(trains[19].frequency == Approx(1.3780882340588312).epsilon(1e-14));
    CHECK(trains[19].phase == Approx(3.5850936168421394).epsilon(1e-15));
    CHECK(trains[19].direction == Approx(0.25 + 0.13055852803725).epsilon(1e-13));
    CHECK(trains[3].number == find_wave_number(trains[3].frequency, 30.0, 9.81));
}

TEST_CASE("A sea has the energy Hs²/16, evenly in its trains", "[environment]") {
    for (const int components : {1, 50, 200}) {
        IrregularSea sea = make_sea();
        sea.components = components;
        const std::vector<WaveTrain> trains = make_irregular_sea(sea, {});
        CHECK(energy(trains) == Approx(1.0).epsilon(1e-14));
        for (const WaveTrain& train : trains) CHECK(train.amplitude == trains.front().amplitude);
        CHECK(measure_sea(trains).significant_height == Approx(4.0).epsilon(1e-14));
    }
}

TEST_CASE("Each band of a sea's spectrum has one train", "[environment]") {
    const IrregularSea sea = make_sea();
    const JonswapSpectrum spectrum(4.0, 10.0, 3.3);
    const std::vector<WaveTrain> trains = make_irregular_sea(sea, {});
    const double covered = spectrum.share_below(5.0 * spectrum.peak_frequency());
    for (std::size_t i = 0; i < trains.size(); ++i) {
        const double place = spectrum.share_below(trains[i].frequency) / covered * 200.0;
        CHECK(place > static_cast<double>(i) - 1e-9);
        CHECK(place < static_cast<double>(i) + 1.0 + 1e-9);
        CHECK(trains[i].direction == 0.0);
    }
    CHECK(trains.back().frequency < 5.0 * spectrum.peak_frequency());
    // The cut takes 1.3e-3 of the energy, from high frequencies.
    CHECK(measure_sea(trains).mean_period == Approx(spectrum.mean_period()).epsilon(0.01));
    IrregularSea other = sea;
    other.seed = 2;
    CHECK(make_irregular_sea(other, {})[5].phase != trains[5].phase);
}

TEST_CASE("Directions spread as the power of the cosine of half the angle", "[environment]") {
    IrregularSea sea = make_sea();
    sea.components = 4000;
    sea.spreading = 5.0;
    sea.direction = 1.0;
    double cosine = 0.0, sine = 0.0;
    for (const WaveTrain& train : make_irregular_sea(sea, {})) {
        cosine += std::cos(train.direction - 1.0) / 4000.0;
        sine += std::sin(train.direction - 1.0) / 4000.0;
    }
    // Their mean is s/(s + 1); 4000 draws scatter by a hundredth.
    CHECK(cosine == Approx(5.0 / 6.0).margin(0.01));
    CHECK(sine == Approx(0.0).margin(0.03));
}

TEST_CASE("A sea from a record gives the record back", "[environment]") {
    for (const std::size_t count : {16U, 17U, 240U, 601U}) {
        INFO(count);
        ElevationRecord record;
        record.start = -3.0;
        record.time_step = 0.25;
        record.elevations = make_elevations(count);
        record.x = 20.0;
        record.y = -7.0;
        record.direction = 0.4;
        Water water;
        water.depth = 30.0;
        water.waves = make_recorded_sea(record, {30.0, 9.81});
        double mean = 0.0;
        for (const double elevation : record.elevations) mean += elevation / static_cast<double>(count);
        Waves waves(water, find_wave_kernels(InstructionSet::baseline));
        for (std::size_t i = 0; i < count; ++i) {
            waves.move_to(-3.0 + 0.25 * static_cast<double>(i));
            CHECK(waves.at({20, -7, 0}).surface.elevation + mean ==
                  Approx(record.elevations[i]).margin(2e-12));
        }
        // And again after its length.
        waves.move_to(-3.0 + 0.25 * static_cast<double>(count + 3));
        CHECK(waves.at({20, -7, 0}).surface.elevation + mean == Approx(record.elevations[3]).margin(2e-12));
    }
}

TEST_CASE("A record can be cut to frequencies", "[environment]") {
    ElevationRecord record;
    record.time_step = 0.5;
    record.elevations = make_elevations(100);
    const double first = 2.0 * M_PI / 50.0;
    record.lowest_frequency = 2.5 * first;
    record.highest_frequency = 7.5 * first;
    const std::vector<WaveTrain> trains = make_recorded_sea(record, {});
    REQUIRE(trains.size() == 5);
    CHECK(trains.front().frequency == Approx(3.0 * first).epsilon(1e-15));
    CHECK(trains.back().frequency == Approx(7.0 * first).epsilon(1e-15));
    record.elevations.assign(100, 2.0);
    CHECK(make_recorded_sea(record, {}).empty());
}

TEST_CASE("Times of a record have equal steps", "[environment]") {
    CHECK(find_time_step({1.0, 1.25, 1.5, 1.75}) == 0.25);
    CHECK(find_time_step({0.0, 0.1000001, 0.2}) == Approx(0.1));
    CHECK_THROWS_WITH(find_time_step({0, 1, 2, 4}), Contains("from 0 to 1 it is 1"));
    CHECK_THROWS_WITH(find_time_step({0, 0, 0}), Contains("must increase"));
    CHECK_THROWS_WITH(find_time_step({0}), Contains("two times"));
    CHECK_THROWS_WITH(find_time_step({2, 1, 0}), Contains("must increase"));
}

TEST_CASE("A sea is measured by its moments", "[environment]") {
    const SeaMeasures measures = measure_sea({{1.0, 1.0, 0.1, 0, 0}, {2.0, 3.0, 0.5, 0, 0}});
    CHECK(measures.significant_height == Approx(4.0 * std::sqrt(2.5)).epsilon(1e-15));
    CHECK(measures.mean_period == Approx(2.0 * M_PI * 2.5 / 6.5).epsilon(1e-15));
    CHECK(measures.zero_crossing_period == Approx(2.0 * M_PI * std::sqrt(2.5 / 18.5)).epsilon(1e-15));
    CHECK(measures.steepness == Approx(4.0 * std::sqrt(2.5) * 1.05 / 2.5 / (2.0 * M_PI)).epsilon(1e-15));
    CHECK(measure_sea({}).significant_height == 0.0);
}

}  // namespace gxrod::test
