#include "deck/sections/large_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "cross_section/cross_section.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/sections/section_tables.hpp"
#include "model/parts.hpp"

namespace gxrod {
namespace {

// A shape's extent over the length of its rods.
constexpr double largest_part = 0.2;

double find_extent(const CrossSection& shape) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    PlanePoint low = PlanePoint::Constant(infinity), high = -low;
    for (const PlanePoint& node : shape.mesh.nodes) {
        low = low.cwiseMin(node);
        high = high.cwiseMax(node);
    }
    return (high - low).maxCoeff();
}

// The length of all rods of the part to which each rod belongs.
std::vector<double> measure_parts(const Model& model) {
    std::vector<double> lengths(model.rods.size(), 0.0);
    for (const ModelPart& part : find_parts(model)) {
        double sum = 0.0;
        for (const int rod : part.rods) sum += model.rods[static_cast<std::size_t>(rod)].length;
        for (const int rod : part.rods) {
            double& length = lengths[static_cast<std::size_t>(rod)];
            length = std::max(length, sum);
        }
    }
    return lengths;
}

// "rod beam is 2 long", "rods a, b, c and 4 more are 3.5 long together".
std::string describe_rods(const std::vector<std::string>& names, double length) {
    constexpr std::size_t most = 4;
    if (names.size() == 1) return fmt::format("rod {} is {:.4g} long", names.front(), length);
    std::vector<std::string> named(names.begin(),
                                   names.begin() + static_cast<long>(std::min(most, names.size())));
    const std::string more = names.size() > most ? fmt::format(" and {} more", names.size() - most) : "";
    return fmt::format("rods {}{} are {:.4g} long together", plain_list(named), more, length);
}

}  // namespace

void question_large_shapes(const CheckedTable& deck, const Model& model, FaultList& questions) {
    const std::vector<double> lengths = measure_parts(model);
    for (const SectionTable& table : tables_of<SectionTable>(deck, section_table())) {
        if (!table.shape) continue;
        std::vector<std::string> names;
        double longest = 0.0, length = 0.0, extent = 0.0;
        for (std::size_t r = 0; r < model.rods.size(); ++r) {
            const Rod& rod = model.rods[r];
            const Section& section = model.sections[static_cast<std::size_t>(rod.section)];
            if (section.name != table.name || !section.shape) continue;
            extent = find_extent(*section.shape);
            names.push_back(rod.name);
            longest = std::max(longest, lengths[r]);
            length += rod.length;
        }
        if (names.empty() || extent <= largest_part * longest) continue;
        questions.add(table.place_of(&table.shape),
                      table.path_of(&table.shape),
                      fmt::format("is {:.4g} across, and {}; are all lengths in one unit?",
                                  extent,
                                  describe_rods(names, length)));
    }
}

}  // namespace gxrod
