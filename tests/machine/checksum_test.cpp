#include "machine/checksum.hpp"

#include <string_view>

#include "tools/catch.hpp"

using gxrod::checksum;

// The check values of CRC-32 (ISO-HDLC) in the catalogue of parametrised CRC algorithms, and of RFC 3720's
// kin.
TEST_CASE("The checksum is CRC-32", "[machine]") {
    const auto of = [](std::string_view text, std::uint32_t before = 0) {
        return checksum(std::span<const char>(text), before);
    };
    CHECK(of("123456789") == 0xCBF43926);
    CHECK(of("The quick brown fox jumps over the lazy dog") == 0x414FA339);
    CHECK(of("") == 0);
    CHECK(of("6789", of("12345")) == 0xCBF43926);
    CHECK(of("", of("123456789")) == 0xCBF43926);
}
