#include "deck/schema/suggestion.hpp"

#include "tools/catch.hpp"

namespace gxrod {

TEST_CASE("The edit distance counts single mistakes", "[deck]") {
    CHECK(edit_distance("section", "section") == 0);
    CHECK(edit_distance("SECTION", "section") == 0);
    CHECK(edit_distance("sectio", "section") == 1);
    CHECK(edit_distance("sectionn", "section") == 1);
    CHECK(edit_distance("sektion", "section") == 1);
    CHECK(edit_distance("setcion", "section") == 1);
    CHECK(edit_distance("", "abc") == 3);
    CHECK(edit_distance("abc", "") == 3);
    CHECK(edit_distance("kitten", "sitting") == 3);
}

TEST_CASE("The nearest spelling is near", "[deck]") {
    const std::vector<std::string> words{"velocity", "angular_velocity", "mass"};
    CHECK(nearest_spelling("velocty", words) == "velocity");
    CHECK(nearest_spelling("angular_velocty", words) == "angular_velocity");
    CHECK(nearest_spelling("MASS", words) == "mass");
    CHECK(nearest_spelling("colour", words).empty());
    CHECK(nearest_spelling("", words).empty());
    CHECK(nearest_spelling("x", {"y"}).empty());
    CHECK(did_you_mean("mas", words) == R"(; did you mean "mass"?)");
    CHECK(did_you_mean("colour", words).empty());
}

TEST_CASE("Lists are written with commas", "[deck]") {
    CHECK(quoted_list({"a", "b"}) == R"("a", "b")");
    CHECK(plain_list({"a", "b", "c"}) == "a, b, c");
    CHECK(plain_list({}).empty());
}

}  // namespace gxrod
