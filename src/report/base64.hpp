#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>

namespace gxrod {

// Returns the number of characters of so many bytes in base64, with padding.
constexpr std::size_t base64_length(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

// Writes bytes as base64 (RFC 4648) as they arrive.
class Base64Writer {
  public:
    explicit Base64Writer(std::ostream& out) : out_(out) {}

    void write(std::span<const std::byte> bytes);
    // Writes the bytes of numbers, little-endian as on all machines that gxrod runs on.
    template <class Number>
    void write(std::span<const Number> numbers) {
        write(std::as_bytes(numbers));
    }
    // Ends the text with its padding. Nothing may be written after it.
    void finish();

  private:
    void write_group();

    std::ostream& out_;
    std::array<std::uint8_t, 3> group_{};
    std::size_t in_group_ = 0;
    std::string text_;
};

}  // namespace gxrod
