#include "laws/layered_law.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

// Numbers of equations: docs/theory/laws.md.
namespace gxrod {
namespace {

// A layer's limit (L4) and how it follows the strains.
struct Limit {
    double value;
    Vec6 gradient = Vec6::Zero();
};

// A force has reached its limit if it is so near to it, relative.
constexpr double round_off = 1e-9;

double find_limit(const Layer& layer, double tension) {
    return layer.limit + layer.limit_per_tension * std::max(tension, 0.0);
}

Limit find_limit(const Layer& layer, bool is_pulled, const SectionResponse& response) {
    if (!is_pulled) return {layer.limit};
    return {layer.limit + layer.limit_per_tension * response.resultants[0],
            layer.limit_per_tension * response.tangent.row(0).transpose()};
}

}  // namespace

LayeredLaw::LayeredLaw(const Mat6& C, std::vector<Layer> layers) : stiffness_(C), layers_(std::move(layers)) {
    std::ranges::stable_partition(layers_,
                                  [](const Layer& layer) { return layer.on == StrainPart::tension; });
    for (const Layer& layer : layers_) {
        assert(layer.stiffness > 0.0 && layer.limit >= 0.0);
        assert(layer.on != StrainPart::tension || layer.limit_per_tension == 0.0);
        memory_size_ += entries_of(layer.on).count;
    }
}

// The layers on tension come first, so that the axial resultant is complete where limits ask for it.
template <class Choose>
SectionResponse LayeredLaw::respond_by(const Vec6& strain,
                                       std::span<const double> memory,
                                       std::span<double> after,
                                       Choose&& choose) const {
    SectionResponse response;
    response.resultants = stiffness_ * strain;
    response.tangent = stiffness_;
    response.stored = 0.5 * strain.dot(response.resultants);
    std::size_t at = 0;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        const auto choose_own = [&](unsigned found, double use) { return choose(i, found, use); };
        add(layers_[i], strain, &memory[at], after.empty() ? nullptr : &after[at], response, choose_own);
        at += static_cast<std::size_t>(entries_of(layers_[i].on).count);
    }
    return response;
}

// The axial resultant is that of all layers, as those on tension alone add to it.
Mat6 LayeredLaw::elastic_tangent(const Vec6& strain, std::span<const double> memory) const {
    const double tension = respond(strain, memory, 0.0, {}).resultants[0];
    Mat6 tangent = stiffness_;
    for (const Layer& layer : layers_) {
        if (!(find_limit(layer, tension) > 0.0)) continue;
        for (const int i : entries_of(layer.on).list()) tangent(i, i) += layer.stiffness;
    }
    return tangent;
}

bool LayeredLaw::is_at_limit(const Vec6& strain, std::span<const double> memory) const {
    const double tension = respond(strain, memory, 0.0, {}).resultants[0];
    std::size_t at = 0;
    for (const Layer& layer : layers_) {
        double size = 0.0;
        for (const int i : entries_of(layer.on).list())
            size = std::hypot(size, layer.stiffness * (strain[i] - memory[at++]));
        const double limit = find_limit(layer, tension);
        if (limit > 0.0 && size >= (1.0 - round_off) * limit) return true;
    }
    return false;
}

SectionResponse LayeredLaw::respond(const Vec6& strain,
                                    std::span<const double> memory,
                                    double,
                                    std::span<double> after) const {
    return respond_by(strain, memory, after, [](std::size_t, unsigned found, double) { return found; });
}

void LayeredLaw::find_pieces(const Vec6& strain,
                             std::span<const double> memory,
                             std::span<int> pieces) const {
    respond_by(strain, memory, {}, [&](std::size_t i, unsigned found, double use) {
        const unsigned piece = use >= 1.0 - at_its_limit ? found | slips : found;
        pieces[i] = static_cast<int>(piece);
        return piece;
    });
}

SectionResponse LayeredLaw::respond_on(std::span<const int> pieces,
                                       const Vec6& strain,
                                       std::span<const double> memory,
                                       double,
                                       std::span<double> after) const {
    return respond_by(strain, memory, after, [&](std::size_t i, unsigned, double) {
        return static_cast<unsigned>(pieces[i]);
    });
}

// (L2), (L3), (L5), (L6).
template <class Choose>
void LayeredLaw::add(const Layer& layer,
                     const Vec6& strain,
                     const double* slip,
                     double* slip_after,
                     SectionResponse& response,
                     Choose&& choose) const {
    const StrainEntries entries = entries_of(layer.on);
    const double k = layer.stiffness;
    std::array<double, 2> trial{};
    double size = 0.0;
    for (int a = 0; a < entries.count; ++a) {
        trial[a] = k * (strain[entries.index[a]] - slip[a]);
        size = a == 0 ? std::abs(trial[0]) : std::hypot(size, trial[a]);
    }
    const bool is_found_pulled = layer.limit_per_tension != 0.0 && response.resultants[0] > 0.0;
    const double most = find_limit(layer, is_found_pulled, response).value;
    const unsigned found = (is_found_pulled ? is_pulled : 0U) | (size <= most && most > 0.0 ? 0U : slips);
    const unsigned piece = choose(found, most > 0.0 ? size / most : 1.0);
    const Limit limit = find_limit(layer, (piece & is_pulled) != 0, response);
    const bool sticks = (piece & slips) == 0;
    const double share = sticks ? 1.0 : (size > 0.0 ? limit.value / size : 0.0);
    for (int a = 0; a < entries.count; ++a) {
        const int i = entries.index[a];
        const double direction = size > 0.0 ? trial[a] / size : 0.0;
        response.resultants[i] += share * trial[a];
        if (slip_after != nullptr) slip_after[a] = sticks ? slip[a] : slip[a] + (1.0 - share) * trial[a] / k;
        response.tangent(i, i) += share * k;
        if (sticks) continue;
        for (int b = 0; b < entries.count; ++b)
            response.tangent(i, entries.index[b]) -=
                share * k * direction * (size > 0.0 ? trial[b] / size : 0.0);
        if ((piece & is_pulled) != 0) response.tangent.row(i) += direction * limit.gradient.transpose();
    }
    const double held = sticks ? size : limit.value;
    response.stored += 0.5 * held * held / k;
    if (!sticks) response.dissipated += limit.value * (size - held) / k;
}

}  // namespace gxrod
