#include "laws/trapeze_law.hpp"

#include "laws/law_path.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

// BeamDyn: F = C e + ½ (K44 + K55) κ² axially, (K44 + K55) κ ε of torque, its axes 4 and 5 being those of
// bending.
TEST_CASE("A twisted section pulls as BeamDyn says", "[laws]") {
    const Mat6 C = some_stiffness();
    const TrapezeLaw law(C);
    LawPath path(law);
    const Vec6 strain(0.1, 0.2, 0.3, 0.4, 0.5, 0.6);
    const Vec6 extra = path.go(strain, 1.0).resultants - C * strain;
    const double c = C(4, 4) + C(5, 5);
    CHECK(extra[0] == Approx(0.5 * c * 0.4 * 0.4).epsilon(1e-12));
    CHECK(extra[3] == Approx(c * 0.4 * 0.1).epsilon(1e-12));
    CHECK(extra.segment<2>(1).isZero(1e-14));
    CHECK(extra.tail<2>().isZero(1e-14));
    CHECK(path.now().stored == Approx(0.5 * strain.dot(C * strain) + 0.5 * c * 0.016).epsilon(1e-13));
}

}  // namespace gxrod::test
