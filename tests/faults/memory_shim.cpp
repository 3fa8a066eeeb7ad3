// Stands before the C library's allocation (LD_PRELOAD) and lets it fail:
//
//   MEMORY_AT   the number of the call from which on it fails, from 1
//   MEMORY_FOR  how many calls fail; by default 1
//   MEMORY_LOG  a file for the number of calls, at the process's end
//
// Allocations of HDF5 itself, and of the C library for it, are spared: it does not bear it, and may crash.
#include <link.h>
#include <malloc.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "shim_symbols.hpp"

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace {

using namespace gxrod::faults;

std::atomic<long> calls{0};
std::atomic<long> first{0};  // 0: none fails, as long as this library is not ready
std::atomic<long> last{0};

struct Range {
    std::uintptr_t begin, end;
};
std::array<Range, 2> spared{};  // addresses of the code of HDF5 and of the C library, which it calls

int find_spared(dl_phdr_info* library, std::size_t, void*) {
    const bool is_hdf5 = std::strstr(library->dlpi_name, "/libhdf5_serial.so") != nullptr;
    if (!is_hdf5 && std::strstr(library->dlpi_name, "/libc.so") == nullptr) return 0;
    for (int i = 0; i < library->dlpi_phnum; ++i) {
        const ElfW(Phdr)& segment = library->dlpi_phdr[i];
        if (segment.p_type != PT_LOAD || (segment.p_flags & PF_X) == 0) continue;
        const std::uintptr_t begin = library->dlpi_addr + segment.p_vaddr;
        spared[is_hdf5 ? 0 : 1] = {begin, begin + segment.p_memsz};
    }
    return 0;
}

[[gnu::constructor]] void read_fault() {
    ::dl_iterate_phdr(find_spared, nullptr);
    const long at = read_number("MEMORY_AT", 0);
    last = at + read_number("MEMORY_FOR", 1) - 1;
    first = at;
    calls = 0;
}

[[gnu::destructor]] void log_calls() {
    first = 0;
    const char* path = std::getenv("MEMORY_LOG");
    if (!path) return;
    const long made = calls;
    if (std::FILE* log = std::fopen(path, "w")) {
        std::fprintf(log, "%ld\n", made);
        std::fclose(log);
    }
}

bool fails(const void* caller) {
    const auto address = reinterpret_cast<std::uintptr_t>(caller);
    for (const Range& range : spared) {
        if (range.begin <= address && address < range.end) return false;
    }
    const long call = ++calls;
    if (first == 0 || call < first || call > last) return false;
    errno = ENOMEM;
    return true;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) { return fails(__builtin_return_address(0)) ? nullptr : __libc_malloc(size); }

void* calloc(std::size_t count, std::size_t size) {
    return fails(__builtin_return_address(0)) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) {
    return fails(__builtin_return_address(0)) ? nullptr : __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size) {
    return fails(__builtin_return_address(0)) ? nullptr : __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
    return fails(__builtin_return_address(0)) ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
    if (fails(__builtin_return_address(0))) return ENOMEM;
    *memory = __libc_memalign(alignment, size);
    return *memory ? 0 : ENOMEM;
}
}
