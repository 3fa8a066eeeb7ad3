#include "rotation/cross_products.hpp"

#include "rotation/types.hpp"
#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

TEST_CASE("Cross products with columns and rows are products with the cross matrix", "[rotation]") {
    RandomValues random(4);
    const Vec3 a = random.vector();
    const Vec3 b = random.vector();
    const Mat3 B = random.matrix<3>();
    CHECK((cross_matrix(a) * b - a.cross(b)).norm() < 1e-16);
    CHECK((cross_columns(a, B) - cross_matrix(a) * B).norm() < 1e-15);
    CHECK((cross_rows(B, a) - B * cross_matrix(a)).norm() < 1e-15);
}
