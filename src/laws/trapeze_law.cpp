#include "laws/trapeze_law.hpp"

#include "laws/layered_law.hpp"

namespace gxrod {

TrapezeLaw::TrapezeLaw(const Mat6& C, std::shared_ptr<const SectionLaw> inner)
    : c_(C(4, 4) + C(5, 5)),
      inner_(inner ? std::move(inner) : std::make_shared<LayeredLaw>(C, std::vector<Layer>{})),
      kinked_(as_kinked(*inner_)) {}

namespace {

// Adds what the term alone makes.
void add_coupling(double c, const Vec6& strain, Mat6& tangent) {
    const double extension = strain[0];
    const double twist = strain[3];
    tangent(0, 3) += c * twist;
    tangent(3, 0) += c * twist;
    tangent(3, 3) += c * extension;
}

}  // namespace

Mat6 TrapezeLaw::elastic_tangent(const Vec6& strain, std::span<const double> memory) const {
    Mat6 tangent = find_elastic_tangent(*inner_, strain, memory);
    add_coupling(c_, strain, tangent);
    return tangent;
}

std::vector<RelaxingStiffness> TrapezeLaw::relaxing_stiffness() const {
    return list_relaxing_stiffness(*inner_);
}

bool TrapezeLaw::is_at_limit(const Vec6& strain, std::span<const double> memory) const {
    return gxrod::is_at_limit(*inner_, strain, memory);
}

SectionResponse TrapezeLaw::respond(const Vec6& strain,
                                    std::span<const double> memory,
                                    double elapsed,
                                    std::span<double> after) const {
    SectionResponse response = inner_->respond(strain, memory, elapsed, after);
    add_shortening(strain, response);
    return response;
}

SectionResponse TrapezeLaw::respond_on(std::span<const int> pieces,
                                       const Vec6& strain,
                                       std::span<const double> memory,
                                       double elapsed,
                                       std::span<double> after) const {
    if (kinked_ == nullptr) return respond(strain, memory, elapsed, after);
    SectionResponse response = kinked_->respond_on(pieces, strain, memory, elapsed, after);
    add_shortening(strain, response);
    return response;
}

void TrapezeLaw::add_shortening(const Vec6& strain, SectionResponse& response) const {
    const double extension = strain[0];
    const double twist = strain[3];
    response.resultants[0] += 0.5 * c_ * twist * twist;
    response.resultants[3] += c_ * twist * extension;
    add_coupling(c_, strain, response.tangent);
    response.stored += 0.5 * c_ * twist * twist * extension;
}

}  // namespace gxrod
