#include "results/file/ordered_file.hpp"

#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <system_error>

#include "machine/descriptor_io.hpp"
#include "results/file/file_seal.hpp"

namespace gxrod {
namespace {

[[noreturn]] void throw_errno() { throw std::system_error(errno, std::generic_category()); }

// Height of a version 1 B-tree node above the leaves: signature "TREE", node type, level.
int tree_level(std::span<const std::byte> node) {
    const bool is_tree = node.size() > 5 && std::memcmp(node.data(), "TREE", 4) == 0;
    return is_tree ? std::to_integer<int>(node[5]) : 0;
}

}  // namespace

OrderedFile::OrderedFile(int descriptor) : descriptor_(descriptor) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) {
        const int code = errno;
        ::close(descriptor);
        throw std::system_error(code, std::generic_category());
    }
    size_ = disk_size_ = end_ = committed_ = static_cast<std::uint64_t>(status.st_size);
}

OrderedFile::~OrderedFile() { ::close(descriptor_); }

void OrderedFile::write(Part part, std::uint64_t offset, std::span<const std::byte> bytes) {
    if (is_abandoned_) return;
    end_ = std::max(end_, offset + bytes.size());
    if (part == Part::data && try_to_write_now(offset, bytes)) return;
    if (part != Part::data) {
        // Only the last image of a node or header counts; its level, and so its rank, can have changed.
        const auto [found, is_new] = pending_metadata_.try_emplace(offset, pending_.size());
        if (!is_new) {
            pending_[found->second].bytes.clear();
            found->second = pending_.size();
        }
    }
    pending_.push_back({part, offset, {bytes.begin(), bytes.end()}});
}

bool OrderedFile::try_to_write_now(std::uint64_t offset, std::span<const std::byte> bytes) {
    // HDF5 can have freed a place with a pending write, which must not overwrite this one.
    const bool is_taken = std::any_of(pending_.begin(), pending_.end(), [&](const Write& write) {
        return write.offset < offset + bytes.size() && offset < write.offset + write.bytes.size();
    });
    if (offset < committed_ || is_taken) return false;
    try {
        write_at(descriptor_, offset, bytes);
    } catch (const std::system_error&) {
        return false;  // the commit reports it
    }
    disk_size_ = std::max(disk_size_, offset + bytes.size());
    return true;
}

void OrderedFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
    const std::size_t filled = read_at(descriptor_, offset, bytes);
    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(filled), bytes.end(), std::byte{0});

    for (const Write& write : pending_) {
        const std::uint64_t first = std::max(offset, write.offset);
        const std::uint64_t last = std::min(offset + bytes.size(), write.offset + write.bytes.size());
        if (first >= last) continue;
        std::memcpy(
            bytes.data() + (first - offset), write.bytes.data() + (first - write.offset), last - first);
    }
}

bool OrderedFile::is_on_disk(const Write& write) const {
    return write.part == Part::superblock ||
           (write.part != Part::data &&
            (write.offset < adopted_ || metadata_on_disk_.contains(write.offset)));
}

void OrderedFile::resize(std::uint64_t size) {
    if (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0) throw_errno();
    disk_size_ = size;
}

void OrderedFile::commit(Order direction) {
    if (is_abandoned_) throw std::bad_alloc();
    open_seal();
    if (size_ > disk_size_) resize(size_);

    // Rank of each write: 0 new places, 1 superblock, 2 heaps, then trees from the root down, then headers.
    constexpr int header_rank = 1000;
    const auto rank = [&](const Write& write) {
        if (!is_on_disk(write)) return 0;
        if (write.part == Part::superblock) return 1;
        if (write.part == Part::heap) return 2;
        if (write.part == Part::tree) return header_rank - 1 - tree_level(write.bytes);
        return header_rank;
    };
    std::vector<std::pair<int, const Write*>> order;
    order.reserve(pending_.size());
    const int sign = direction == Order::growing ? 1 : -1;
    for (const Write& write : pending_) order.emplace_back(sign * rank(write), &write);
    std::stable_sort(
        order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [unused, write] : order) {
        // Before writing: after an error, what is half written has changed, too.
        sums_.mark_changed(write->offset, write->bytes.size());
        write_at(descriptor_, write->offset, write->bytes);
    }

    for (const Write& write : pending_) {
        if (write.part != Part::data) metadata_on_disk_.insert(write.offset);
    }
    pending_.clear();
    pending_metadata_.clear();
    if (size_ < disk_size_) resize(size_);
    // Other bytes can be there before the next seal.
    if (size_ < committed_) sums_.mark_changed(size_, committed_ - size_);
    committed_ = end_ = size_;
}

void OrderedFile::open_seal() {
    if (is_seal_open_) return;
    write_at(descriptor_, 0, write_seal({}));
    disk_size_ = std::max<std::uint64_t>(disk_size_, seal_block_bytes);
    is_seal_open_ = true;
}

void OrderedFile::seal() {
    if (is_abandoned_) throw std::bad_alloc();
    write_at(descriptor_, 0, write_seal({false, committed_, sums_.compute(descriptor_, committed_)}));
    is_seal_open_ = false;
}

void OrderedFile::abandon() noexcept {
    is_abandoned_ = true;
    pending_.clear();
    pending_metadata_.clear();
}

bool OrderedFile::has_name() const {
    struct stat status {};
    return ::fstat(descriptor_, &status) != 0 || status.st_nlink > 0;
}

bool OrderedFile::is_at(const std::filesystem::path& path) const {
    struct stat own {};
    struct stat named {};
    return ::fstat(descriptor_, &own) == 0 && ::stat(path.c_str(), &named) == 0 &&
           own.st_dev == named.st_dev && own.st_ino == named.st_ino;
}

}  // namespace gxrod
