#include "machine/zip_archive.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>

#include "machine/checksum.hpp"

namespace gxrod {
namespace {

// Little-endian numbers and texts, one after the other.
class ZipBytes {
  public:
    ZipBytes& two(std::uint32_t value) { return add(value, 2); }
    ZipBytes& four(std::uint32_t value) { return add(value, 4); }
    ZipBytes& text(const std::string& text) {
        bytes_ += text;
        return *this;
    }
    std::uint32_t size() const {
        if (bytes_.size() > std::numeric_limits<std::uint32_t>::max())
            throw std::length_error("an archive of more than 4 GB");
        return static_cast<std::uint32_t>(bytes_.size());
    }
    std::string release() { return std::move(bytes_); }

  private:
    ZipBytes& add(std::uint32_t value, int count) {
        for (int i = 0; i < count; ++i) bytes_ += static_cast<char>((value >> (8 * i)) & 0xFFU);
        return *this;
    }

    std::string bytes_;
};

// What the header of a file and its entry in the directory have in common: version, UTF-8 names, stored,
// date.
void add_common(ZipBytes& to, const std::string& name, const std::string& bytes) {
    constexpr std::uint32_t version = 20, names_in_utf8 = 1U << 11U, stored = 0, midnight = 0,
                            first_day = 0x21;
    const auto size = static_cast<std::uint32_t>(bytes.size());
    to.two(version).two(names_in_utf8).two(stored).two(midnight).two(first_day);
    to.four(checksum(std::as_bytes(std::span(bytes)))).four(size).four(size);
    to.two(static_cast<std::uint32_t>(name.size())).two(0);
}

}  // namespace

std::string make_zip(const std::map<std::string, std::string>& files) {
    constexpr std::uint32_t file_mark = 0x04034B50, entry_mark = 0x02014B50, end_mark = 0x06054B50,
                            version = 20;
    ZipBytes archive, directory;
    for (const auto& [name, bytes] : files) {
        if (bytes.size() > std::numeric_limits<std::uint32_t>::max())
            throw std::length_error("a file of more than 4 GB in an archive");
        directory.four(entry_mark).two(version);
        add_common(directory, name, bytes);
        directory.two(0).two(0).two(0).four(0).four(archive.size()).text(name);
        archive.four(file_mark);
        add_common(archive, name, bytes);
        archive.text(name).text(bytes);
    }
    const std::uint32_t start = archive.size(), length = directory.size();
    const auto count = static_cast<std::uint32_t>(files.size());
    archive.text(directory.release());
    archive.four(end_mark).two(0).two(0).two(count).two(count).four(length).four(start).two(0);
    return archive.release();
}

}  // namespace gxrod
