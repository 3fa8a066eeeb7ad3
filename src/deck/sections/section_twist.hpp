#pragma once

#include <utility>
#include <vector>

#include "deck/places/build_context.hpp"
#include "deck/sections/section_files.hpp"

namespace gxrod {

// The turn of the section about the tangent since the start, by the fraction of the length.
class SectionTwist {
  public:
    // Of fractions and angles, linear between them.
    explicit SectionTwist(std::vector<std::pair<double, double>> rows) : rows_(std::move(rows)) {}
    // Of the key twist of a rod or of its rest.
    explicit SectionTwist(const CheckedValue& twist);

    double at(double fraction) const;
    // The angle farthest from 0.
    double find_largest() const;
    double between(double first, double last) const { return at(last) - at(first); }

  private:
    std::vector<std::pair<double, double>> rows_;
};

// That of a rod or of the file of its sections; a fault if both have one.
SectionTwist find_twist(const CheckedTable& rod, const SectionFile* file, const BuildContext& context);

}  // namespace gxrod
