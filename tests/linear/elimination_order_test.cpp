#include "linear/fronts/elimination_order.hpp"

#include <algorithm>

#include "solvers/sparse_samples.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr int large = 1000;

// Steps by their number of neighbours, and pairs that are filled in.
std::array<int, 4> count_steps(const EliminationOrder& order) {
    std::array<int, 4> counts{};
    for (const EliminationOrder::Step& step : order.steps) {
        ++counts[std::count_if(step.neighbours.begin(), step.neighbours.end(), [](int n) { return n >= 0; })];
    }
    counts[3] = order.fills;
    return counts;
}

}  // namespace

TEST_CASE("Unknowns of a node are a block", "[linear]") {
    const BlockPartition net(make_net_pattern(3, 2));
    REQUIRE(net.count() == 6);
    CHECK(net.starts == std::vector<std::int64_t>{0, 6, 12, 18, 24, 30, 36});
    const auto neighbours = [&](int block) {
        return std::vector<int>(
            net.neighbours.begin() + static_cast<std::ptrdiff_t>(net.neighbour_starts[block]),
            net.neighbours.begin() + static_cast<std::ptrdiff_t>(net.neighbour_starts[block + 1]));
    };
    CHECK(neighbours(0) == std::vector<int>{1, 3});
    CHECK(neighbours(4) == std::vector<int>{1, 3, 5});
}

TEST_CASE("Unknowns next to each other with the same rows are one block", "[linear]") {
    Eigen::MatrixXd dense = Eigen::MatrixXd::Identity(4, 4);
    dense.topLeftCorner<3, 3>().setOnes();
    dense(2, 3) = dense(3, 2) = 1.0;
    const BlockPartition blocks(make_sparse(dense).pattern);
    CHECK(blocks.starts == std::vector<std::int64_t>{0, 2, 3, 4});
    CHECK(blocks.size(0) == 2);
}

TEST_CASE("A rod is eliminated from its ends, and nothing fills", "[linear]") {
    const BlockPartition rod(make_net_pattern(1, 9));
    const EliminationOrder order(rod, large);
    CHECK(order.kept.empty());
    CHECK(count_steps(order) == std::array<int, 4>{1, 8, 0, 0});
    // From both at the same pace.
    CHECK(order.steps[0].block == 0);
    CHECK(order.steps[1].block == 8);
    CHECK(order.steps[2].block == 1);
}

TEST_CASE("Blocks with three neighbours are kept, and large ones", "[linear]") {
    const BlockPartition net(make_net_pattern(4, 4));
    const EliminationOrder order(net, large);
    CHECK(order.steps.size() == 4);
    CHECK(order.kept.size() == 12);
    CHECK(count_steps(order) == std::array<int, 4>{0, 0, 4, 4});
    CHECK(EliminationOrder(net, 5).kept.size() == 16);
}

TEST_CASE("A ladder of two rungs a bay is eliminated whole", "[linear]") {
    const EliminationOrder order(BlockPartition(make_net_pattern(2, 8)), large);
    CHECK(order.kept.empty());
    CHECK(order.steps.size() == 16);
}
