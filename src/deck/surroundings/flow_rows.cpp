#include "deck/surroundings/flow_rows.hpp"

#include "deck/reading/row_reader.hpp"

namespace gxrod {
namespace {

constexpr std::size_t least_width = 2, most_width = 4;

class FlowRowReader : public RowReader {
  public:
    using RowReader::RowReader;

    std::optional<FlowRows> read(const DeckNode& node, const std::string& path) const {
        if (node.array() == nullptr || node.array()->empty()) {
            expect(node, path, Kind<FlowRows>::words(key_));
            return std::nullopt;
        }
        FlowRows rows;
        for (std::size_t i = 0; i < node.array()->size(); ++i) {
            auto row = read_row((*node.array())[i], fmt::format("{}[{}]", path, i), rows);
            if (!row) return std::nullopt;
            rows.rows.push_back(std::move(*row));
            rows.places.push_back((*node.array())[i].place);
        }
        return rows;
    }

  private:
    std::optional<std::vector<double>> read_row(const DeckNode& row,
                                                const std::string& path,
                                                const FlowRows& before) const {
        const std::size_t width = row.array() != nullptr ? row.array()->size() : 0;
        if (width < least_width || width > most_width) {
            expect(row, path, "a row [z, speed], [z, speed, degrees] or [z, vx, vy, vz]");
            return std::nullopt;
        }
        if (!before.rows.empty() && width != before.width()) {
            add(row,
                path,
                fmt::format("expected {} numbers as in the first row, found {}", before.width(), width));
            return std::nullopt;
        }
        std::vector<double> numbers;
        for (std::size_t i = 0; i < width; ++i) {
            const std::optional<double> one = number((*row.array())[i], fmt::format("{}[{}]", path, i));
            if (!one) return std::nullopt;
            numbers.push_back(*one);
        }
        return numbers;
    }
};

}  // namespace

std::string Kind<FlowRows>::schema(const KeySpec&) {
    return schema_of_list(schema_of_any({schema_of_array(any_number_schema, 2),
                                         schema_of_array(any_number_schema, 3),
                                         schema_of_array(any_number_schema, 4)}),
                          1);
}

std::optional<FlowRows> Kind<FlowRows>::read(const ValueSource& from) {
    return FlowRowReader(from.key, from.context).read(from.node, from.path);
}

std::string Kind<FlowRows>::print(const FlowRows& value) {
    std::vector<std::string> rows;
    for (const std::vector<double>& row : value.rows)
        rows.push_back(fmt::format("[{}]", fmt::join(row, ", ")));
    return print_list(rows);
}

}  // namespace gxrod
