#pragma once

#include <algorithm>
#include <vector>

namespace gxrod {

// Makes room for so many entries more: for exactly these where they are most of all, and for growth by halves
// where they are few.
template <class T>
void reserve_more(std::size_t count, std::vector<T>& entries) {
    const std::size_t size = entries.size() + count;
    if (size > entries.capacity()) entries.reserve(std::max(size, entries.size() + entries.size() / 2));
}

}  // namespace gxrod
