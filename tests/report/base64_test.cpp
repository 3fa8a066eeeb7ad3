#include "report/base64.hpp"

#include <sstream>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

std::string encode(const std::string& text) {
    std::ostringstream out;
    Base64Writer base64(out);
    base64.write(std::as_bytes(std::span(text)));
    base64.finish();
    return out.str();
}

}  // namespace

TEST_CASE("base64 of the vectors of RFC 4648", "[report]") {
    const std::vector<std::pair<std::string, std::string>> vectors{{"", ""},
                                                                   {"f", "Zg=="},
                                                                   {"fo", "Zm8="},
                                                                   {"foo", "Zm9v"},
                                                                   {"foob", "Zm9vYg=="},
                                                                   {"fooba", "Zm9vYmE="},
                                                                   {"foobar", "Zm9vYmFy"}};
    for (const auto& [text, expected] : vectors) {
        CHECK(encode(text) == expected);
        CHECK(base64_length(text.size()) == expected.size());
    }
    CHECK(encode(std::string("\xff\xfe\x00\xfb", 4)) == "//4A+w==");
}

TEST_CASE("base64 does not depend on how the bytes come", "[report]") {
    std::string text;
    for (int i = 0; i < 1000; ++i) text += static_cast<char>(i * 37);
    std::ostringstream out;
    Base64Writer base64(out);
    std::size_t first = 0;
    for (std::size_t size = 0; first < text.size(); ++size) {
        const std::string piece = text.substr(first, size);
        base64.write(std::as_bytes(std::span(piece)));
        first += size;
    }
    base64.finish();
    CHECK(out.str() == encode(text));
}

TEST_CASE("numbers are written little-endian", "[report]") {
    std::ostringstream out;
    Base64Writer base64(out);
    const std::vector<float> numbers{1.0f, -2.0f};
    base64.write(std::span<const float>(numbers));
    base64.finish();
    CHECK(out.str() == "AACAPwAAAMA=");
}
