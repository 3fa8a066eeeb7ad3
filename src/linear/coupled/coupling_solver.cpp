#include "linear/coupled/coupling_solver.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <functional>
#include <iterator>

#include "linear/coupled/gmres.hpp"
#include "numerics/disjoint_sets.hpp"

namespace gxrod {

namespace {

// Of a level: two nodes of a branch, or an element of order 4.
constexpr std::int64_t widest_level = 24;
constexpr int most_iterations = 80;
// Of a block: rows of S that are smaller than the first by this are left out.
constexpr double least_row = 1e-12;

// Two blocks that have so many unknowns in common.
struct Meeting {
    std::int64_t shared;
    std::pair<int, int> blocks;
};

// Most of them first.
std::vector<Meeting> list_meetings(const std::vector<CouplingBlock>& blocks) {
    std::vector<std::pair<std::int64_t, int>> of_unknowns;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        for (const std::int64_t unknown : blocks[i].unknowns)
            of_unknowns.emplace_back(unknown, static_cast<int>(i));
    std::ranges::sort(of_unknowns);
    std::vector<std::pair<int, int>> pairs;
    for (auto first = of_unknowns.begin(); first != of_unknowns.end();) {
        auto last = first;
        for (; last != of_unknowns.end() && last->first == first->first; ++last) {
            for (auto other = first; other != last; ++other) pairs.emplace_back(other->second, last->second);
        }
        first = last;
    }
    std::ranges::sort(pairs);
    std::vector<Meeting> meetings;
    for (const std::pair<int, int>& one : pairs) {
        if (meetings.empty() || meetings.back().blocks != one) meetings.push_back({0, one});
        ++meetings.back().shared;
    }
    std::ranges::stable_sort(meetings, std::ranges::greater{}, &Meeting::shared);
    return meetings;
}

// Blocks with unknowns in common as one, up to half as large again as the largest: those of a place where two
// elements of one rod, or of both, touch. Larger ones save iterations, but cost more.
std::vector<CouplingBlock> join_neighbours(const std::vector<CouplingBlock>& blocks) {
    DisjointSets sets(blocks.size());
    std::vector<std::vector<std::int64_t>> unknowns;
    std::size_t most = 0;
    for (const CouplingBlock& block : blocks) {
        unknowns.push_back(block.unknowns);
        std::ranges::sort(unknowns.back());
        most = std::max(most, block.unknowns.size() + block.unknowns.size() / 2);
    }
    for (const Meeting& meeting : list_meetings(blocks)) {
        const int a = sets.find(meeting.blocks.first), b = sets.find(meeting.blocks.second);
        if (a == b) continue;
        std::vector<std::int64_t> both;
        std::ranges::set_union(unknowns[static_cast<std::size_t>(a)],
                               unknowns[static_cast<std::size_t>(b)],
                               std::back_inserter(both));
        if (both.size() > most) continue;
        sets.join(a, b);
        unknowns[static_cast<std::size_t>(sets.find(a))] = std::move(both);
    }
    std::vector<CouplingBlock> joined;
    std::vector<std::size_t> places(blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const auto set = static_cast<std::size_t>(sets.find(static_cast<int>(i)));
        if (set == i) {
            places[i] = joined.size();
            const auto size = static_cast<Eigen::Index>(unknowns[i].size());
            joined.push_back({unknowns[i], Eigen::MatrixXd::Zero(size, size)});
        }
        CouplingBlock& whole = joined[places[set]];
        std::vector<Eigen::Index> at;
        for (const std::int64_t unknown : blocks[i].unknowns)
            at.push_back(std::ranges::lower_bound(whole.unknowns, unknown) - whole.unknowns.begin());
        whole.matrix(at, at) += blocks[i].matrix;
    }
    return joined;
}

// B = Q S by Gram and Schmidt's method with pivots, up to what is small.
void split(Eigen::MatrixXd B, Eigen::MatrixXd& Q, Eigen::MatrixXd& S) {
    Q.resize(B.rows(), B.cols());
    S.resize(B.rows(), B.cols());
    Eigen::Index rank = 0, pivot = 0;
    Eigen::RowVectorXd norms = B.colwise().squaredNorm();
    const double least = least_row * std::sqrt(norms.maxCoeff(&pivot));
    for (; rank < B.cols() && std::sqrt(norms.maxCoeff(&pivot)) > least; ++rank) {
        Q.col(rank) = B.col(pivot).normalized();
        S.row(rank).noalias() = Q.col(rank).transpose() * B;
        B.noalias() -= Q.col(rank) * S.row(rank);
        norms = B.colwise().squaredNorm();
    }
    Q.conservativeResize(Eigen::NoChange, rank);
    S.conservativeResize(rank, Eigen::NoChange);
}

void leave_out_held(CouplingBlock& block) {
    std::vector<Eigen::Index> kept;
    for (std::size_t i = 0; i < block.unknowns.size(); ++i) {
        if (block.unknowns[i] >= 0) kept.push_back(static_cast<Eigen::Index>(i));
    }
    if (kept.size() == block.unknowns.size()) return;
    block.matrix = block.matrix(kept, kept).eval();
    std::erase(block.unknowns, -1);
}

}  // namespace

CouplingSolver::CouplingSolver(const SparsePattern& pattern, const ThreadTeam& team)
    : team_(&team),
      solver_(make_linear_solver(LinearSolverKind::automatic, pattern, team)),
      inverse_(pattern) {}

bool CouplingSolver::is_suitable() const { return inverse_.widest() <= widest_level; }

bool CouplingSolver::factorize(const std::vector<double>& values, std::vector<CouplingBlock> blocks) {
    values_ = values;
    if (!solver_->factorize(values_).regular) return false;
    inverse_.factorize(values_, *team_);
    for (CouplingBlock& block : blocks) leave_out_held(block);
    std::erase_if(blocks, [](const CouplingBlock& block) { return block.unknowns.empty(); });
    std::vector<CouplingBlock> joined = join_neighbours(blocks);
    blocks_.resize(joined.size());
    std::vector<char> is_finite(joined.size(), 1);
    team_->for_each(joined.size(), [&](std::size_t i) {
        Block& own = blocks_[i];
        own.unknowns = std::move(joined[i].unknowns);
        split(std::move(joined[i].matrix), own.Q, own.S);
        own.preconditioner = own.S * inverse_.invert(own.unknowns) * own.Q;
        own.preconditioner.diagonal().array() += 1.0;
        own.preconditioner = own.preconditioner.inverse().eval();
        is_finite[i] = own.preconditioner.allFinite() ? 1 : 0;
    });
    force_count_ = unknown_count_ = largest_ = 0;
    for (Block& block : blocks_) {
        block.first = force_count_;
        block.first_unknown = unknown_count_;
        force_count_ += block.Q.cols();
        unknown_count_ += block.Q.rows();
        largest_ = std::max(largest_, block.Q.rows());
    }
    return std::ranges::find(is_finite, 0) == is_finite.end();
}

// S R x of all blocks.
Eigen::VectorXd CouplingSolver::gather(const Eigen::VectorXd& x) const {
    Eigen::VectorXd forces(force_count_);
    team_->for_each_range(blocks_.size(), [&](std::size_t first, std::size_t last) {
        Eigen::VectorXd own(largest_);
        for (std::size_t i = first; i < last; ++i) {
            const Block& block = blocks_[i];
            Eigen::Index k = 0;
            for (const std::int64_t unknown : block.unknowns) own[k++] = x[unknown];
            forces.segment(block.first, block.S.rows()).noalias() = block.S * own.head(k);
        }
    });
    return forces;
}

Eigen::VectorXd CouplingSolver::precondition(const Eigen::VectorXd& forces) const {
    Eigen::VectorXd result(forces.size());
    team_->for_each_range(blocks_.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Block& block = blocks_[i];
            result.segment(block.first, block.S.rows()).noalias() =
                block.preconditioner * forces.segment(block.first, block.S.rows());
        }
    });
    return result;
}

