#include "machine/zip_archive.hpp"

#include <cstdint>

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t place, int count = 4) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i)
        value |= std::uint32_t{static_cast<unsigned char>(bytes[place + static_cast<std::size_t>(i)])}
                 << (8 * i);
    return value;
}

}  // namespace

TEST_CASE("A ZIP archive has its files, and a directory of them", "[machine]") {
    const std::string zip = make_zip({{"a/one.txt", "123456789"}, {"two", ""}});
    CHECK(zip == make_zip({{"two", ""}, {"a/one.txt", "123456789"}}));
    CHECK(number_at(zip, 0) == 0x04034B50);
    CHECK(number_at(zip, 14) == 0xCBF43926);  // the CRC-32 of "123456789"
    CHECK(number_at(zip, 22) == 9);
    CHECK(zip.substr(30, 18) == "a/one.txt123456789");
    const std::size_t end = zip.size() - 22;
    CHECK(number_at(zip, end) == 0x06054B50);
    CHECK(number_at(zip, end + 10, 2) == 2);
    const std::size_t directory = number_at(zip, end + 16);
    CHECK(directory == 30 + 18 + 30 + 3);
    CHECK(directory + number_at(zip, end + 12) == end);
    CHECK(number_at(zip, directory) == 0x02014B50);
    CHECK(number_at(zip, directory + 42) == 0);
    CHECK(zip.substr(directory + 46, 9) == "a/one.txt");
    CHECK(number_at(zip, directory + 46 + 9 + 42) == 48);
    CHECK(make_zip({}).size() == 22);
}

}  // namespace gxrod::test
