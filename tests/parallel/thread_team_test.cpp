#include "parallel/thread_team.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// Until so many threads are at work at the same time; false if they never are.
bool wait_for(const std::atomic<int>& arrived, int count) {
    for (int i = 0; i < 20000; ++i) {
        if (arrived >= count) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

}  // namespace

TEST_CASE("A team does each part of a loop once", "[parallel]") {
    for (const int size : {1, 2, 3, 8}) {
        CAPTURE(size);
        const ThreadTeam team(size);
        CHECK(team.size() == size);
        for (std::size_t count = 0; count < 300; ++count) {
            std::vector<int> times(count, 0);
            team.for_each(count, [&](std::size_t i) { ++times[i]; });
            REQUIRE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
        }
    }
}

TEST_CASE("All threads of a team work at the same time", "[parallel]") {
    constexpr int size = 3;
    const ThreadTeam team(size);
    std::atomic<int> arrived{0};
    std::vector<int> met(size, 0);
    std::vector<std::thread::id> threads(size);
    team.for_each(size, [&](std::size_t i) {
        threads[i] = std::this_thread::get_id();
        ++arrived;
        met[i] = wait_for(arrived, size) ? 1 : 0;
    });
    CHECK(met == std::vector<int>(size, 1));
    CHECK(std::set<std::thread::id>(threads.begin(), threads.end()).size() == size);
}

TEST_CASE("A team wakes up after a pause", "[parallel]") {
    const ThreadTeam team(2);
    for (int loop = 0; loop < 3; ++loop) {
        std::atomic<int> arrived{0};
        std::atomic<int> met{0};
        team.for_each(2, [&](std::size_t) {
            ++arrived;
            if (wait_for(arrived, 2)) ++met;
        });
        CHECK(met == 2);
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
}

TEST_CASE("Ranges of a team are all of it, in order", "[parallel]") {
    for (const int size : {1, 2, 5}) {
        const ThreadTeam team(size);
        for (const std::size_t count : {0, 1, 255, 256, 257, 100000}) {
            CAPTURE(size, count);
            using Range = std::pair<std::size_t, std::size_t>;
            const auto ranges = team.collect<Range>(
                count, [](std::size_t first, std::size_t last) { return Range(first, last); });
            std::size_t next = 0;
            for (const auto& [first, last] : ranges) {
                CHECK(first == next);
                CHECK(last > first);
                next = last;
            }
            CHECK(next == count);
        }
    }
}

TEST_CASE("A team finds the largest", "[parallel]") {
    const ThreadTeam team(3);
    std::vector<double> numbers(5000, 1.0);
    CHECK(team.find_largest(0, [](std::size_t) { return 1.0; }) == 0.0);
    for (const std::size_t place : {0, 1234, 4999}) {
        numbers[place] = static_cast<double>(place + 2);
        CHECK(team.find_largest(numbers.size(), [&](std::size_t i) { return numbers[i]; }) ==
              static_cast<double>(place + 2));
    }
}

TEST_CASE("What one of a team throws is thrown", "[parallel]") {
    const ThreadTeam team(3);
    for (int loop = 0; loop < 100; ++loop) {
        CHECK_THROWS_WITH(team.for_each(50,
                                        [&](std::size_t i) {
                                            if (i == 49) throw std::runtime_error("the last one");
                                        }),
                          "the last one");
        std::atomic<int> done{0};
        team.for_each(50, [&](std::size_t) { ++done; });
        REQUIRE(done == 50);
    }
}
