#include "report/script_json.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "tools/catch.hpp"

using namespace gxrod;
using Json = nlohmann::ordered_json;

TEST_CASE("No text in a script's JSON can end the script or begin a tag", "[report]") {
    for (const std::string text : {"</script><script>alert(1)</script>",
                                   "<!-- <script>",
                                   "<img src=x onerror=alert(1)>",
                                   "]]>",
                                   "&lt;/script&gt;",
                                   "\u2028\u2029 é"}) {
        const std::string json = write_script_json({{text, text}});
        INFO(json);
        CHECK(json.find_first_of("<>&") == std::string::npos);
        for (const char c : json) CHECK(static_cast<unsigned char>(c) < 128);
        CHECK(Json::parse(json) == Json{{text, text}});
    }
}

TEST_CASE("What JSON cannot hold is replaced", "[report]") {
    CHECK(write_script_json(Json{{"a", std::numeric_limits<double>::quiet_NaN()}}) == R"({"a":null})");
    CHECK(write_script_json(Json{{"a", "x\xff"}}) == R"({"a":"x\ufffd"})");
}
