#pragma once

#include "model/sections/section_law.hpp"

namespace gxrod {

// How near to its limit, relative to that, what yields or slips is taken to flow on in derivatives.
constexpr double at_its_limit = 1e-9;

// A law that is smooth only on each of its pieces: a surface yields or does not, a layer slips or sticks, a
// strain lies between two points of a table. Derivatives are those of the piece on which a section is. What
// has it is a SectionLaw, too.
class KinkedLaw {
  public:
    virtual ~KinkedLaw() = default;

    // Numbers that say on which piece a response is.
    virtual int piece_count() const = 0;
    // Finds these numbers. What is at its limit to rounding yields or slips, as if it flowed on.
    virtual void find_pieces(const Vec6& strain,
                             std::span<const double> memory,
                             std::span<int> pieces) const = 0;
    // The response on given pieces, which are continued smoothly beyond their kinks.
    virtual SectionResponse respond_on(std::span<const int> pieces,
                                       const Vec6& strain,
                                       std::span<const double> memory,
                                       double elapsed,
                                       std::span<double> after) const = 0;
};

// nullptr of a law that is smooth.
inline const KinkedLaw* as_kinked(const SectionLaw& law) { return dynamic_cast<const KinkedLaw*>(&law); }

}  // namespace gxrod
