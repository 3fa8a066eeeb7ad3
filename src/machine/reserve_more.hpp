#pragma once

#include <algorithm>
#include <vector>

namespace gxrod {

// Makes room for `count` more entries: for exactly these if they are many, and for half as many again as
// there are now if they are few.
template <class T>
void reserve_more(std::size_t count, std::vector<T>& entries) {
    const std::size_t size = entries.size() + count;
    if (size > entries.capacity()) entries.reserve(std::max(size, entries.size() + entries.size() / 2));
}

}  // namespace gxrod
