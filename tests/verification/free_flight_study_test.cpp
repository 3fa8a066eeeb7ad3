#include "verification/free_flight_study.hpp"

#include <catch2/catch.hpp>

using namespace gxrod;
using namespace gxrod::free_flight;

TEST_CASE("the free flight converges to its reference with the square of mesh and step", "[verification]") {
    for (const Pulse pulse : {Pulse::triangular, Pulse::smooth}) {
        INFO((pulse == Pulse::triangular ? "triangular" : "smooth"));
        const Reference expected = reference(pulse);
        std::vector<double> errors, energies, momenta;
        for (const int elements : {8, 16, 32}) {
            const Flight flight = fly(pulse, Scheme::newmark_simplified, elements, 10L * elements);
            errors.push_back(compute_error(flight, expected));
            energies.push_back(std::abs(flight.energy - expected.energy));
            momenta.push_back((flight.angular_momentum - reference_angular_momentum()).norm());
            // The impulse of the force, which Newmark's γ = ½ integrates by trapezia.
            CHECK((flight.linear_momentum - exact_momentum()).norm() < 1e-10);
        }
        CHECK(std::log2(errors[1] / errors[2]) == Approx(2.0).margin(0.1));
        CHECK(std::log2(energies[1] / energies[2]) == Approx(2.0).margin(0.1));
        // Known of the smooth pulse only.
        if (pulse == Pulse::smooth) CHECK(std::log2(momenta[1] / momenta[2]) == Approx(2.0).margin(0.1));
        // Of tips 10 apart: 0.14 % at 32 elements.
        CHECK(errors[2] < 0.0145);
    }
}

TEST_CASE("sdirk-4 is of order 4 in the step on one mesh of the free flight", "[verification]") {
    constexpr int elements = 16;
    std::vector<Flight> flights;
    for (const long steps : {200L, 400L, 800L}) {
        flights.push_back(fly(Pulse::smooth, Scheme::sdirk_4, elements, steps));
        CHECK((flights.back().linear_momentum - exact_momentum()).norm() < 1e-8);
    }
    const auto compute_order = [&](auto&& pick) {
        return std::log2((pick(flights[0]) - pick(flights[1])).norm() /
                         (pick(flights[1]) - pick(flights[2])).norm());
    };
    CHECK(compute_order([](const Flight& flight) { return flight.loaded; }) == Approx(4.0).margin(0.1));
    CHECK(compute_order([](const Flight& flight) { return flight.angular_momentum; }) ==
          Approx(4.0).margin(0.15));
    for (int i = 0; i < 2; ++i) {
        const double ratio = std::abs(flights[i].energy_error / flights[i + 1].energy_error);
        CHECK(std::log2(ratio) == Approx(4.0).margin(0.2));
    }
}

TEST_CASE("on a coarse mesh simo's interpolation leaves an error of first order in the step",
          "[verification]") {
    // Its test functions T(θ) Σ N_I T(θ_I)⁻¹ δφ_I depend on the rotation since the step began: on three
    // elements that is what is left of the error of sdirk-4.
    std::vector<Flight> flights;
    for (const long steps : {400L, 800L, 1600L}) {
        flights.push_back(fly(Pulse::smooth, Scheme::sdirk_4, 3, steps));
    }
    const double coarse = (flights[0].free - flights[1].free).norm();
    const double fine = (flights[1].free - flights[2].free).norm();
    CHECK(coarse == Approx(5.94e-4).epsilon(0.01));
    CHECK(std::log2(coarse / fine) == Approx(1.0).margin(0.1));
}
