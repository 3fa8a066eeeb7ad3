#include "laws/fibre_law.hpp"

#include <algorithm>

// Numbers of equations: docs/theory/laws.md.
namespace gxrod {
namespace {

// A stress has reached its limit if it is so near to it, relative.
constexpr double round_off = 1e-9;

}  // namespace

FibreLaw::FibreLaw(LayeredLaw rest, std::vector<Fibre> fibres, double E, double yield_stress)
    : FibreLaw(std::move(rest), {{std::move(fibres), E, yield_stress}}) {}

FibreLaw::FibreLaw(LayeredLaw rest, const std::vector<FibreGroup>& groups) : rest_(std::move(rest)) {
    for (const FibreGroup& group : groups) {
        for (std::size_t i = 0; i < group.fibres.size(); ++i) {
            const auto lane = static_cast<Eigen::Index>(i % block_size);
            if (lane == 0) {
                blocks_.push_back({.modulus = group.E,
                                   .limit = group.yield_stress,
                                   .first = fibre_count_ + static_cast<int>(i),
                                   .count = 0});
            }
            Block& block = blocks_.back();
            block.y[lane] = group.fibres[i].y;
            block.z[lane] = group.fibres[i].z;
            block.area[lane] = group.fibres[i].area;
            ++block.count;
        }
        fibre_count_ += static_cast<int>(group.fibres.size());
    }
}

FibreLaw::Lanes FibreLaw::find_trial(const Block& block, const Vec6& strain, const double* plastic) {
    Lanes slip = Lanes::Zero();
    slip.head(block.count) = Eigen::Map<const Eigen::ArrayXd>(plastic, block.count);
    return block.modulus * (strain[0] + strain[4] * block.z - strain[5] * block.y - slip);
}

// (L30).
template <class Hold>
void FibreLaw::add_fibres(const Vec6& strain,
                          std::span<const double> memory,
                          std::span<double> after,
                          SectionResponse& response,
                          Hold&& hold) const {
    const auto first = static_cast<std::size_t>(rest_.memory_size());
    double stored = 0.0, dissipated = 0.0;
    Vec3 forces = Vec3::Zero();   // N, My, Mz
    Mat3 tangent = Mat3::Zero();  // by Γx, Ky, Kz; the lower half
    for (const Block& block : blocks_) {
        const std::size_t at = first + static_cast<std::size_t>(block.first);
        const Lanes trial = find_trial(block, strain, &memory[at]);
        const Held held = hold(block, trial);
        const Lanes& stress = held.stress;
        const Lanes slip = (trial - stress) / block.modulus;
        const Lanes force = block.area * stress;
        const Lanes stiffness = held.elastic * block.area * block.modulus;
        forces += Vec3(force.sum(), (force * block.z).sum(), -(force * block.y).sum());
        const Lanes by_y = stiffness * block.y, by_z = stiffness * block.z;
        tangent(0, 0) += stiffness.sum();
        tangent(1, 0) += by_z.sum();
        tangent(2, 0) -= by_y.sum();
        tangent(1, 1) += (by_z * block.z).sum();
        tangent(2, 1) -= (by_z * block.y).sum();
        tangent(2, 2) += (by_y * block.y).sum();
        stored += 0.5 * (force * stress).sum() / block.modulus;
        dissipated += (force * slip).sum();
        if (after.empty()) continue;
        Eigen::Map<Eigen::ArrayXd>(&after[at], block.count) =
            Eigen::Map<const Eigen::ArrayXd>(&memory[at], block.count) + slip.head(block.count);
    }
    constexpr std::array<int, 3> entries{0, 4, 5};
    for (int a = 0; a < 3; ++a) {
        response.resultants[entries[a]] += forces[a];
        for (int b = 0; b < 3; ++b)
            response.tangent(entries[a], entries[b]) += tangent(std::max(a, b), std::min(a, b));
    }
    response.stored += stored;
    response.dissipated += dissipated;
}

SectionResponse FibreLaw::respond(const Vec6& strain,
                                  std::span<const double> memory,
                                  double elapsed,
                                  std::span<double> after) const {
    SectionResponse response = rest_.respond(strain, memory, elapsed, after);
    add_fibres(strain, memory, after, response, [](const Block& block, const Lanes& trial) -> Held {
        return {trial.min(block.limit).max(-block.limit), (trial.abs() <= block.limit).cast<double>()};
    });
    return response;
}

Mat6 FibreLaw::elastic_tangent(const Vec6& strain, std::span<const double> memory) const {
    SectionResponse response;
    response.tangent = rest_.elastic_tangent(strain, memory);
    const auto stick = [](const Block&, const Lanes& trial) -> Held { return {trial, Lanes::Ones()}; };
    add_fibres(strain, memory, {}, response, stick);
    return response.tangent;
}

bool FibreLaw::is_at_limit(const Vec6& strain, std::span<const double> memory) const {
    if (rest_.is_at_limit(strain, memory)) return true;
    SectionResponse ignored;
    bool is_at = false;
    add_fibres(strain, memory, {}, ignored, [&](const Block& block, const Lanes& trial) -> Held {
        is_at = is_at || (trial.abs() >= (1.0 - round_off) * block.limit).any();
        return {trial, Lanes::Ones()};
    });
    return is_at;
}

// Elastic: 0. Yields in tension: 1, in compression: −1.
void FibreLaw::find_pieces(const Vec6& strain, std::span<const double> memory, std::span<int> pieces) const {
    const auto first = static_cast<std::size_t>(rest_.piece_count());
    rest_.find_pieces(strain, memory, pieces.first(first));
    SectionResponse ignored;
    add_fibres(strain, memory, {}, ignored, [&](const Block& block, const Lanes& trial) -> Held {
        for (int lane = 0; lane < block.count; ++lane) {
            const double use = trial[lane] / block.limit;
            pieces[first + static_cast<std::size_t>(block.first + lane)] =
                use >= 1.0 - at_its_limit ? 1 : (use <= at_its_limit - 1.0 ? -1 : 0);
        }
        return {trial, Lanes::Ones()};
    });
}

SectionResponse FibreLaw::respond_on(std::span<const int> pieces,
                                     const Vec6& strain,
                                     std::span<const double> memory,
                                     double elapsed,
                                     std::span<double> after) const {
    const auto first = static_cast<std::size_t>(rest_.piece_count());
    SectionResponse response = rest_.respond_on(pieces.first(first), strain, memory, elapsed, after);
    add_fibres(strain, memory, after, response, [&](const Block& block, const Lanes& trial) {
        Held held{trial, Lanes::Ones()};
        for (int lane = 0; lane < block.count; ++lane) {
            const int piece = pieces[first + static_cast<std::size_t>(block.first + lane)];
            if (piece == 0) continue;
            held.stress[lane] = piece * block.limit;
            held.elastic[lane] = 0.0;
        }
        return held;
    });
    return response;
}

}  // namespace gxrod
