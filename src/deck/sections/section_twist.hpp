#pragma once

#include <utility>
#include <vector>

#include "deck/places/build_context.hpp"
#include "deck/rods/rod_table.hpp"
#include "deck/sections/section_files.hpp"

namespace gxrod {

// The turn of the section about the tangent since the start, as a function of the fraction of the length.
class SectionTwist {
  public:
    // Takes rows of fractions and angles, linear between them.
    explicit SectionTwist(std::vector<std::pair<double, double>> rows) : rows_(std::move(rows)) {}
    // Takes the key twist of a rod or of its rest shape.
    explicit SectionTwist(const NumberAlong& twist);

    double at(double fraction) const;
    // Finds the angle farthest from 0.
    double find_largest() const;
    double between(double first, double last) const { return at(last) - at(first); }

  private:
    std::vector<std::pair<double, double>> rows_;
};

// Finds the twist of a rod or of the file of its sections; adds a fault if both have one.
SectionTwist find_twist(const RodTable& rod, const SectionFile* file, const BuildContext& context);

}  // namespace gxrod
