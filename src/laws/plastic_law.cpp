#include "laws/plastic_law.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "laws/line_piece.hpp"
#include "numerics/eigenvalues.hpp"

// Numbers of equations: docs/theory/laws.md.
namespace gxrod {
namespace {

constexpr int most_iterations = 100;
// Resultants have reached a surface if they are so near to it, relative.
constexpr double round_off = 1e-9;

using Entries = PlasticLaw::Entries;

// How a scaled trial returns with β = Δγ/q: (L21).
struct Scaled {
    Entries shrunk;  // z
    double size;     // q = |z|
    double slope;    // ∂q/∂β, negative
};

Scaled scale(const Entries& trial, const Entries& rate, double beta) {
    Scaled scaled;
    const Entries shares = (1.0 + beta * rate.array()).inverse();
    scaled.shrunk = shares.cwiseProduct(trial);
    scaled.size = scaled.shrunk.norm();
    scaled.slope = -(rate.array() * shares.array() * scaled.shrunk.array().square()).sum() / scaled.size;
    return scaled;
}

}  // namespace

// What a return finds, in the surface's axes.
struct PlasticLaw::Return {
    double beta = 0.0;  // Δγ/q
    double flow = 0.0;  // Δγ, an energy
    Entries shrunk;     // z
    Square compliance;  // ∂(β z)/∂z_trial, symmetric
};

PlasticLaw::Surface PlasticLaw::make_surface(const Mat6& C,
                                             const std::vector<std::pair<int, double>>& limits,
                                             double kinematic) {
    const auto count = static_cast<Eigen::Index>(limits.size());
    Surface surface;
    surface.limits.resize(count);
    surface.hardening.resize(count);
    Square sum(count, count);
    surface.energy = 0.0;
    for (Eigen::Index a = 0; a < count; ++a) {
        const auto& [i, limit] = limits[static_cast<std::size_t>(a)];
        assert(limit > 0.0);
        surface.index.push_back(i);
        surface.limits[a] = limit;
        surface.hardening[a] = kinematic * C(i, i);
        surface.energy += limit * limit / C(i, i) / static_cast<double>(count);
    }
    for (Eigen::Index a = 0; a < count; ++a) {
        for (Eigen::Index b = 0; b < count; ++b) {
            const double hardening = a == b ? surface.hardening[a] : 0.0;
            sum(a, b) =
                (C(surface.index[a], surface.index[b]) + hardening) / (surface.limits[a] * surface.limits[b]);
        }
    }
    const SymmetricEigen eigen = find_symmetric_eigen(sum);
    surface.rate = eigen.values;
    surface.axes = eigen.vectors;
    return surface;
}

PlasticLaw::PlasticLaw(const Mat6& C, const YieldLimits& yield) : stiffness_(C), yield_(yield) {
    assert(!yield.limits.empty());
    if (yield.interaction == YieldInteraction::ellipsoid) {
        surfaces_.push_back(make_surface(C, yield.limits, yield.kinematic));
    } else {
        for (const auto& limit : yield.limits) surfaces_.push_back(make_surface(C, {limit}, yield.kinematic));
    }
    for (const Surface& surface : surfaces_) memory_size_ += static_cast<int>(surface.index.size()) + 1;
}

// Of the surface: r(a).
double PlasticLaw::factor(double gone) const {
    return yield_.isotropic ? yield_.isotropic->at(gone).value : 1.0;
}

auto PlasticLaw::harden(double gone, const int* piece) const -> Hardening {
    if (!yield_.isotropic) return {1.0, 0.0, gone};
    const PiecewiseLine& line = *yield_.isotropic;
    const auto [value, slope, integral] =
        piece == nullptr ? line.at(gone) : value_on_piece(line, gone, static_cast<std::size_t>(*piece));
    return {value, slope, integral};
}

// 1/q − 1/r of (L22) grows with β, nearly linearly: Newton's method, kept within a bracket. On a piece that
// is given β is near zero if it is negative, where the surface is continued inwards.
PlasticLaw::Return PlasticLaw::find_return(const Surface& surface,
                                           const Entries& trial,
                                           double gone,
                                           const int* piece) const {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const Entries& rate = surface.rate;
    const double span = (trial.norm() / factor(gone) - 1.0) / rate[0];
    double low = piece == nullptr ? 0.0 : -0.5 / rate[rate.size() - 1];
    double high = piece == nullptr ? span : 2.0 * std::abs(span) + 0.5 / rate[rate.size() - 1];
    double beta = 0.0;
    double stiffening = 0.0;  // ρ of (L23)
    Scaled scaled = scale(trial, rate, beta);
    for (int i = 0; i < most_iterations; ++i) {
        const Hardening hardening = harden(gone + beta * scaled.size / surface.energy, piece);
        const double limit = hardening.factor;
        stiffening = hardening.slope / surface.energy;
        const double value = 1.0 / scaled.size - 1.0 / limit;
        (value < 0.0 ? low : high) = beta;
        const double slope = -scaled.slope / (scaled.size * scaled.size) +
                             stiffening * (scaled.size + beta * scaled.slope) / (limit * limit);
        double next = beta - value / slope;
        if (!(next >= low && next <= high)) next = 0.5 * (low + high);
        const double slack = piece == nullptr ? 0.0 : epsilon / rate[0];
        const bool is_found = std::abs(next - beta) <= 2.0 * epsilon * std::abs(next) + slack;
        beta = next;
        scaled = scale(trial, rate, beta);
        if (is_found) break;
    }
    Return found{beta, beta * scaled.size, scaled.shrunk, {}};
    const Entries shares = (1.0 + beta * rate.array()).inverse();
    const Entries normal = shares.cwiseProduct(scaled.shrunk);
    const double flowing = stiffening * (scaled.size + beta * scaled.slope) - scaled.slope;
    found.compliance = (1.0 - stiffening * beta) / (scaled.size * flowing) * normal * normal.transpose();
    found.compliance.diagonal() += beta * shares;
    return found;
}

// Resultants from the centre of the surface, over their limits.
Entries PlasticLaw::scale_resultants(const Surface& surface,
                                     const Vec6& elastic,
                                     const double* memory) const {
    const auto count = static_cast<Eigen::Index>(surface.index.size());
    Entries scaled(count);
    for (Eigen::Index a = 0; a < count; ++a) {
        const double resultant = stiffness_.row(surface.index[a]).dot(elastic);
        scaled[a] = (resultant - surface.hardening[a] * memory[a]) / surface.limits[a];
    }
    return scaled;
}

Vec6 PlasticLaw::subtract_plastic(const Vec6& strain, std::span<const double> memory) const {
    Vec6 elastic = strain;
    std::size_t at = 0;
    for (const Surface& surface : surfaces_) {
        for (const int i : surface.index) elastic[i] -= memory[at++];
        ++at;
    }
    return elastic;
}

bool PlasticLaw::is_at_limit(const Vec6& strain, std::span<const double> memory) const {
    const Vec6 elastic = subtract_plastic(strain, memory);
    std::size_t at = 0;
    for (const Surface& surface : surfaces_) {
        const double gone = memory[at + surface.index.size()];
        const double size = scale_resultants(surface, elastic, &memory[at]).norm();
        if (size >= (1.0 - round_off) * factor(gone)) return true;
        at += surface.index.size() + 1;
    }
    return false;
}

// (L20) to (L26).
template <class Choose>
void PlasticLaw::add(const Surface& surface,
                     const Vec6& elastic_trial,
                     const double* memory,
                     double* after,
                     Vec6& elastic,
                     SectionResponse& response,
                     Choose&& choose) const {
    const auto count = static_cast<Eigen::Index>(surface.index.size());
    const double gone = memory[count];
    const Entries scaled = scale_resultants(surface, elastic_trial, memory);
    const double size = scaled.norm();
    const double limit = factor(gone);
    const int* piece = choose(size / limit);
    Return found;
    const bool yields = piece == nullptr ? size > limit : *piece != elastic_piece;
    if (!yields) piece = nullptr;
    if (yields) found = find_return(surface, surface.axes.transpose() * scaled, gone, piece);
    Entries flow = Entries::Zero(count);
    if (yields) flow = found.beta * (surface.axes * found.shrunk).cwiseQuotient(surface.limits);
    for (Eigen::Index a = 0; a < count; ++a) {
        const double plastic = memory[a] + flow[a];
        elastic[surface.index[a]] -= flow[a];
        response.stored += 0.5 * surface.hardening[a] * plastic * plastic;
        if (after != nullptr) after[a] = plastic;
    }
    const double gone_after = gone + found.flow / surface.energy;
    if (after != nullptr) after[count] = gone_after;
    if (yield_.isotropic)
        response.stored += surface.energy * (harden(gone_after, piece).integral - gone_after);
    response.dissipated += found.flow;
    if (!yields) return;
    Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 6, 6> rows(count, 6);
    for (Eigen::Index a = 0; a < count; ++a)
        rows.row(a) = stiffness_.row(surface.index[a]) / surface.limits[a];
    const Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 6, 6> turned = surface.axes.transpose() * rows;
    response.tangent -= turned.transpose() * found.compliance * turned;
}

template <class Choose>
SectionResponse PlasticLaw::respond_by(const Vec6& strain,
                                       std::span<const double> memory,
                                       std::span<double> after,
                                       Choose&& choose) const {
    SectionResponse response;
    response.tangent = stiffness_;
    const Vec6 trial = subtract_plastic(strain, memory);
    Vec6 elastic = trial;
    std::size_t at = 0;
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        add(surfaces_[i],
            trial,
            &memory[at],
            after.empty() ? nullptr : &after[at],
            elastic,
            response,
            [&](double use) { return choose(i, use); });
        at += surfaces_[i].index.size() + 1;
    }
    response.resultants = stiffness_ * elastic;
    response.stored += 0.5 * elastic.dot(response.resultants);
    return response;
}

SectionResponse PlasticLaw::respond(const Vec6& strain,
                                    std::span<const double> memory,
                                    double,
                                    std::span<double> after) const {
    return respond_by(strain, memory, after, [](std::size_t, double) -> const int* { return nullptr; });
}

void PlasticLaw::find_pieces(const Vec6& strain,
                             std::span<const double> memory,
                             std::span<int> pieces) const {
    std::vector<double> after(memory.size());
    respond_by(strain, memory, after, [&](std::size_t i, double use) -> const int* {
        pieces[i] = use > 1.0 - at_its_limit ? 0 : elastic_piece;
        return nullptr;
    });
    std::size_t at = 0;
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        at += surfaces_[i].index.size();
        if (pieces[i] != elastic_piece && yield_.isotropic)
            pieces[i] = static_cast<int>(find_line_piece(*yield_.isotropic, after[at]));
        ++at;
    }
}

SectionResponse PlasticLaw::respond_on(std::span<const int> pieces,
                                       const Vec6& strain,
                                       std::span<const double> memory,
                                       double,
                                       std::span<double> after) const {
    return respond_by(strain, memory, after, [&](std::size_t i, double) -> const int* { return &pieces[i]; });
}

}  // namespace gxrod
