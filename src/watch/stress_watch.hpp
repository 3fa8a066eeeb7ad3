#pragma once

#include <string>
#include <vector>

#include "cross_section/section_stress.hpp"
#include "model/sections/section_at.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// Lists the stress places of all elements whose sections have shapes on cells there and no law.
std::vector<RodPlace> list_stress_places(const Model& model);

// A shape at a place, by its number in StressWatch::shapes, with its part of all values.
struct ShapeShare {
    int shape = 0;
    double part = 1.0;
    // Between two stations: takes the resultants at the place to those of the shape under the same strains.
    std::optional<Mat6> transfer = {};

    Vec6 resultants(const Vec6& at_place) const { return transfer ? Vec6(*transfer * at_place) : at_place; }
};
using ShapeShares = std::vector<ShapeShare>;  // that with the largest part first

// Computes stresses of all rods.
class StressWatch {
  public:
    // The largest values over a section.
    struct Largest {
        double von_mises = 0.0, exposure = 0.0;
    };

    // Exposure is by the criterion of this word (SectionStresses).
    StressWatch(const Model& model, const std::string& criterion);

    const std::vector<ListedShape>& shapes() const { return listed_; }
    // Finds the shapes at a place; empty without one, and where a law acts.
    ShapeShares shapes_at(const RodPlace& place) const;
    const SectionStresses& stresses_of(int shape) const { return stresses_[static_cast<std::size_t>(shape)]; }
    // Computes the largest values at the middle of an element; NaN without a shape, or a strength.
    Largest find_largest(const ShapeShares& shapes, const SectionValues& middle) const;

  private:
    const Model* model_;
    std::vector<ListedShape> listed_;
    std::vector<SectionStresses> stresses_;  // of each shape
};

// A place of a rod at which a stress was the largest one of all steps so far.
struct WorstStress {
    double value = 0.0;
    double time = 0.0;
    PlanePoint at = PlanePoint::Zero();  // in the section
    int layer = 0;
    Vec6 resultants = Vec6::Zero();
};

// The largest stresses of all steps, place by place.
class StressEnvelope {
  public:
    struct Place {
        RodPlace at;
        ShapeShares shapes;
    };

    // Takes the snapshots' points from this one on. `watch` must outlive the envelope.
    StressEnvelope(const Model& model, const StressWatch& watch, std::size_t first_point);

    const std::vector<Place>& places() const { return places_; }
    // Return the worst of each place, in their order.
    std::vector<WorstStress>& von_mises() { return von_mises_; }
    std::vector<WorstStress>& exposure() { return exposure_; }
    const std::vector<WorstStress>& von_mises() const { return von_mises_; }
    const std::vector<WorstStress>& exposure() const { return exposure_; }

    void add(const Snapshot& snapshot);

  private:
    const StressWatch* watch_;
    std::size_t first_point_;
    std::vector<Place> places_;
    std::vector<WorstStress> von_mises_, exposure_;
};

}  // namespace gxrod
