#include "laws/mixed_law.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace gxrod {
namespace {

int count_pieces(const SectionLaw& law) {
    const KinkedLaw* kinked = as_kinked(law);
    return kinked == nullptr ? 0 : kinked->piece_count();
}

// Cuts off the first numbers of a span.
template <class Span>
Span take(Span& all, int count) {
    if (all.empty()) return all;
    const Span first = all.first(static_cast<std::size_t>(count));
    all = all.subspan(static_cast<std::size_t>(count));
    return first;
}

void add_response(double share, const SectionResponse& part, SectionResponse& whole) {
    whole.resultants += share * part.resultants;
    whole.tangent += share * part.tangent;
    whole.stored += share * part.stored;
    whole.dissipated += share * part.dissipated;
}

}  // namespace

MixedLaw::MixedLaw(std::shared_ptr<const SectionLaw> a, std::shared_ptr<const SectionLaw> b, double t)
    : shares_{{{1.0 - t, std::move(a)}, {t, std::move(b)}}} {}

int MixedLaw::memory_size() const { return shares_[0].law->memory_size() + shares_[1].law->memory_size(); }

int MixedLaw::piece_count() const { return count_pieces(*shares_[0].law) + count_pieces(*shares_[1].law); }

std::string MixedLaw::describe() const {
    const std::string first = shares_[0].law->describe();
    const std::string second = shares_[1].law->describe();
    return first == second ? first : first + "; mixed with: " + second;
}

SectionResponse MixedLaw::respond(const Vec6& strain,
                                  std::span<const double> memory,
                                  double elapsed,
                                  std::span<double> after) const {
    SectionResponse response;
    for (const auto& [share, law] : shares_) {
        const int size = law->memory_size();
        const auto before = take(memory, size);
        add_response(share, law->respond(strain, before, elapsed, take(after, size)), response);
    }
    return response;
}

Mat6 MixedLaw::elastic_tangent(const Vec6& strain, std::span<const double> memory) const {
    Mat6 tangent = Mat6::Zero();
    for (const auto& [share, law] : shares_)
        tangent += share * find_elastic_tangent(*law, strain, take(memory, law->memory_size()));
    return tangent;
}

std::vector<RelaxingStiffness> MixedLaw::relaxing_stiffness() const {
    std::vector<RelaxingStiffness> list;
    for (const auto& [share, law] : shares_) {
        for (const RelaxingStiffness& one : list_relaxing_stiffness(*law)) {
            auto found = std::ranges::find(list, one.time, &RelaxingStiffness::time);
            if (found == list.end()) found = list.insert(list.end(), {one.time, Mat6::Zero()});
            found->stiffness += share * one.stiffness;
        }
    }
    return list;
}

bool MixedLaw::is_at_limit(const Vec6& strain, std::span<const double> memory) const {
    return std::ranges::any_of(shares_, [&](const LawShare& one) {
        return gxrod::is_at_limit(*one.law, strain, take(memory, one.law->memory_size()));
    });
}

void MixedLaw::find_pieces(const Vec6& strain, std::span<const double> memory, std::span<int> pieces) const {
    for (const auto& [share, law] : shares_) {
        const auto before = take(memory, law->memory_size());
        const auto own = take(pieces, count_pieces(*law));
        if (const KinkedLaw* kinked = as_kinked(*law)) kinked->find_pieces(strain, before, own);
    }
}

SectionResponse MixedLaw::respond_on(std::span<const int> pieces,
                                     const Vec6& strain,
                                     std::span<const double> memory,
                                     double elapsed,
                                     std::span<double> after) const {
    SectionResponse response;
    for (const auto& [share, law] : shares_) {
        const int size = law->memory_size();
        const auto before = take(memory, size);
        const auto next = take(after, size);
        const auto own = take(pieces, count_pieces(*law));
        const KinkedLaw* kinked = as_kinked(*law);
        add_response(share,
                     kinked == nullptr ? law->respond(strain, before, elapsed, next)
                                       : kinked->respond_on(own, strain, before, elapsed, next),
                     response);
    }
    return response;
}

std::shared_ptr<const SectionLaw> mix_laws(const std::shared_ptr<const SectionLaw>& a,
                                           const std::shared_ptr<const SectionLaw>& b,
                                           double t) {
    if (t <= 0.0 || a == b) return a;
    if (t >= 1.0) return b;
    return std::make_shared<const MixedLaw>(a, b, t);
}

}  // namespace gxrod
