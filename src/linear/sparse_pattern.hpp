#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace gxrod {

// Where a square sparse matrix can be non-zero. Its values lie column by column, rows ascending. Columns next
// to each other that have the same rows are one block, and rows that follow each other one run of it: what a
// node needs does not grow with the number of its entries.
class SparsePattern {
  public:
    struct RowRun {
        std::int64_t first;
        std::int32_t count;
        std::int32_t before;  // rows of the column in the runs before
    };
    struct Block {
        std::int64_t first_column, columns;
        std::int64_t first_entry;  // among the values
        std::int64_t stride;       // rows of each column, and so from column to column
        std::span<const RowRun> runs;
    };

    std::int64_t size() const { return starts_.back().column; }
    std::int64_t nonzeros() const { return starts_.back().entry; }
    std::size_t block_count() const { return starts_.size() - 1; }
    Block block(std::size_t index) const;
    // The block of a column.
    Block block_of(std::int64_t column) const;
    // The place of (row, column) among the values, which must be in the pattern.
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

    // Appends so many columns that have these rows, ascending.
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

    std::vector<Start> starts_{{0, 0, 0}};  // of each block, and the end of all
    std::vector<RowRun> runs_;
};

// The same entry by entry, as general solvers take it: by compressed columns.
struct CompressedColumns {
    std::vector<std::int64_t> column_starts{0};
    std::vector<std::int64_t> rows;

    CompressedColumns() = default;
    explicit CompressedColumns(const SparsePattern& pattern);

    std::int64_t size() const { return static_cast<std::int64_t>(column_starts.size()) - 1; }
    std::int64_t nonzeros() const { return static_cast<std::int64_t>(rows.size()); }
};

}  // namespace gxrod
