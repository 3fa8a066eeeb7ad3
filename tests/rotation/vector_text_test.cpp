#include "rotation/vector_text.hpp"

#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("Vectors are written with digits as asked, and without negative zeros", "[rotation]") {
    const Vec3 v(1.0 / 3.0, -0.0, -2e-13);
    CHECK(in_parentheses(v) == "(0.333333, 0, -2e-13)");
    CHECK(in_brackets(v, 3) == "[0.333, 0, -2e-13]");
    CHECK(in_brackets(v, 9, 1e-12) == "[0.333333333, 0, 0]");
}
