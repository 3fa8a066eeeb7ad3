#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace gxrod {

// The non-zero entries of a square sparse matrix. Its values lie column by column, rows ascending. Adjacent
// columns with the same rows form a block, and consecutive rows a run of it: the memory for a node does not
// grow with the number of its entries.
class SparsePattern {
  public:
    struct RowRun {
        std::int64_t first;
        std::int32_t count;
        std::int32_t before;  // number of the column's rows in earlier runs
    };
    struct Block {
        std::int64_t first_column, columns;
        std::int64_t first_entry;  // index among the values
        std::int64_t stride;       // number of rows of each column, and distance of columns
        std::span<const RowRun> runs;
    };

    std::int64_t size() const { return starts_.back().column; }
    std::int64_t nonzeros() const { return starts_.back().entry; }
    std::size_t block_count() const { return starts_.size() - 1; }
    Block block(std::size_t index) const;
    // Returns the block of a column.
    Block block_of(std::int64_t column) const;
    // Returns the place of (row, column) among the values; it must be in the pattern.
    std::int64_t slot(std::int64_t row, std::int64_t column) const;

    // Calls visit(row, slot) for each entry of a column.
    template <class Visitor>
    void visit_column(std::int64_t column, Visitor&& visit) const {
        visit_column(block_of(column), column, visit);
    }
    // Calls visit(row, column, slot) for each entry.
    template <class Visitor>
    void visit_entries(Visitor&& visit) const {
        for (std::size_t index = 0; index < block_count(); ++index) {
            const Block columns = block(index);
            for (std::int64_t i = 0; i < columns.columns; ++i) {
                const std::int64_t column = columns.first_column + i;
                visit_column(columns, column, [&](auto row, auto slot) { visit(row, column, slot); });
            }
        }
    }

    // Appends columns, all with these rows, ascending.
    void add_columns(std::int64_t columns, std::span<const std::int64_t> rows);
    void reserve(std::size_t blocks);

  private:
    struct Start {
        std::int64_t column, entry;
        std::size_t run;
    };

    template <class Visitor>
    static void visit_column(const Block& block, std::int64_t column, Visitor&& visit) {
        std::int64_t slot = block.first_entry + (column - block.first_column) * block.stride;
        for (const RowRun& run : block.runs) {
            for (std::int32_t i = 0; i < run.count; ++i) visit(run.first + i, slot++);
        }
    }

    std::vector<Start> starts_{{0, 0, 0}};  // for each block, and the end of all
    std::vector<RowRun> runs_;
};

// The same pattern entry by entry, in compressed columns, for general solvers.
struct CompressedColumns {
    std::vector<std::int64_t> column_starts{0};
    std::vector<std::int64_t> rows;

    CompressedColumns() = default;
    explicit CompressedColumns(const SparsePattern& pattern);

    std::int64_t size() const { return static_cast<std::int64_t>(column_starts.size()) - 1; }
    std::int64_t nonzeros() const { return static_cast<std::int64_t>(rows.size()); }
};

}  // namespace gxrod
