#include "report/blocks/step_thinning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

std::vector<float> thin(const std::vector<double>& values, std::size_t group) {
    ColumnThinning column(StepThinning(values.size(), group));
    for (const double value : values) column.add(value);
    return column.values();
}

}  // namespace

TEST_CASE("The least and the largest value of each group stay, in their order", "[report]") {
    const std::vector<double> values{9, 1, 5, 2, 3, 7, 4, 0, -1, 8, 6, 9};
    CHECK(thin(values, 5) == std::vector<float>{9, 1, 7, -1, 8, 9});
    CHECK(StepThinning(values.size(), 5).steps() == std::vector<std::size_t>{0, 1, 5, 6, 10, 11});
    CHECK(thin({0, 3, 2, 1, 0}, 3) == std::vector<float>{0, 3, 1, 0});
}

TEST_CASE("Small groups and few steps keep all", "[report]") {
    const std::vector<double> values{3, 1, 2, 5, 4};
    for (const std::size_t group : {1, 2}) CHECK(thin(values, group) == std::vector<float>{3, 1, 2, 5, 4});
    CHECK(thin({3, 1, 2}, 100) == std::vector<float>{3, 1, 2});
    CHECK(thin({3}, 100) == std::vector<float>{3});
    CHECK(thin({}, 100).empty());
}

TEST_CASE("Thinned columns have the promised count, and the extremes of all values", "[report]") {
    for (const std::size_t steps : {4, 5, 17, 100, 1001, 4096}) {
        std::vector<double> values;
        for (std::size_t i = 0; i < steps; ++i) {
            values.push_back(std::sin(0.7 * static_cast<double>(i)) * static_cast<double>(i % 97));
        }
        for (const std::size_t group : {1, 2, 3, 4, 7, 50, 5000}) {
            const StepThinning thinning(steps, group);
            const std::vector<float> thinned = thin(values, group);
            INFO(steps << " steps in groups of " << group);
            CHECK(thinned.size() == thinning.count());
            const std::vector<std::size_t> kept = thinning.steps();
            CHECK(kept.size() == thinning.count());
            CHECK(std::is_sorted(kept.begin(), kept.end()));
            CHECK(thinned.front() == static_cast<float>(values.front()));
            CHECK(thinned.back() == static_cast<float>(values.back()));
            CHECK(*std::min_element(thinned.begin(), thinned.end()) ==
                  static_cast<float>(*std::min_element(values.begin(), values.end())));
            CHECK(*std::max_element(thinned.begin(), thinned.end()) ==
                  static_cast<float>(*std::max_element(values.begin(), values.end())));
        }
    }
}

TEST_CASE("The group for a count leaves no more than that, and not much less", "[report]") {
    for (const std::size_t steps : {10, 1000, 20001, 1000000}) {
        for (const std::size_t count : {4, 10, 500, 4000}) {
            const StepThinning thinning(steps, StepThinning::group_for(steps, count));
            INFO(steps << " steps, at most " << count);
            CHECK(thinning.count() <= std::max<std::size_t>(count, 4));
            if (count > 100 && steps > 3 * count) CHECK(2 * thinning.count() > count);
        }
    }
    CHECK(StepThinning::group_for(100, 100) == 1);
    CHECK(StepThinning::group_for(0, 0) == 1);
}

TEST_CASE("NaN gives way to numbers", "[report]") {
    const double none = std::numeric_limits<double>::quiet_NaN();
    CHECK(thin({0, none, 2, 1, 0}, 3) == std::vector<float>{0, 2, 1, 0});
    CHECK(thin({0, 2, none, 1, 0}, 3) == std::vector<float>{0, 2, 1, 0});
    CHECK(std::isnan(thin({0, none, none, none, 0}, 3)[1]));
    const std::vector<float> begun_late = thin({none, none, 5, -5, none, 1, 2, 3, 0}, 4);
    CHECK(std::isnan(begun_late[0]));
    CHECK(std::vector<float>(begun_late.begin() + 1, begun_late.end()) == std::vector<float>{5, -5, 1, 3, 0});
}
