#pragma once

#include "model/sections/section_law.hpp"

namespace gxrod {

// Relative distance from its limit within which a law is taken to yield or slip in derivatives.
constexpr double at_its_limit = 1e-9;

// A law that is smooth only on each of its pieces: a surface yields or does not, a layer slips or sticks, a
// strain lies between two points of a table. Derivatives belong to the piece of the current state. A class
// with this interface is a SectionLaw, too.
class KinkedLaw {
  public:
    virtual ~KinkedLaw() = default;

    // The number of integers that identify the piece of a response.
    virtual int piece_count() const = 0;
    // Finds these integers. Parts at their limit to rounding count as yielding or slipping.
    virtual void find_pieces(const Vec6& strain,
                             std::span<const double> memory,
                             std::span<int> pieces) const = 0;
    // Computes the response on given pieces, which are continued smoothly beyond their kinks.
    virtual SectionResponse respond_on(std::span<const int> pieces,
                                       const Vec6& strain,
                                       std::span<const double> memory,
                                       double elapsed,
                                       std::span<double> after) const = 0;
};

// Casts to a kinked law; nullptr for a smooth law.
inline const KinkedLaw* as_kinked(const SectionLaw& law) { return dynamic_cast<const KinkedLaw*>(&law); }

}  // namespace gxrod
