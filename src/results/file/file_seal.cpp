#include "results/file/file_seal.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "machine/descriptor_io.hpp"
#include "results/file/page_sums.hpp"

namespace gxrod {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::array<char, 8> magic{'g', 'x', 'r', 'o', 'd', '\r', '\n', '\x1a'};
constexpr std::uint32_t seal_form = 1;
constexpr std::uint32_t is_sealed = 0x4c414553;  // "SEAL"
constexpr std::uint32_t is_open = 0x4e45504f;    // "OPEN": many bits from the other

// The first bytes of the block; the others are zeros.
struct Content {
    std::array<char, 8> begin = magic;
    std::uint32_t form = seal_form;
    std::uint32_t state = is_open;
    std::uint64_t bytes = 0;
    std::uint32_t sum = 0;
    std::uint32_t unused = 0;
};
static_assert(sizeof(Content) == 32);

class ReadDescriptor {
  public:
    explicit ReadDescriptor(const std::filesystem::path& path)
        : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
        if (descriptor_ < 0) throw std::system_error(errno, std::generic_category());
    }
    ~ReadDescriptor() { ::close(descriptor_); }
    ReadDescriptor(const ReadDescriptor&) = delete;
    ReadDescriptor& operator=(const ReadDescriptor&) = delete;

    int get() const { return descriptor_; }
    std::uint64_t size() const {
        struct stat status {};
        if (::fstat(descriptor_, &status) != 0) throw std::system_error(errno, std::generic_category());
        return static_cast<std::uint64_t>(status.st_size);
    }
    SealBlock read_block() const {
        SealBlock block{};
        read_at(descriptor_, 0, block);
        return block;
    }

  private:
    int descriptor_;
};

bool is_sum_kept(const ReadDescriptor& file, const FileSeal& seal) {
    return seal.bytes >= seal_block_bytes && file.size() >= seal.bytes &&
           PageSums().compute(file.get(), seal.bytes) == seal.sum;
}

}  // namespace

SealBlock write_seal(const FileSeal& seal) {
    Content content;
    content.state = seal.is_open ? is_open : is_sealed;
    content.bytes = seal.bytes;
    content.sum = seal.sum;
    SealBlock block{};
    std::memcpy(block.data(), &content, sizeof content);
    return block;
}

std::optional<FileSeal> read_seal(const SealBlock& block) {
    Content content;
    std::memcpy(&content, block.data(), sizeof content);
    const FileSeal seal{content.state == is_open, content.bytes, content.sum};
    return write_seal(seal) == block ? std::optional(seal) : std::nullopt;
}

bool begins_like_seal(const SealBlock& block) {
    return std::memcmp(block.data(), magic.data(), magic.size()) == 0;
}

SealState look_at_seal(const std::filesystem::path& path) {
    const ReadDescriptor file(path);
    const SealBlock block = file.read_block();
    if (!begins_like_seal(block)) return SealState::missing;
    const std::optional<FileSeal> seal = read_seal(block);
    if (seal && seal->is_open) return SealState::open;
    // A writer changes the seal before anything else.
    const auto is_as_before = [&] { return file.read_block() == block; };
    try {
        if (seal && is_sum_kept(file, *seal)) return SealState::kept;
    } catch (const std::system_error&) {
        if (is_as_before()) throw;
    }
    return is_as_before() ? SealState::violated : SealState::open;
}

}  // namespace gxrod
