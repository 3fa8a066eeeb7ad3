#include "verification/check.hpp"

#include <cmath>
#include <limits>

#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("a check fails above its tolerance, and where the error is NaN", "[verification]") {
    Check check{"x", {1.0}, 0.0, {1.1}, 0.1, 0.1};
    CHECK(check.passed());
    check.tolerance = 0.09;
    CHECK_FALSE(check.passed());
    check.error = std::numeric_limits<double>::quiet_NaN();
    check.tolerance = 1e300;
    CHECK_FALSE(check.passed());
}

TEST_CASE("an order can fall short by its allowance, and be higher by anything", "[verification]") {
    CHECK(make_order_check("mesh", 2.0, 1.8, 0.3).passed());
    CHECK(make_order_check("mesh", 2.0, 5.0, 0.3).passed());
    CHECK_FALSE(make_order_check("mesh", 2.0, 1.6, 0.3).passed());
    CHECK_FALSE(make_order_check("mesh", 2.0, std::nan(""), 0.3).passed());
    CHECK(make_order_check("mesh", 2.0, 1.6, 0.3).what == "order of the error; mesh");
}

TEST_CASE("a check as JSON", "[verification]") {
    const Check check{"position", {1.0, std::nan("")}, 1e-9, {1.5, 7.0}, 0.5, 0.1, 2.0};
    const nlohmann::ordered_json json = to_json(check);
    CHECK(json["what"] == "position");
    CHECK(json["reference"][0] == 1.0);
    CHECK(json["reference"][1].is_null());  // not compared
    CHECK(json["uncertainty"] == 1e-9);
    CHECK(json["value"][1] == 7.0);
    CHECK(json["error"] == 0.5);
    CHECK(json["tolerance"] == 0.1);
    CHECK(json["order"] == 2.0);
    CHECK(json["passed"] == false);
    CHECK(to_json(Check{"x", {1.0}, 0.0, {1.0}, 0.0, 0.1})["order"].is_null());
}
