#include "deck/places/name_pattern.hpp"

#include "tools/catch.hpp"

TEST_CASE("A * in a pattern stands for any letters, or none", "[deck]") {
    using gxrod::matches_pattern;
    for (const char* pattern : {"wire-12", "*", "wire*", "*12", "w*-*2", "wire-12*", "**w**2", "*-1*"}) {
        INFO(pattern);
        CHECK(matches_pattern("wire-12", pattern));
    }
    for (const char* pattern :
         {"", "wire", "wire-1", "wire-123", "ire*", "*13", "w*x*2", "*wire", "Wire*", "?*"}) {
        INFO(pattern);
        CHECK_FALSE(matches_pattern("wire-12", pattern));
    }
    CHECK(matches_pattern("aaaab", "*ab"));
    CHECK(matches_pattern("abcabd", "*abd"));
    CHECK(matches_pattern("", "*"));
}