// x −= Σ Rᵀ Q g.
void CouplingSolver::subtract(const Eigen::VectorXd& forces, Eigen::VectorXd& x) const {
    Eigen::VectorXd of_unknowns(unknown_count_);
    team_->for_each_range(blocks_.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Block& block = blocks_[i];
            of_unknowns.segment(block.first_unknown, block.Q.rows()).noalias() =
                block.Q * forces.segment(block.first, block.Q.cols());
        }
    });
    Eigen::Index k = 0;
    for (const Block& block : blocks_)
        for (const std::int64_t unknown : block.unknowns) x[unknown] -= of_unknowns[k++];
}

bool CouplingSolver::solve(Eigen::VectorXd& right_hand_side, double tolerance) {
    Eigen::VectorXd x = right_hand_side;
    solver_->solve(x);
    const auto apply = [&](const Eigen::VectorXd& v) {
        const Eigen::VectorXd forces = precondition(v);
        Eigen::VectorXd moved = Eigen::VectorXd::Zero(x.size());
        subtract(forces, moved);
        solver_->solve(moved);
        return Eigen::VectorXd(forces - gather(moved));
    };
    Eigen::VectorXd found;
    const GmresResult result =
        solve_by_gmres(apply, gather(x), tolerance * right_hand_side.norm(), most_iterations, found);
    iterations_ = result.iterations;
    if (!result.converged) return false;
    x = right_hand_side;
    subtract(precondition(found), x);
    solver_->solve(x);
    right_hand_side = std::move(x);
    return true;
}

}  // namespace gxrod
