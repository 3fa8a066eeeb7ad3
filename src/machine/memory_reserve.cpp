#include "machine/memory_reserve.hpp"

#include <sys/mman.h>

#include <new>

namespace gxrod {

void require_memory(std::size_t bytes) {
    void* const reserve = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (reserve == MAP_FAILED) throw std::bad_alloc();
    ::munmap(reserve, bytes);
}

}  // namespace gxrod
