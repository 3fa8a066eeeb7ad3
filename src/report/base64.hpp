#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>

namespace gxrod {

// Characters that so many bytes take in base64, padding included.
constexpr std::size_t base64_length(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

// Writes bytes as base64 (RFC 4648), as they come.
class Base64Writer {
  public:
    explicit Base64Writer(std::ostream& out) : out_(out) {}

    void write(std::span<const std::byte> bytes);
    // The bytes of the numbers, little-endian, as all machines that gxrod runs on have them.
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
