#include "laws/trapeze_law.hpp"

#include "laws/layered_law.hpp"

namespace gxrod {

TrapezeLaw::TrapezeLaw(const Mat6& C, std::shared_ptr<const SectionLaw> inner)
    : c_(C(4, 4) + C(5, 5)),
      inner_(inner ? std::move(inner) : std::make_shared<LayeredLaw>(C, std::vector<Layer>{})) {}

SectionResponse TrapezeLaw::respond(const Vec6& strain,
                                    std::span<const double> memory,
                                    double elapsed,
                                    std::span<double> after) const {
    SectionResponse response = inner_->respond(strain, memory, elapsed, after);
    const double extension = strain[0];
    const double twist = strain[3];
    response.resultants[0] += 0.5 * c_ * twist * twist;
    response.resultants[3] += c_ * twist * extension;
    response.tangent(0, 3) += c_ * twist;
    response.tangent(3, 0) += c_ * twist;
    response.tangent(3, 3) += c_ * extension;
    response.stored += 0.5 * c_ * twist * twist * extension;
    return response;
}

}  // namespace gxrod
