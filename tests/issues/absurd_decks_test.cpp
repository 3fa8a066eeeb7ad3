#include <fmt/format.h>

#include "deck/checks/check_memory.hpp"
#include "deck/decks.hpp"
#include "deck/reading/validation.hpp"
#include "tools/catch.hpp"

// Decks that are too deep, too slow to evaluate, too large or not to be shown.

namespace gxrod::test {
namespace {

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

std::string loaded_by(const std::string& expression) {
    return body_deck + "[[load]]\nat = \"top\"\nforce = [\"" + expression + "\", 0, 0]\n";
}

// f0 calls f1 so many times, which calls f2 …
std::string function_chain(int length, int calls) {
    std::string text;
    for (int i = 0; i < length; ++i) {
        const std::string call = "f" + std::to_string(i + 1) + "(t)";
        text += "[function.f" + std::to_string(i) + "]\nexpression = \"" + call +
                repeated("+" + call, calls - 1) + "\"\n";
    }
    return text + "[function.f" + std::to_string(length) + "]\nexpression = \"t\"\n";
}

}  // namespace

TEST_CASE("Keys of many parts are refused before they are followed", "[issues]") {
    const std::string message = "x.toml:8:1: a key of 100000 parts, where a.b.c has 3; 16 are the most";
    CHECK(faults_of(body_deck + repeated("a.", 99999) + "a = 1\n") == message);
    CHECK(faults_of(body_deck + "[" + repeated("\"a\" . ", 99999) + "a]\n") == message);
    // Numbers, sentences and rulers have dots, too.
    CHECK(faults_of("# One. Two words. " + repeated("More words. ", 50) + "\n# " + repeated(".", 99) + "\n" +
                    body_deck) == "");
    CHECK(faults_of(body_deck + "[parameters]\na = \"" + repeated("0.5 + ", 40) + "0.5\"\n") == "");
}

TEST_CASE("Texts that a terminal would obey are refused", "[issues]") {
    CHECK(faults_of("title = \"a\\u001b[31mred\"\n" + body_deck) ==
          "x.toml:1:9: has the control character \\x1b; expected a text that can be shown");
    CHECK(faults_of("title = \"a\\u009b31m\"\n" + body_deck) ==
          "x.toml:1:9: has the control character \\x9b; expected a text that can be shown");
    CHECK(faults_of(body_deck + "[parameters]\n\"a\\u0007\" = 1\n") ==
          "x.toml:9:1: has the control character \\x07; expected a text that can be shown");
    CHECK(faults_of("title = \"\"\"two\nlines\"\"\"\nunits = \"m\\tkg\"\n" + body_deck) == "");
    // Where there is no text yet, the message shows it.
    CHECK(faults_of("title = a\x1b[31m\n" + body_deck).find('\x1b') == std::string::npos);
}

TEST_CASE("Expressions that would take too long are refused", "[issues]") {
    const std::string path = "x.toml:10:10: load[0].force[0]: ";
    CHECK(faults_of(loaded_by("t" + repeated("+t", 5000))) ==
          path + "\"t" + repeated("+t", 99) + "+…\": has 10001 letters; 10000 are the most");
    CHECK(faults_of(loaded_by("t" + repeated("+t", 4999))) == "");
    CHECK(faults_of(loaded_by("f0(t)") + function_chain(13, 2)) == "");
    CHECK_THAT(faults_of(loaded_by("f0(t)") + function_chain(60, 2)),
               Catch::Contains("operations to evaluate; 100000 are the most"));
    CHECK(faults_of(loaded_by("f0(t)") + function_chain(98, 1)) == "");
    CHECK_THAT(
        faults_of(loaded_by("f0(t)") + function_chain(20000, 1)),
        Catch::Contains("is used through 1000 others, each by the one before; no more can be followed"));
    CHECK_THAT(faults_of(loaded_by("f0(t)") + function_chain(200, 1)),
               Catch::Contains("functions that call functions go more than 100 deep"));
}

TEST_CASE("Parameters that rest on thousands of others are refused", "[issues]") {
    const auto chain = [](int length) {
        std::string text = "[parameters]\n";
        for (int i = 0; i < length; ++i) text += fmt::format("p{} = \"p{}\"\n", i, i + 1);
        return body_deck + text + fmt::format("p{} = 1\n", length);
    };
    CHECK(faults_of(chain(999)) == "");
    CHECK(faults_of(chain(1001)) ==
          "x.toml:1009:1: parameters.p1000: is used through 1000 others, each by the one before; no more can "
          "be followed");
}

TEST_CASE("A model larger than the memory is refused with its size", "[issues]") {
    const std::string deck = replaced(rod_deck, "elements = 10", "elements = 1000000\norder = 2");
    const auto faults_with = [&](double usable_bytes) {
        FaultList faults("x.toml", {});
        const CheckedTable checked = check_deck(read_toml(deck, "x.toml"), faults);
        check_memory(checked, {}, usable_bytes, faults);
        return faults.count() == 0 ? std::string() : DeckError(faults.list()).what();
    };
    CHECK(faults_with(1e10) == "");
    CHECK(faults_with(1e9) ==
          "x.toml:7:12: rod.r.elements: the model would have 2000001 nodes and need more than 5.95 GB of "
          "memory, where "
          "1 GB may be used; expected fewer elements");
    // The reader asks the machine; no machine has as much.
    std::string many = deck;
    for (int i = 0; i < 400; ++i) {
        many += fmt::format(
            "[rod.r{}]\nsection = \"s\"\nline = {{ from = [0, 0, 0], to = [1, 0, 0] }}\nelements = "
            "10000000\norder = 4\n",
            i);
    }
    CHECK_THAT(faults_of(many), Catch::Contains("need more than 4.76e+04 GB of memory"));
}

}  // namespace gxrod::test
