#include "deck/text/csv_reading.hpp"

#include "deck/text/text_file.hpp"
#include "machine/file_error.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("Rows of CSV have their fields and the line where they begin", "[deck]") {
    const std::vector<CsvRow> rows = read_csv(
        "\xEF\xBB\xBF"
        "a,b\r\n\r\n1,\"x, \"\"y\"\"\"\n\"two\n\nlines\",\n  3 , 4\n5,6",
        "f.csv");
    REQUIRE(rows.size() == 5);
    CHECK(rows[0].fields == Texts{"a", "b"});
    CHECK(rows[0].line == 1);
    CHECK(rows[1].fields == Texts{"1", "x, \"y\""});
    CHECK(rows[1].line == 3);
    CHECK(rows[2].fields == Texts{"two\n\nlines", ""});
    CHECK(rows[2].line == 4);
    CHECK(rows[3].fields == Texts{"3", "4"});
    CHECK(rows[3].line == 7);
    CHECK(rows[4].fields == Texts{"5", "6"});
    CHECK(rows[4].line == 8);
    CHECK(read_csv("", "f.csv").empty());
}

TEST_CASE("A quote out of place is an error with its line", "[deck]") {
    const std::string message =
        ": no CSV: a quote that is out of place (a field with a quote is quoted itself, and the quote "
        "doubled)";
    CHECK_THROWS_WITH(read_csv("a\nb\"c\n", "f.csv"), "f.csv:2" + message);
    CHECK_THROWS_WITH(read_csv("a\n\"b", "f.csv"), "f.csv:3" + message);
}

TEST_CASE("A field that is written is read back", "[deck]") {
    for (const std::string& field :
         Texts{"plain", "", "a,b", "say \"no\"", "two\nlines", " spaced ", "0.5"}) {
        const std::vector<CsvRow> rows = read_csv("x," + write_csv_field(field) + "\n", "f.csv");
        REQUIRE(rows.size() == 1);
        CHECK(rows[0].fields == Texts{"x", field});
    }
}

TEST_CASE("Files that cannot be read are reported", "[deck]") {
    CHECK_THROWS_WITH(read_text_file("/nowhere/x.csv"),
                      "/nowhere/x.csv: cannot be read (No such file or directory)");
    CHECK_THROWS_WITH(read_text_file("/tmp"), "/tmp: is a folder, expected a file");
}

}  // namespace gxrod::test
