#include "parallel/work_phases.hpp"

#include <mutex>
#include <set>

#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;

namespace {

using Items = std::vector<std::vector<int>>;  // the nodes of each

WorkPhases make_phases(const Items& items, std::size_t nodes) {
    return {items.size(), nodes, [&](std::size_t item, const auto& mark) {
                for (const int node : items[item]) mark(node);
            }};
}

// Sums over nodes that depend on the order in which items add to them.
std::vector<double> add_up(const Items& items, std::size_t nodes, int threads) {
    const WorkPhases phases = make_phases(items, nodes);
    const ThreadTeam team(threads);
    std::vector<double> sums(nodes, 0.0);
    std::vector<int> times(items.size(), 0);
    phases.run(team, [&](std::size_t part) {
        for (std::size_t item = phases.first(part); item < phases.last(part); ++item) {
            ++times[item];
            for (const int node : items[item])
                sums[node] = 0.7 * sums[node] + 1.0 / (1.0 + static_cast<double>(item));
        }
    });
    CHECK(times == std::vector<int>(items.size(), 1));
    return sums;
}

}  // namespace

TEST_CASE("Parts of a phase share no node", "[parallel]") {
    Items rod;
    for (int e = 0; e < 1000; ++e) rod.push_back({e, e + 1});
    const WorkPhases phases = make_phases(rod, 1001);
    CHECK(phases.part_count() == 8);
    CHECK(phases.last(7) == 1000);
    CHECK(phases.phase_count() == 2);
    std::vector<std::size_t> parts;
    phases.run(ThreadTeam::alone(), [&](std::size_t part) { parts.push_back(part); });
    CHECK(parts == std::vector<std::size_t>{0, 2, 4, 6, 1, 3, 5, 7});
}

TEST_CASE("Sums in phases are the same for every number of threads", "[parallel]") {
    tools::RandomValues random(4);
    for (const int nodes : {30, 3000}) {
        CAPTURE(nodes);
        Items items(20000);
        for (std::vector<int>& item : items) {
            for (int i = 0; i < 2; ++i) item.push_back(static_cast<int>(random.number(0.0, nodes - 1e-9)));
        }
        const std::vector<double> sums = add_up(items, nodes, 1);
        CHECK(add_up(items, nodes, 2) == sums);
        CHECK(add_up(items, nodes, 5) == sums);
    }
}

TEST_CASE("Parts without a phase of their own come last, one by one", "[parallel]") {
    // All items touch one node: each part is a phase, as long as there are any.
    const Items items(100 * WorkPhases::part_size, {0});
    const WorkPhases phases = make_phases(items, 1);
    CHECK(phases.phase_count() == 64);
    const std::vector<double> sums = add_up(items, 1, 1);
    CHECK(add_up(items, 1, 4) == sums);
}
