#include "analyses/path/path_words.hpp"

#include "tools/catch.hpp"

using namespace gxrod;
using Catch::Contains;

namespace {

CriticalPoint make_point(CriticalKind kind, double load_factor, std::int64_t before, std::int64_t after) {
    CriticalPoint point;
    point.kind = kind;
    point.load_factor = load_factor;
    point.pivots_before = before;
    point.pivots_after = after;
    point.shape = "rod arch, node 12: sideways along x";
    return point;
}

std::string describe(const CriticalPoint& point,
                     bool has_potential = true,
                     const std::vector<BranchStart>& branches = {}) {
    const std::vector<std::string> sentences = describe_critical_points({&point, 1}, branches, has_potential);
    REQUIRE(sentences.size() == 1);
    return sentences[0];
}

}  // namespace

TEST_CASE("limit points are said with what lies beyond", "[analyses]") {
    CHECK(describe(make_point(CriticalKind::limit, 1.854452709444, 0, 1)) ==
          "limit point at λ = 1.854452709: the load factor turns back; in the shape: rod arch, node 12: "
          "sideways along x; the path beyond is unstable (1 negative pivot)");
    CriticalPoint point = make_point(CriticalKind::limit, -0.5, 2, 0);
    point.shape.clear();
    CHECK(describe(point) ==
          "limit point at λ = -0.5: the load factor turns back; the path beyond is stable");
    CHECK(describe(point, false) == "limit point at λ = -0.5: the load factor turns back");
    point.is_located = false;
    point.step = 7;
    CHECK(describe(point) == "limit point within step 7, which ends at λ = -0.5: the path beyond is stable");
}

TEST_CASE("bifurcations are said with their branches", "[analyses]") {
    CriticalPoint point = make_point(CriticalKind::bifurcation, 2.5, 0, 1);
    point.shape.clear();
    point.branching = Branching::supercritical;
    const std::string beyond = "; the path beyond is unstable (1 negative pivot)";
    CHECK(describe(point) ==
          "bifurcation at λ = 2.5: two branches leave (supercritical pitchfork, stable at first)" + beyond);
    point.branching = Branching::subcritical;
    CHECK(describe(point) ==
          "bifurcation at λ = 2.5: two branches leave (subcritical pitchfork, unstable at first)" + beyond);
    point.branching = Branching::transcritical;
    CHECK(describe(point) == "bifurcation at λ = 2.5: another path crosses (transcritical)" + beyond);
    point.branching = Branching::unknown;
    CHECK(describe(point) == "bifurcation at λ = 2.5: no branch was found" + beyond);
    CHECK(describe(point, true, std::vector<BranchStart>(1)) ==
          "bifurcation at λ = 2.5: a branch leaves, to one side only" + beyond);
    point.pivots_before = 1;
    CHECK(describe(point) == "bifurcation at λ = 2.5: the load factor turns back where another path crosses");
}

TEST_CASE("on a path that is unstable on both sides, the branches of a pitchfork are so too", "[analyses]") {
    CriticalPoint point = make_point(CriticalKind::bifurcation, 2.5, 2, 1);
    point.branching = Branching::supercritical;
    CHECK_THAT(describe(point), Contains("supercritical pitchfork, unstable at first"));
}

TEST_CASE("of a double point the dimension of the kernel is said", "[analyses]") {
    CriticalPoint point = make_point(CriticalKind::bifurcation, 0.0569, 0, 2);
    point.multiplicity = 2;
    CHECK(describe(point) ==
          "double bifurcation at λ = 0.0569: which branches leave is not examined; the kernel of the tangent "
          "has dimension 2, one of its shapes: rod arch, node 12: sideways along x; the path beyond is "
          "unstable (2 negative pivots)");
    point.multiplicity = 4;
    CHECK_THAT(describe(point), Contains("4-fold bifurcation"));
}

TEST_CASE("divergence is said without pivots, which count nothing there", "[analyses]") {
    const CriticalPoint point = make_point(CriticalKind::divergence, 9.87, 0, 1);
    CHECK(describe(point, false, std::vector<BranchStart>(2)) ==
          "divergence at λ = 9.87: two branches leave; in the shape: rod arch, node 12: sideways along x");
}
