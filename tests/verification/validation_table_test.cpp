#include "verification/validation_table.hpp"

#include <cmath>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

const Study study{"bend", "A bend", "statics", "by shooting", {}};

StudyResult make_result(std::size_t checks) {
    StudyResult result;
    for (std::size_t i = 0; i < checks; ++i) result.checks.push_back({"load", {2.0}, 0.0, {2.0}, 0.0, 1e-3});
    return result;
}

}  // namespace

TEST_CASE("a line has the vector's worst entry, its error, tolerance and order", "[verification]") {
    StudyResult result;
    result.checks.push_back(
        {"tip, t = 1", {1.0, std::nan(""), 3.0}, 4e-11, {1.25, 100.0, 3.5}, 0.559, 1.0, 1.98});
    const std::string text = describe_checks(study, result, 0.25);
    CHECK_THAT(text, Catch::StartsWith("bend (statics): by shooting. 0.25 s\n  tip, t = 1: z "));
    CHECK_THAT(text, Catch::Contains(" 3 ± 4e-11 "));
    CHECK_THAT(text, Catch::Contains(" 3.5  "));
    CHECK_THAT(text, Catch::Contains(" 5.6e-01   1.0e+00   1.98\n"));
    CHECK_THAT(text, !Catch::Contains("MISSED"));
}

TEST_CASE("of many checks some are listed, and each that failed", "[verification]") {
    StudyResult result = make_result(20);
    CHECK_THAT(describe_checks(study, result, 0.0), Catch::EndsWith("  … and 12 more within tolerance\n"));
    result.checks.push_back({"moment", {2.0}, 0.0, {3.0}, 1.0, 1e-3});
    const std::string text = describe_checks(study, result, 0.0);
    CHECK_THAT(text, Catch::Contains("  moment "));
    CHECK_THAT(text, Catch::Contains("  MISSED\n"));
    CHECK_THAT(describe_checks(study, make_result(8), 0.0), !Catch::Contains("more"));
}

TEST_CASE("columns stand below their names, whatever letters are in them", "[verification]") {
    StudyResult result;
    result.checks.push_back({"max |θ|", {2.0}, 1e-3, {2.0}, 0.0, 1e-3});
    const std::string head = validation_head();
    const std::string text = describe_checks(study, result, 0.0);
    const std::string line = text.substr(text.find('\n') + 1);
    const auto characters = [](const std::string& part) {
        return std::count_if(part.begin(), part.end(), [](char c) { return (c & 0xC0) != 0x80; });
    };
    CHECK(characters(head.substr(0, head.find("gxrod"))) ==
          characters(line.substr(0, line.rfind(" 2  ") + 1)));
    CHECK(characters(head) == characters(line));
}

TEST_CASE("the totals count missed checks", "[verification]") {
    CHECK_THAT(describe_totals({3, 20, 0, 1.5}),
               Catch::EndsWith("3 cases, 20 checks, none missed in 1.5 s\n"));
    CHECK_THAT(describe_totals({3, 20, 2, 1.5}), Catch::EndsWith("3 cases, 20 checks, 2 MISSED in 1.5 s\n"));
}
