#include "laws/moved_law.hpp"

#include <utility>

namespace gxrod {

MovedLaw::MovedLaw(const SectionFrame& frame, std::shared_ptr<const SectionLaw> law)
    : to_frame_(compute_strain_map(frame)), law_(std::move(law)), kinked_(as_kinked(*law_)) {}

SectionResponse MovedLaw::move_back(SectionResponse response) const {
    response.resultants = to_frame_.transpose() * response.resultants;
    response.tangent = to_frame_.transpose() * response.tangent * to_frame_;
    return response;
}

SectionResponse MovedLaw::respond(const Vec6& strain,
                                  std::span<const double> memory,
                                  double elapsed,
                                  std::span<double> after) const {
    return move_back(law_->respond(to_frame_ * strain, memory, elapsed, after));
}

Mat6 MovedLaw::elastic_tangent(const Vec6& strain, std::span<const double> memory) const {
    return to_frame_.transpose() * find_elastic_tangent(*law_, to_frame_ * strain, memory) * to_frame_;
}

std::vector<RelaxingStiffness> MovedLaw::relaxing_stiffness() const {
    std::vector<RelaxingStiffness> list = list_relaxing_stiffness(*law_);
    for (RelaxingStiffness& one : list) one.stiffness = to_frame_.transpose() * one.stiffness * to_frame_;
    return list;
}

bool MovedLaw::is_at_limit(const Vec6& strain, std::span<const double> memory) const {
    return gxrod::is_at_limit(*law_, to_frame_ * strain, memory);
}

void MovedLaw::find_pieces(const Vec6& strain, std::span<const double> memory, std::span<int> pieces) const {
    if (kinked_ != nullptr) kinked_->find_pieces(to_frame_ * strain, memory, pieces);
}

SectionResponse MovedLaw::respond_on(std::span<const int> pieces,
                                     const Vec6& strain,
                                     std::span<const double> memory,
                                     double elapsed,
                                     std::span<double> after) const {
    if (kinked_ == nullptr) return respond(strain, memory, elapsed, after);
    return move_back(kinked_->respond_on(pieces, to_frame_ * strain, memory, elapsed, after));
}

}  // namespace gxrod
