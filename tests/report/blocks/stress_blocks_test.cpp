#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "report/base64.hpp"
#include "report/blocks/envelope_blocks.hpp"
#include "report/blocks/section_blocks.hpp"
#include "report/blocks/stress_file.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

constexpr std::size_t plenty = 10'000'000;

template <class Blocks>
std::string text_of(const Blocks& blocks) {
    std::ostringstream out;
    blocks.write(out);
    return out.str();
}

// The bytes of the block of this name.
std::string decode(const std::string& page, const std::string& name) {
    const std::string start = "id=\"data-" + name + "\">";
    const std::size_t first = page.find(start) + start.size();
    REQUIRE(page.find(start) != std::string::npos);
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int held = 0;
    for (std::size_t i = first; letters.find(page[i]) != std::string::npos; ++i) {
        bits = bits << 6 | static_cast<unsigned>(letters.find(page[i]));
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes += static_cast<char>(bits >> held & 0xFFU);
    }
    return bytes;
}

template <class Number>
std::vector<Number> numbers_in_page(const std::string& page, const std::string& name) {
    const std::string bytes = decode(page, name);
    std::vector<Number> numbers(bytes.size() / sizeof(Number));
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
    return numbers;
}

}  // namespace

TEST_CASE("Sections that fit are whole in a page", "[report]") {
    const sample::ScratchFolder folder;
    stress_file::write(folder / "a.h5", 2, 3);
    const Hdf5Reader file(folder / "a.h5");
    const SectionBlocks blocks(file, plenty);
    const std::string page = text_of(blocks);
    CHECK(page.size() <= blocks.count_bytes());
    CHECK(page.size() > blocks.count_bytes() - 10 * 80);
    CHECK(blocks.left_out().empty());
    CHECK(numbers_in_page<std::int32_t>(page, "section-cells-1") ==
          std::vector<std::int32_t>{0, 2, 3, 0, 3, 4});
    CHECK(numbers_in_page<std::int32_t>(page, "section-singular-0") ==
          std::vector<std::int32_t>{0, 0, 0, 0, 1});
    CHECK(numbers_in_page<float>(page, "section-points-0") ==
          std::vector<float>{0, 0, 0.5, 0, 1, 0, 1, 1, 0, 1});
    const std::vector<float> operators = numbers_in_page<float>(page, "section-operators-1");
    REQUIRE(operators.size() == 5 * 36);
    CHECK(operators[3 * 36 + 9] == 3.25F);
    nlohmann::ordered_json json;
    blocks.describe(json);
    CHECK(json["sections"][1] == nlohmann::ordered_json{{"name", "s1"},
                                                        {"source", "a square"},
                                                        {"layers", {"steel"}},
                                                        {"corners", 3},
                                                        {"is_drawn", true}});
}

TEST_CASE("Sections that do not fit keep the corners of cells, then the first sections", "[report]") {
    const sample::ScratchFolder folder;
    stress_file::write(folder / "a.h5", 2, 3);
    const Hdf5Reader file(folder / "a.h5");
    const std::size_t whole = SectionBlocks(file, plenty).count_bytes();
    const SectionBlocks corners(file, whole - 1);
    const std::string page = text_of(corners);
    CHECK(page.size() <= corners.count_bytes());
    CHECK(numbers_in_page<std::int32_t>(page, "section-cells-1") ==
          std::vector<std::int32_t>{0, 1, 2, 0, 2, 3});
    const std::vector<float> operators = numbers_in_page<float>(page, "section-operators-1");
    REQUIRE(operators.size() == 4 * 36);
    CHECK(operators[36] == 2.0F);
    CHECK(corners.left_out().size() == 1);
    const SectionBlocks one(file, corners.count_bytes() - 1);
    CHECK(text_of(one).find("section-cells-1") == std::string::npos);
    CHECK(one.left_out().at(0) == "Of 2 sections, the first 1 are drawn.");
    nlohmann::ordered_json json;
    one.describe(json);
    CHECK(json["sections"][0]["is_drawn"] == true);
    CHECK(json["sections"][1]["is_drawn"] == false);
    CHECK(SectionBlocks(file, 10).count_bytes() == 0);
}

TEST_CASE("A section whose cells have points that are not there is refused", "[report]") {
    const sample::ScratchFolder folder;
    stress_file::write(folder / "a.h5", 1, 3, 5);
    const Hdf5Reader file(folder / "a.h5");
    CHECK_THROWS_WITH(SectionBlocks(file, plenty), "/sections/0 has a cell with a point that is not there");
}

TEST_CASE("Envelopes in a page keep their largest values, however thinned", "[report]") {
    const sample::ScratchFolder folder;
    constexpr int places = 100;
    stress_file::write(folder / "a.h5", 1, places);
    const Hdf5Reader file(folder / "a.h5");
    const EnvelopeBlocks whole(file, plenty);
    const std::string page = text_of(whole);
    CHECK(page.size() <= whole.count_bytes());
    CHECK(whole.left_out().empty());
    const std::vector<float> rows = numbers_in_page<float>(page, "envelope-von_mises");
    REQUIRE(rows.size() == 11 * 2 * places);
    // Value, time, y, z, layer and resultants of place 101, the second one of the second rod.
    CHECK(std::vector<float>(rows.begin() + 11 * 101, rows.begin() + 11 * 102) ==
          std::vector<float>{101, 1, 10.1F, -10.1F, 0, 1010, 1011, 1012, 1013, 1014, 1015});

    const EnvelopeBlocks thinned(file, whole.count_bytes() / 10);
    CHECK(thinned.count_bytes() <= whole.count_bytes() / 10);
    CHECK(thinned.left_out().size() == 1);
    const std::string small = text_of(thinned);
    const std::vector<std::int32_t> rods = numbers_in_page<std::int32_t>(small, "envelope-rods");
    const std::vector<float> mises = numbers_in_page<float>(small, "envelope-von_mises");
    const std::vector<float> exposure = numbers_in_page<float>(small, "envelope-exposure");
    std::array<float, 2> largest{}, most{};
    for (std::size_t i = 0; i < rods.size(); ++i) {
        float& of_rod = largest.at(static_cast<std::size_t>(rods[i]));
        of_rod = std::max(of_rod, mises[11 * i]);
        float& its_most = most.at(static_cast<std::size_t>(rods[i]));
        its_most = std::max(its_most, exposure[11 * i]);
    }
    CHECK(largest == std::array<float, 2>{99, 199});
    CHECK(most == std::array<float, 2>{200, 100});
}

TEST_CASE("Files without stresses add nothing to a page", "[report]") {
    const sample::ScratchFolder folder;
    const std::string path = folder / "a.h5";
    {
        const Hdf5Handle file(
            H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, "a");
    }
    const Hdf5Reader file(path);
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    const SectionBlocks sections(file, plenty);
    const EnvelopeBlocks envelopes(file, plenty);
    sections.describe(json);
    envelopes.describe(json);
    CHECK(text_of(sections) + text_of(envelopes) == "");
    CHECK(sections.count_bytes() + envelopes.count_bytes() == 0);
    CHECK(sections.left_out().empty());
    CHECK(envelopes.left_out().empty());
    CHECK(json.empty());
}
