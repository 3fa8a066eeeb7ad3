#include "model/printable.hpp"

#include <catch2/catch.hpp>

using namespace gxrod;

TEST_CASE("A message holds nothing that a terminal would obey", "[model]") {
    CHECK(printable("plain ½ αβ \\ \"text\"") == "plain ½ αβ \\ \"text\"");
    CHECK(printable("a\x1b[31mb\nc\td\re\x7f") == "a\\x1b[31mb\\nc\\td\\re\\x7f");
    CHECK(printable("\xC2\x9B"
                    "31m") == "\\x9b31m");
    CHECK(printable(std::string("a\0b", 3)) == "a\\x00b");
    CHECK(printable("\xC2") == "\xC2");
}

TEST_CASE("Control characters are found, layout is none", "[model]") {
    CHECK(find_control_character("two\nlines,\ta tab\r\n") == std::string_view::npos);
    CHECK(find_control_character("½\x1b") == 2);
    CHECK(find_control_character("a\xC2\x85") == 1);
}

TEST_CASE("A long text is quoted by its beginning", "[model]") {
    CHECK(shorten("short") == "short");
    CHECK(shorten(std::string(200, 'x')) == std::string(200, 'x'));
    CHECK(shorten(std::string(201, 'x')) == std::string(200, 'x') + "…");
    CHECK(shorten(std::string(199, 'x') + "½½") == std::string(199, 'x') + "…");
}
