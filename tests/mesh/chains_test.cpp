#include "mesh/chains.hpp"

#include <sstream>

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Ends = std::vector<std::array<std::size_t, 2>>;

// "0 1 -2 | 3 o": elements in order, − for reversed, o for closed.
std::string chains_of(const Ends& ends) {
    std::ostringstream text;
    for (const Chain& chain : find_chains(ends)) {
        if (text.tellp() > 0) text << " | ";
        for (const ChainLink& link : chain.links)
            text << (link.is_reversed ? "-" : "+") << link.element << " ";
        text << (chain.is_closed ? "closed" : "open");
    }
    return text.str();
}

}  // namespace

TEST_CASE("One element is a chain", "[mesh]") { CHECK(chains_of({{7, 3}}) == "+0 open"); }

TEST_CASE("Elements in any order and direction become one chain in the direction of the first", "[mesh]") {
    CHECK(chains_of({{0, 1}, {1, 2}, {2, 3}}) == "+0 +1 +2 open");
    CHECK(chains_of({{1, 2}, {3, 2}, {1, 0}}) == "-2 +0 -1 open");
    CHECK(chains_of({{2, 1}, {2, 3}, {0, 1}}) == "-1 +0 -2 open");
}

TEST_CASE("A loop is a closed chain that starts with its first element", "[mesh]") {
    CHECK(chains_of({{5, 6}, {7, 5}, {6, 7}}) == "+0 +2 +1 closed");
    CHECK(chains_of({{5, 6}, {5, 6}}) == "+0 -1 closed");
    CHECK(chains_of({{5, 6}, {6, 5}}) == "+0 +1 closed");
}

TEST_CASE("Chains end at branches, and start at free ends", "[mesh]") {
    // A Y: two arms and a leg, all drawn away from the branch.
    CHECK(chains_of({{0, 1}, {1, 2}, {0, 3}, {0, 4}}) == "-1 -0 open | -2 open | -3 open");
    // A panel with a diagonal between its branches.
    CHECK(chains_of({{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}}) == "+0 +1 open | +2 +3 open | +4 open");
}

TEST_CASE("A loop on a stem starts and ends at the branch", "[mesh]") {
    CHECK(chains_of({{2, 3}, {0, 1}, {1, 2}, {3, 1}}) == "+2 +0 +3 open | +1 open");
}

TEST_CASE("Parts without connection are chains of their own", "[mesh]") {
    CHECK(chains_of({{0, 1}, {5, 6}, {1, 2}}) == "+0 +2 open | +1 open");
}

}  // namespace gxrod::test
