#include "machine/printable.hpp"

#include "tools/catch.hpp"

using namespace gxrod;

TEST_CASE("A message holds nothing that a terminal would obey", "[machine]") {
    CHECK(printable("plain ½ αβ \\ \"text\"") == "plain ½ αβ \\ \"text\"");
    CHECK(printable("a\x1b[31mb\nc\td\re\x7f") == "a\\x1b[31mb\\nc\\td\\re\\x7f");
    CHECK(printable("\xC2\x9B"
                    "31m") == "\\x9b31m");
    CHECK(printable(std::string("a\0b", 3)) == "a\\x00b");
}

TEST_CASE("A message is UTF-8, whatever it quotes", "[machine]") {
    CHECK(printable("a\xD6 b") == "a\\xd6 b");
    CHECK(printable("\xC2") == "\\xc2");
    CHECK(printable("\xE2\x82") == "\\xe2\\x82");
    CHECK(printable("\xC0\xAF \xE0\x9F\xBF \xF0\x8F\xBF\xBF") ==
          "\\xc0\\xaf \\xe0\\x9f\\xbf \\xf0\\x8f\\xbf\\xbf");  // longer than need be
    CHECK(printable("\xED\xA0\x80 \xF4\x90\x80\x80") == "\\xed\\xa0\\x80 \\xf4\\x90\\x80\\x80");  // none
    const std::string ends =
        "\x7E \xC3\x80 \xDF\xBF \xE0\xA0\x80 \xED\x9F\xBF \xEE\x80\x80 \xEF\xBF\xBF \xF0\x90\x80\x80 "
        "\xF4\x8F\xBF\xBF";
    CHECK(printable(ends) == ends);
}

TEST_CASE("Control characters are found; layout is not one", "[machine]") {
    CHECK(find_control_character("two\nlines,\ta tab\r\n") == std::string_view::npos);
    CHECK(find_control_character("½\x1b") == 2);
    CHECK(find_control_character("a\xC2\x85") == 1);
}

TEST_CASE("A long text is quoted by its beginning", "[machine]") {
    CHECK(shorten("short") == "short");
    CHECK(shorten(std::string(200, 'x')) == std::string(200, 'x'));
    CHECK(shorten(std::string(201, 'x')) == std::string(200, 'x') + "…");
    CHECK(shorten(std::string(199, 'x') + "½½") == std::string(199, 'x') + "…");
}
