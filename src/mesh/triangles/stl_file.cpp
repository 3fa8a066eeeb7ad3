#include "mesh/triangles/stl_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "mesh/line_mesh.hpp"

namespace gxrod {
namespace {

constexpr std::size_t header_bytes = 80;
constexpr std::size_t triangle_bytes = 50;

static_assert(std::endian::native == std::endian::little, "STL has the order of bytes of this machine");

// Of a file of bytes, which its length tells: some of them start with "solid" too.
std::optional<std::size_t> count_in_bytes(std::string_view bytes) {
    if (bytes.size() < header_bytes + sizeof(std::uint32_t)) return std::nullopt;
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + header_bytes, sizeof(count));
    const std::size_t needed = header_bytes + sizeof(count) + triangle_bytes * std::size_t{count};
    if (bytes.size() != needed) return std::nullopt;
    return count;
}

std::vector<Corners> read_bytes(std::string_view bytes, std::size_t count) {
    std::vector<Corners> triangles(count);
    for (std::size_t t = 0; t < count; ++t) {
        std::array<float, 12> numbers{};  // the normal and three corners
        std::memcpy(numbers.data(),
                    bytes.data() + header_bytes + sizeof(std::uint32_t) + triangle_bytes * t,
                    sizeof(numbers));
        for (std::size_t i = 3; i < numbers.size(); ++i) {
            if (!std::isfinite(numbers[i]))
                throw MeshError(
                    fmt::format("has a triangle, number {}, with a corner that is not finite", t + 1));
            triangles[t][(i - 3) / 3][static_cast<Eigen::Index>(i % 3)] = numbers[i];
        }
    }
    return triangles;
}

// Words of a text, by lines.
class Words {
  public:
    explicit Words(std::string_view text) : rest_(text) {}

    std::string_view next() {
        while (!rest_.empty() && is_blank(rest_.front())) {
            if (rest_.front() == '\n') ++line_;
            rest_.remove_prefix(1);
        }
        std::size_t size = 0;
        while (size < rest_.size() && !is_blank(rest_[size])) ++size;
        const std::string_view word = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return word;
    }
    void skip_line() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }
    int line() const { return line_; }

  private:
    static bool is_blank(char letter) {
        return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r';
    }
    std::string_view rest_;
    int line_ = 1;
};

bool is_word(std::string_view word, std::string_view expected) {
    return word.size() == expected.size() &&
           std::equal(word.begin(), word.end(), expected.begin(), [](char a, char b) {
               return std::tolower(static_cast<unsigned char>(a)) == b;
           });
}

double read_number(Words& words) {
    std::string_view word = words.next();
    const std::string_view found = word;
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
        throw MeshError(
            fmt::format("line {}: expected three numbers after vertex, found \"{}\"", words.line(), found));
    return value;
}

std::vector<Corners> read_text(std::string_view bytes) {
    Words words(bytes);
    std::vector<Corners> triangles;
    std::size_t corners = 0;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        if (is_word(word, "solid") || is_word(word, "endsolid")) words.skip_line();
        if (is_word(word, "endloop") && corners != 3)
            throw MeshError(
                fmt::format("line {}: expected triangles, found {} corners", words.line(), corners));
        if (is_word(word, "endloop")) corners = 0;
        if (!is_word(word, "vertex")) continue;
        if (corners == 0) triangles.emplace_back();
        if (++corners > 3) continue;
        for (Eigen::Index i = 0; i < 3; ++i) triangles.back()[corners - 1][i] = read_number(words);
    }
    if (corners != 0) throw MeshError("ends within a triangle");
    return triangles;
}

}  // namespace

std::vector<Corners> read_stl(std::string_view bytes) {
    if (const auto count = count_in_bytes(bytes)) return read_bytes(bytes, *count);
    Words words(bytes);
    if (is_word(words.next(), "solid") && bytes.find('\0') == std::string_view::npos) return read_text(bytes);
    throw MeshError(
        "is not STL: it neither starts with \"solid\" nor is as long as its number of triangles makes it");
}

bool lacks_end_of_stl(std::string_view bytes) {
    if (count_in_bytes(bytes)) return false;
    Words words(bytes);
    int open = 0;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        const bool begins = is_word(word, "solid"), ends = is_word(word, "endsolid");
        if (begins || ends) words.skip_line();
        open += begins ? 1 : ends ? -1 : 0;
    }
    return open > 0;
}

}  // namespace gxrod
