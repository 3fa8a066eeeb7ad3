#include "check/summaries/memory_estimate.hpp"

#include <string>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

double megabytes_of(int elements, int order, double results_bytes = 0.0) {
    const std::string deck =
        test::replaced(test::rod_deck,
                       "elements = 10",
                       "elements = " + std::to_string(elements) + "\norder = " + std::to_string(order));
    return estimate_memory(test::read(deck).model, results_bytes) / 1e6;
}

}  // namespace

// What runs were seen to have at most (VmHWM): 24 MB of 10 elements, of 20,000 and 100,000 of order 1 and of
// 5,000 and 25,000 of order 4; and of a million steps with a file of 237 MB, ten million with one of 2.5 GB.
TEST_CASE("The memory of a run is known before within a third", "[check]") {
    CHECK(megabytes_of(10, 1) == Approx(24.3).epsilon(0.33));
    CHECK(megabytes_of(20000, 1) == Approx(113.9).epsilon(0.1));
    CHECK(megabytes_of(100000, 1) == Approx(432.7).epsilon(0.1));
    CHECK(megabytes_of(5000, 4) == Approx(137.7).epsilon(0.1));
    CHECK(megabytes_of(25000, 4) == Approx(561.0).epsilon(0.1));
    CHECK(megabytes_of(1, 1, 237e6) == Approx(52.4).epsilon(0.33));
    CHECK(megabytes_of(1, 1, 2.5e9) == Approx(60.0).epsilon(0.1));
}
