#include "laws/fibre_law.hpp"

#include <algorithm>

// Numbers of equations: docs/theory/laws.md.
namespace gxrod {
namespace {

// A stress has reached its limit if it is so near to it, relative.
constexpr double round_off = 1e-9;

}  // namespace

FibreLaw::FibreLaw(LayeredLaw rest, std::vector<Fibre> fibres, double E, double yield_stress)
    : rest_(std::move(rest)),
      modulus_(E),
      limit_(yield_stress),
      fibre_count_(static_cast<int>(fibres.size())),
      blocks_((fibres.size() + block_size - 1) / block_size) {
    for (std::size_t i = 0; i < fibres.size(); ++i) {
        Block& block = blocks_[i / block_size];
        const auto lane = static_cast<Eigen::Index>(i % block_size);
        block.y[lane] = fibres[i].y;
        block.z[lane] = fibres[i].z;
        block.area[lane] = fibres[i].area;
    }
}

FibreLaw::Lanes FibreLaw::find_trial(const Block& block,
                                     const Vec6& strain,
                                     const double* plastic,
                                     int count) const {
    Lanes slip = Lanes::Zero();
    slip.head(count) = Eigen::Map<const Eigen::ArrayXd>(plastic, count);
    return modulus_ * (strain[0] + strain[4] * block.z - strain[5] * block.y - slip);
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
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const Block& block = blocks_[i];
        const std::size_t at = first + i * block_size;
        const int count = std::min(block_size, fibre_count_ - static_cast<int>(i) * block_size);
        const Lanes trial = find_trial(block, strain, &memory[at], count);
        const Held held = hold(i, trial);
        const Lanes& stress = held.stress;
        const Lanes slip = (trial - stress) / modulus_;
        const Lanes force = block.area * stress;
        const Lanes stiffness = held.elastic * block.area * modulus_;
        forces += Vec3(force.sum(), (force * block.z).sum(), -(force * block.y).sum());
        const Lanes by_y = stiffness * block.y, by_z = stiffness * block.z;
        tangent(0, 0) += stiffness.sum();
        tangent(1, 0) += by_z.sum();
        tangent(2, 0) -= by_y.sum();
        tangent(1, 1) += (by_z * block.z).sum();
        tangent(2, 1) -= (by_z * block.y).sum();
        tangent(2, 2) += (by_y * block.y).sum();
        stored += 0.5 * (force * stress).sum() / modulus_;
        dissipated += (force * slip).sum();
        if (after.empty()) continue;
        Eigen::Map<Eigen::ArrayXd>(&after[at], count) =
            Eigen::Map<const Eigen::ArrayXd>(&memory[at], count) + slip.head(count);
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
    add_fibres(strain, memory, after, response, [&](std::size_t, const Lanes& trial) -> Held {
        return {trial.min(limit_).max(-limit_), (trial.abs() <= limit_).cast<double>()};
    });
    return response;
}

Mat6 FibreLaw::elastic_tangent(const Vec6& strain, std::span<const double> memory) const {
    SectionResponse response;
    response.tangent = rest_.elastic_tangent(strain, memory);
    const auto stick = [](std::size_t, const Lanes& trial) -> Held { return {trial, Lanes::Ones()}; };
    add_fibres(strain, memory, {}, response, stick);
    return response.tangent;
}

bool FibreLaw::is_at_limit(const Vec6& strain, std::span<const double> memory) const {
    if (rest_.is_at_limit(strain, memory)) return true;
    SectionResponse ignored;
    bool is_at = false;
    add_fibres(strain, memory, {}, ignored, [&](std::size_t, const Lanes& trial) -> Held {
        is_at = is_at || (trial.abs() >= (1.0 - round_off) * limit_).any();
        return {trial, Lanes::Ones()};
    });
    return is_at;
}

// Elastic: 0. Yields in tension: 1, in compression: −1.
void FibreLaw::find_pieces(const Vec6& strain, std::span<const double> memory, std::span<int> pieces) const {
    const auto first = static_cast<std::size_t>(rest_.piece_count());
    rest_.find_pieces(strain, memory, pieces.first(first));
    SectionResponse ignored;
    add_fibres(strain, memory, {}, ignored, [&](std::size_t i, const Lanes& trial) -> Held {
        for (std::size_t lane = 0; lane < block_size; ++lane) {
            const std::size_t fibre = i * block_size + lane;
            if (fibre >= static_cast<std::size_t>(fibre_count_)) break;
            const double use = trial[static_cast<Eigen::Index>(lane)] / limit_;
            pieces[first + fibre] = use >= 1.0 - at_its_limit ? 1 : (use <= at_its_limit - 1.0 ? -1 : 0);
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
    add_fibres(strain, memory, after, response, [&](std::size_t i, const Lanes& trial) {
        Held held{trial, Lanes::Ones()};
        for (std::size_t lane = 0; lane < block_size; ++lane) {
            const std::size_t fibre = i * block_size + lane;
            if (fibre >= static_cast<std::size_t>(fibre_count_)) break;
            const int piece = pieces[first + fibre];
            if (piece == 0) continue;
            held.stress[static_cast<Eigen::Index>(lane)] = piece * limit_;
            held.elastic[static_cast<Eigen::Index>(lane)] = 0.0;
        }
        return held;
    });
    return response;
}

}  // namespace gxrod
