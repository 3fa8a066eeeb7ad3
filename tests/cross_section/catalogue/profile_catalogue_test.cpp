#include "cross_section/catalogue/profile_catalogue.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "cross_section/catalogue/profile_names.hpp"
#include "cross_section/outlines/outline_examination.hpp"
#include "cross_section/outlines/outline_moments.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

struct Printed {
    std::string name;
    double area, Iy;
};

std::vector<Printed> read_printed(const std::string& file) {
    std::ifstream stream(std::string(GXROD_SOURCE_DIR) + "/tests/data/profiles/" + file);
    REQUIRE(stream);
    std::vector<Printed> rows;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with('#') || line.starts_with("name")) continue;
        std::replace(line.begin(), line.end(), ' ', '_');
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream cells(line);
        Printed row;
        cells >> row.name >> row.area >> row.Iy;
        rows.push_back(row);
    }
    return rows;
}

// The largest relative differences of area and second moment of the profiles whose names begin so.
struct Differences {
    int count = 0;
    double area = 0.0, Iy = 0.0;
};

Differences compare(const std::string& file, std::initializer_list<std::string_view> series) {
    Differences largest;
    for (const Printed& row : read_printed(file)) {
        const std::string letters = parse_profile_name(row.name).letters;
        if (std::ranges::find(series, letters) == series.end()) continue;
        const CatalogueProfile* profile = find_profile(row.name);
        INFO(row.name);
        REQUIRE(profile != nullptr);
        const OutlineMoments found = compute_moments(draw_outline(profile->shape));
        const double of_area = std::abs(found.area / row.area - 1), of_Iy = std::abs(found.Iy / row.Iy - 1);
        largest = {largest.count + 1, std::max(largest.area, of_area), std::max(largest.Iy, of_Iy)};
    }
    return largest;
}

std::string name_of(std::string_view name) {
    const CatalogueProfile* found = find_profile(name);
    return found == nullptr ? "none" : found->name;
}

}  // namespace

TEST_CASE("Every profile of the catalogue has an outline", "[cross_section]") {
    CHECK(list_profiles().size() > 1900);
    for (const CatalogueProfile& profile : list_profiles()) {
        INFO(profile.name);
        const auto fault = find_fault(profile.shape);
        if (fault) FAIL_CHECK(fault->part << ": " << fault->message);
        CHECK(compute_moments(draw_outline(profile.shape)).area > 0.0);
        CHECK(name_of(profile.name) == profile.name);
    }
}

TEST_CASE("European profiles have the areas and second moments printed elsewhere", "[cross_section]") {
    const Differences of_I = compare("printed_europe.csv", {"IPE", "HEA", "HEB", "HEM"});
    CHECK(of_I.count == 90);
    CHECK(of_I.area < 1e-3);
    CHECK(of_I.Iy < 1e-3);
    // Printed with three digits.
    const Differences of_rings = compare("printed_europe.csv", {"CHS"});
    CHECK(of_rings.count == 162);
    CHECK(of_rings.area < 5e-3);
    CHECK(of_rings.Iy < 5e-3);
    const Differences of_boxes = compare("printed_europe.csv", {"SHS", "RHS"});
    CHECK(of_boxes.count == 248);
    CHECK(of_boxes.area < 5e-3);
    CHECK(of_boxes.Iy < 5e-3);
    const Differences of_channels = compare("printed_channels.csv", {"UPN", "UPE"});
    CHECK(of_channels.count == 30);
    CHECK(of_channels.area < 5e-3);
    CHECK(of_channels.Iy < 5e-3);
    const Differences of_angles = compare("printed_channels.csv", {"L"});
    CHECK(of_angles.count == 12);
    CHECK(of_angles.area < 5e-3);
    CHECK(of_angles.Iy < 6e-3);
}

// AISC rounds dimensions and results to three digits.
TEST_CASE("American profiles have the areas and second moments that AISC prints", "[cross_section]") {
    const Differences of_W = compare("printed_aisc.csv", {"W"});
    CHECK(of_W.count == 289);
    CHECK(of_W.area < 8e-3);
    CHECK(of_W.Iy < 1e-2);
    const Differences of_hollows = compare("printed_aisc.csv", {"HSS"});
    CHECK(of_hollows.count == 714);
    CHECK(of_hollows.area < 6e-3);
    CHECK(of_hollows.Iy < 1e-2);
}

// HD 260x93.0 has 93 kg/m.
TEST_CASE("Profiles named after their mass have it", "[cross_section]") {
    constexpr double density = 7.85e-3;  // g/mm³
    int count = 0;
    for (const CatalogueProfile& profile : list_profiles()) {
        const ProfileName name = parse_profile_name(profile.name);
        if (name.letters != "HD" && name.letters != "HP") continue;
        INFO(profile.name);
        CHECK(compute_moments(draw_outline(profile.shape)).area * density ==
              Approx(name.numbers.back()).epsilon(3e-3).margin(0.8));
        ++count;
    }
    CHECK(count == 69);
}

TEST_CASE("Spelling of names does not matter", "[cross_section]") {
    for (const char* name : {"IPE 200", "ipe200", " Ipe  200 ", "IPE_200"}) CHECK(name_of(name) == "IPE 200");
    for (const char* name : {"HEA 200", "HE 200 A", "he200a", "HE A 200"}) CHECK(name_of(name) == "HEA 200");
    for (const char* name :
         {"L 100x100x10", "L100X100X10", "l 100 * 100 * 10", "L 100\u00d7100\u00d710", "L 100x10"})
        CHECK(name_of(name) == "L 100x100x10");
    CHECK(name_of("CHS 114,3 x 5") == "CHS 114.3x5");
    CHECK(name_of("SHS 100x5 cold") == "SHS 100x100x5 cold");
    CHECK(name_of("w14x90") == "W14X90");
    CHECK(name_of("HSS 4 x 4 x 1/4") == "HSS4X4X1/4");
    CHECK(name_of("HSS 1-1/2x1-1/2x1/4") == "HSS1-1/2X1-1/2X1/4");
    CHECK(name_of("") == "none");
    CHECK(name_of("IPE") == "none");
    CHECK(name_of("IPE 205") == "none");
    // Hot or cold finished: the corners differ.
    CHECK(name_of("SHS 100x100x5") == "none");
}

TEST_CASE("Profiles near an unknown name are of its series", "[cross_section]") {
    using Names = std::vector<std::string>;
    CHECK(find_nearest_profiles("IPE 205") == Names{"IPE 200", "IPE 220"});
    CHECK(find_nearest_profiles("SHS 100x5") == Names{"SHS 100x100x5 cold", "SHS 100x100x5 hot"});
    CHECK(find_nearest_profiles("L 100x100x11") == Names{"L 100x100x10", "L 100x100x12"});
    CHECK(find_nearest_profiles("IPX 200").empty());
    CHECK(list_series() ==
          Names{"CHS", "HD", "HEA", "HEB", "HEM", "HP", "HSS", "IPE", "L", "RHS", "SHS", "UPE", "UPN", "W"});
}

TEST_CASE("American profiles are in inches", "[cross_section]") {
    CHECK(find_profile("W14X90")->unit == 25.4);
    CHECK(find_profile("IPE 200")->unit == 1.0);
    CHECK(std::get<IShape>(find_profile("W14X90")->shape).height == 14.0);
}

}  // namespace gxrod::test
