#include "deck/reading/array_reading.hpp"

#include <fmt/format.h>

#include "deck/reading/number_reader.hpp"

namespace gxrod {
namespace {

// An array of `size` numbers; nullopt if one is at fault.
std::optional<std::vector<double>> read_numbers(const DeckNode& node,
                                                const std::string& path,
                                                std::size_t size,
                                                const ReadingContext& context) {
    // Without a range of its own.
    static const KeySpec number{};
    if (node.array() == nullptr || node.array()->size() != size) {
        context.faults.add(
            node.place,
            path,
            fmt::format(
                "expected an array of {} numbers or expressions, found {}", size, describe_found(node)));
        return std::nullopt;
    }
    std::vector<double> numbers;
    for (std::size_t i = 0; i < size; ++i) {
        const auto value =
            NumberReader(number, context).number((*node.array())[i], fmt::format("{}[{}]", path, i));
        if (value) numbers.push_back(*value);
    }
    return numbers.size() == size ? std::optional(numbers) : std::nullopt;
}

void expect(const DeckNode& node,
            const std::string& path,
            const KeySpec& key,
            const ReadingContext& context) {
    context.faults.add(
        node.place, path, fmt::format("expected {}, found {}", describe_expected(key), describe_found(node)));
}

}  // namespace

std::optional<std::vector<double>> read_number_list(const DeckNode& node,
                                                    const std::string& path,
                                                    const KeySpec& key,
                                                    const ReadingContext& context) {
    if (node.array() != nullptr && !node.array()->empty())
        return read_numbers(node, path, node.array()->size(), context);
    expect(node, path, key, context);
    return std::nullopt;
}

std::optional<std::vector<double>> read_section_point(const DeckNode& node,
                                                      const std::string& path,
                                                      const KeySpec& key,
                                                      const ReadingContext& context) {
    if (node.array() != nullptr && node.array()->size() == 2) return read_numbers(node, path, 2, context);
    expect(node, path, key, context);
    return std::nullopt;
}

std::optional<std::vector<double>> read_number_or_six(const DeckNode& node,
                                                      const std::string& path,
                                                      const KeySpec& key,
                                                      const ReadingContext& context) {
    if (node.array() == nullptr) {
        const std::optional<double> number = NumberReader(key, context).number(node, path);
        return number ? std::optional(std::vector{*number}) : std::nullopt;
    }
    if (node.array()->size() != 6) {
        expect(node, path, key, context);
        return std::nullopt;
    }
    std::vector<double> numbers;
    for (std::size_t i = 0; i < 6; ++i) {
        const auto value =
            NumberReader(key, context).number((*node.array())[i], fmt::format("{}[{}]", path, i));
        if (value) numbers.push_back(*value);
    }
    return numbers.size() == 6 ? std::optional(numbers) : std::nullopt;
}

std::optional<std::vector<double>> read_bounds(const DeckNode& node,
                                               const std::string& path,
                                               const KeySpec& key,
                                               const ReadingContext& context) {
    if (node.array() == nullptr) {
        const std::optional<double> bound = NumberReader(key, context).number(node, path);
        return bound ? std::optional(std::vector{*bound}) : std::nullopt;
    }
    const auto bounds = node.array()->size() == 2 ? read_numbers(node, path, 2, context) : std::nullopt;
    if (node.array()->size() != 2) expect(node, path, key, context);
    if (!bounds || bounds->front() < bounds->back()) return bounds;
    context.faults.add(
        node.place,
        path,
        fmt::format("the first number is the lower bound; found {} and {}", bounds->front(), bounds->back()));
    return std::nullopt;
}

std::optional<std::vector<CheckedVector>> read_vectors(const DeckNode& node,
                                                       const std::string& path,
                                                       const KeySpec& key,
                                                       const ReadingContext& context) {
    if (node.array() == nullptr || node.array()->size() < 2) {
        expect(node, path, key, context);
        return std::nullopt;
    }
    std::vector<CheckedVector> vectors;
    for (std::size_t i = 0; i < node.array()->size(); ++i) {
        const DeckNode& element = (*node.array())[i];
        const std::string element_path = fmt::format("{}[{}]", path, i);
        const auto numbers = read_numbers(element, element_path, 3, context);
        if (numbers) vectors.push_back({Vec3(numbers->data()), element.place, element_path});
    }
    return vectors.size() == node.array()->size() ? std::optional(std::move(vectors)) : std::nullopt;
}

std::optional<Mat6> read_section_matrix(const DeckNode& node,
                                        const std::string& path,
                                        const KeySpec& key,
                                        const ReadingContext& context) {
    if (node.array() == nullptr || node.array()->size() != 6) {
        expect(node, path, key, context);
        return std::nullopt;
    }
    Mat6 matrix;
    bool complete = true;
    for (int i = 0; i < 6; ++i) {
        const auto row = read_numbers((*node.array())[i], fmt::format("{}[{}]", path, i), 6, context);
        complete = complete && row;
        if (row) matrix.row(i) = Vec6(row->data()).transpose();
    }
    return complete ? std::optional(matrix) : std::nullopt;
}

}  // namespace gxrod
