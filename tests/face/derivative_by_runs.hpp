#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "face/gxrod.hpp"
#include "tools/catch.hpp"

// Derivatives that a simulation carries along, and differences of whole runs.
namespace gxrod::test {

// Returns the derivative by a number of a deck that a whole run carries along to its end.
inline std::vector<double> carry_along(const Deck& deck,
                                       const std::string& number,
                                       const std::string& history,
                                       const std::string& quantity) {
    std::vector<VariedNumber> variations;
    variations.push_back(vary(deck, number));
    Simulation run(deck.build(), {.sensitivities = std::move(variations)});
    run.run();
    return run[history].derivative(number)[quantity].numbers();
}

inline std::vector<double> find_end(const Deck& deck,
                                    const std::string& number,
                                    double value,
                                    const std::string& history,
                                    const std::string& quantity) {
    Simulation run(Deck(deck).set("parameters." + number, value).build());
    run.run();
    return run[history][quantity].numbers();
}

// Returns differences of whole runs with two sizes of steps, extrapolated; the larger one is a part of the
// number.
inline std::vector<double> take_differences(const Deck& deck,
                                            const std::string& number,
                                            double value,
                                            const std::string& history,
                                            const std::string& quantity,
                                            double part = 1e-3) {
    const auto difference = [&](double h) {
        std::vector<double> high = find_end(deck, number, value + h, history, quantity);
        const std::vector<double> low = find_end(deck, number, value - h, history, quantity);
        for (std::size_t i = 0; i < high.size(); ++i) high[i] = (high[i] - low[i]) / (2.0 * h);
        return high;
    };
    const double h = part * std::abs(value);
    std::vector<double> fine = difference(0.5 * h);
    const std::vector<double> coarse = difference(h);
    for (std::size_t i = 0; i < fine.size(); ++i) fine[i] = (4.0 * fine[i] - coarse[i]) / 3.0;
    return fine;
}

// Checks that both are close, relative to the largest number.
inline void require_close(const std::vector<double>& derivative,
                          const std::vector<double>& expected,
                          double tolerance) {
    REQUIRE(derivative.size() == expected.size());
    double largest = 0.0, distance = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        largest = std::max(largest, std::abs(expected[i]));
        distance = std::max(distance, std::abs(derivative[i] - expected[i]));
    }
    CAPTURE(derivative, expected);
    CHECK(largest > 0.0);
    CHECK(distance < tolerance * largest);
}

}  // namespace gxrod::test
