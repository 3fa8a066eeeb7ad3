#include "mesh/chains.hpp"

#include <algorithm>
#include <cassert>
#include <unordered_map>

namespace gxrod {
namespace {

class ChainFinder {
  public:
    explicit ChainFinder(const std::vector<std::array<std::size_t, 2>>& ends)
        : ends_(ends), is_used_(ends.size()) {
        for (std::size_t e = 0; e < ends.size(); ++e) {
            assert(ends[e][0] != ends[e][1]);
            for (const std::size_t node : ends[e]) elements_at_[node].push_back(e);
        }
    }

    std::vector<Chain> find_all() {
        std::vector<Chain> chains;
        for (std::size_t e = 0; e < ends_.size(); ++e) {
            if (!is_used_[e]) chains.push_back(find_chain(e));
        }
        return chains;
    }

  private:
    std::size_t end_of(const ChainLink& link) const { return ends_[link.element][link.is_reversed ? 0 : 1]; }
    std::size_t start_of(const ChainLink& link) const {
        return ends_[link.element][link.is_reversed ? 1 : 0];
    }

    // Adds links from the end of the last one, to a free end, a branch or the start of the chain.
    void extend(std::vector<ChainLink>& links) {
        while (true) {
            const std::size_t node = end_of(links.back());
            const std::vector<std::size_t>& here = elements_at_.at(node);
            if (here.size() != 2) return;
            const std::size_t next = here[0] == links.back().element ? here[1] : here[0];
            if (is_used_[next]) return;
            is_used_[next] = true;
            links.push_back({next, ends_[next][1] == node});
        }
    }

    static void reverse(std::vector<ChainLink>& links) {
        std::reverse(links.begin(), links.end());
        for (ChainLink& link : links) link.is_reversed = !link.is_reversed;
    }

    bool is_free(std::size_t node) const { return elements_at_.at(node).size() == 1; }

    Chain find_chain(std::size_t first) {
        is_used_[first] = true;
        Chain chain{{{first}}, false};
        extend(chain.links);
        const std::size_t end = end_of(chain.links.back());
        chain.is_closed = end == start_of(chain.links.front()) && elements_at_.at(end).size() == 2;
        if (chain.is_closed) return chain;
        // The same from the other end of the first element.
        reverse(chain.links);
        extend(chain.links);
        reverse(chain.links);
        const bool starts_free = is_free(start_of(chain.links.front()));
        if (!starts_free && is_free(end_of(chain.links.back()))) reverse(chain.links);
        return chain;
    }

    const std::vector<std::array<std::size_t, 2>>& ends_;
    std::vector<bool> is_used_;
    std::unordered_map<std::size_t, std::vector<std::size_t>> elements_at_;
};

}  // namespace

std::vector<Chain> find_chains(const std::vector<std::array<std::size_t, 2>>& ends) {
    return ChainFinder(ends).find_all();
}

}  // namespace gxrod
