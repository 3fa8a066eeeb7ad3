#include "report/base64.hpp"

#include <bit>

namespace gxrod {

static_assert(std::endian::native == std::endian::little);

namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

void Base64Writer::write_group() {
    const std::uint32_t bits = static_cast<std::uint32_t>(group_[0]) << 16 |
                               static_cast<std::uint32_t>(group_[1]) << 8 |
                               static_cast<std::uint32_t>(group_[2]);
    for (int shift = 18; shift >= 0; shift -= 6) text_ += alphabet[(bits >> shift) & 63];
}

void Base64Writer::write(std::span<const std::byte> bytes) {
    text_.clear();
    for (const std::byte byte : bytes) {
        group_[in_group_++] = std::to_integer<std::uint8_t>(byte);
        if (in_group_ < group_.size()) continue;
        write_group();
        in_group_ = 0;
    }
    out_ << text_;
}

void Base64Writer::finish() {
    if (in_group_ == 0) return;
    text_.clear();
    for (std::size_t i = in_group_; i < group_.size(); ++i) group_[i] = 0;
    write_group();
    text_.replace(in_group_ + 1, 3 - in_group_, 3 - in_group_, '=');
    out_ << text_;
    in_group_ = 0;
}

}  // namespace gxrod
