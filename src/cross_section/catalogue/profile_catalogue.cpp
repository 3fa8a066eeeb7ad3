#include "cross_section/catalogue/profile_catalogue.hpp"

#include <algorithm>
#include <charconv>
#include <map>

#include "cross_section/catalogue/catalogue_texts.hpp"
#include "cross_section/catalogue/profile_names.hpp"

namespace gxrod {
namespace {

std::vector<std::string_view> split_line(std::string_view text, char sign) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(sign);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

// The numbers of a row by the names of their columns; 0 for columns that the table does not have.
class CatalogueRow {
  public:
    CatalogueRow(const std::vector<std::string_view>& columns, const std::vector<std::string_view>& cells) {
        for (std::size_t i = 1; i < std::min(columns.size(), cells.size()); ++i) {
            double value = 0.0;
            std::from_chars(cells[i].data(), cells[i].data() + cells[i].size(), value);
            numbers_.emplace(columns[i], value);
        }
    }
    double operator[](std::string_view column) const {
        const auto found = numbers_.find(column);
        return found == numbers_.end() ? 0.0 : found->second;
    }
    bool has(std::string_view column) const { return numbers_.contains(column); }

  private:
    std::map<std::string_view, double> numbers_;
};

ProfileShape make_shape(std::string_view kind, const CatalogueRow& row) {
    const double height = row["height"], width = row["width"], web = row["web"], wall = row["wall"];
    if (kind == "I") return IShape{height, width, web, row["flange"], row["fillet"]};
    if (kind == "ring") return HollowCircle{row["diameter"], wall};
    if (kind == "box") return BoxShape{height, width, wall, wall, row["outer_radius"], row["inner_radius"]};
    if (kind == "angle") return AngleShape{height, width, wall, row["fillet"], row["toe"]};
    ChannelShape channel{height, width, web, row["flange"], row["fillet"], row["toe"], row["slope"]};
    if (row.has("flange_at")) channel.flange_at = row["flange_at"];
    return channel;
}

void read_table(std::string_view text, std::vector<CatalogueProfile>& profiles) {
    constexpr std::string_view of_shape = "# shape: ", of_unit = "# unit: ";
    constexpr double inch = 25.4;
    std::string_view kind;
    double unit = 1.0;
    std::vector<std::string_view> columns;
    for (const std::string_view line : split_line(text, '\n')) {
        if (line.starts_with(of_shape)) kind = line.substr(of_shape.size());
        if (line.starts_with(of_unit) && line.substr(of_unit.size()) == "in") unit = inch;
        if (line.empty() || line.starts_with('#')) continue;
        const std::vector<std::string_view> cells = split_line(line, ',');
        if (columns.empty()) {
            columns = cells;
        } else {
            profiles.push_back({std::string(cells[0]), make_shape(kind, CatalogueRow(columns, cells)), unit});
        }
    }
}

struct Catalogue {
    std::vector<CatalogueProfile> profiles;
    std::vector<ProfileName> names;
};

const Catalogue& catalogue() {
    static const Catalogue read = [] {
        Catalogue all;
        for (const std::string_view text : catalogue_texts()) read_table(text, all.profiles);
        for (const CatalogueProfile& profile : all.profiles)
            all.names.push_back(parse_profile_name(profile.name));
        return all;
    }();
    return read;
}

}  // namespace

std::span<const CatalogueProfile> list_profiles() { return catalogue().profiles; }

const CatalogueProfile* find_profile(std::string_view name) {
    const auto& [profiles, names] = catalogue();
    const auto found = std::ranges::find(names, parse_profile_name(name));
    return found == names.end() ? nullptr : &profiles[static_cast<std::size_t>(found - names.begin())];
}

std::vector<std::string> find_nearest_profiles(std::string_view name) {
    constexpr std::size_t most = 2;
    const auto& [profiles, names] = catalogue();
    const ProfileName wanted = parse_profile_name(name);
    std::vector<std::pair<double, std::string>> found;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].letters == wanted.letters)
            found.emplace_back(measure_difference(wanted, names[i]), profiles[i].name);
    }
    std::ranges::sort(found);
    std::vector<std::string> nearest;
    for (std::size_t i = 0; i < std::min(most, found.size()); ++i) nearest.push_back(found[i].second);
    return nearest;
}

std::vector<std::string> list_series() {
    std::vector<std::string> series;
    for (const ProfileName& name : catalogue().names) {
        if (std::ranges::find(series, name.letters) == series.end()) series.push_back(name.letters);
    }
    std::ranges::sort(series);
    return series;
}

}  // namespace gxrod
