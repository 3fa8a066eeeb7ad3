#include "linear/fronts/front_order.hpp"

#include <cholmod.h>

#include <algorithm>
#include <cassert>

#include "linear/suite_sparse/suite_sparse.hpp"

namespace gxrod {
namespace {

// On blocks, of a factorization in the order of minimum degree. Below it nested dissection gains little, and
// takes ten times longer to order. Above it saves up to a half, in one of CHOLMOD's two ways or the other.
constexpr double many_operations = 5e6;

// Fronts become one if this leaves few blocks, or few of their entries zero.
constexpr std::size_t few_blocks[3] = {2, 6, 16};
constexpr double zeros[3] = {0.5, 0.1, 0.05};

// CHOLMOD on the graph of the blocks.
class Analysis {
  public:
    explicit Analysis(const BlockPartition& partition) {
        cholmod_l_start(&common_);
        common_.print = 0;
        common_.supernodal = CHOLMOD_SUPERNODAL;
        common_.nmethods = 1;
        common_.method[0].ordering = CHOLMOD_AMD;
        common_.method[1].ordering = CHOLMOD_METIS;
        common_.method[2].ordering = CHOLMOD_NESDIS;
        std::copy_n(few_blocks, 3, common_.nrelax);
        std::copy_n(zeros, 3, common_.zrelax);
        column_starts_.push_back(0);
        for (int block = 0; block < partition.count(); ++block) {
            rows_.push_back(block);
            for (std::size_t i = partition.neighbour_starts[block]; i < partition.neighbour_starts[block + 1];
                 ++i) {
                if (partition.neighbours[i] > block) rows_.push_back(partition.neighbours[i]);
            }
            column_starts_.push_back(static_cast<std::int64_t>(rows_.size()));
        }
        graph_.nrow = graph_.ncol = static_cast<std::size_t>(partition.count());
        graph_.nzmax = rows_.size();
        graph_.p = as_suite_sparse(column_starts_);
        graph_.i = as_suite_sparse(rows_);
        graph_.stype = -1;
        graph_.itype = CHOLMOD_LONG;
        graph_.xtype = CHOLMOD_PATTERN;
        graph_.sorted = graph_.packed = 1;
    }
    ~Analysis() {
        cholmod_l_free_factor(&factor_, &common_);
        cholmod_l_finish(&common_);
    }
    Analysis(const Analysis&) = delete;
    Analysis& operator=(const Analysis&) = delete;

    const cholmod_factor& find_best() {
        analyze();
        if (common_.fl >= many_operations) {
            common_.nmethods = 3;
            analyze();
        }
        return *factor_;
    }

  private:
    // By that of the first methods which fills in least.
    void analyze() {
        cholmod_l_free_factor(&factor_, &common_);
        factor_ = cholmod_l_analyze(&graph_, &common_);
        if (common_.status == CHOLMOD_OUT_OF_MEMORY) throw_no_memory_to_order();
        assert(factor_ && factor_->is_super);
    }

    std::vector<std::int64_t> column_starts_, rows_;
    cholmod_common common_{};
    cholmod_sparse graph_{};
    cholmod_factor* factor_ = nullptr;
};

template <class Number>
std::vector<Number> copy(const void* numbers, std::size_t count) {
    const auto* first = static_cast<const SuiteSparse_long*>(numbers);
    return std::vector<Number>(first, first + count);
}

}  // namespace

FrontOrder::FrontOrder(const BlockPartition& partition) {
    Analysis analysis(partition);
    const cholmod_factor& factor = analysis.find_best();
    blocks = copy<int>(factor.Perm, factor.n);
    starts = copy<int>(factor.super, factor.nsuper + 1);
    row_starts = copy<std::size_t>(factor.pi, factor.nsuper + 1);
    rows = copy<int>(factor.s, row_starts.back());
}

}  // namespace gxrod
