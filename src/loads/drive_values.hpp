#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/model.hpp"
#include "state/motion.hpp"
#include "state/point_drive.hpp"

namespace gxrod {

// Which tendons are among what acts: those whose tension is prescribed, which is all that elements need to
// know of, or those that winches pull too; or nothing at all.
enum class TendonsIn { prescribed, all, none };

// What a model's actuations, tendons and pressures are at one time, at the force points of rods: found again
// only where the time has changed, so that the iterations of a step share it. What has been asked for before
// changes no value. Threads can read it at once while nobody moves it.
class DriveValues {
  public:
    // The model must outlive this.
    explicit DriveValues(const Model& model, TendonsIn tendons = TendonsIn::prescribed);

    // Throws EvaluationError, of a function without a finite value.
    void move_to(double time);
    // Of all tendons of the model, whatever their functions say, until the time changes.
    void set_tensions(std::span<const double> tensions);
    // Of one tendon at each of its force points, from the rod's start to its end.
    void set_tensions(std::size_t tendon, std::span<const double> at_points);
    // Where the rods are: of strains by the pressure of water and of contents, which depend on the depth. Of
    // gravity the size. Before what acts is asked for, and after move_to.
    void press(const std::vector<NodeMotion>& motions, double gravity);
    bool have_pressures() const { return !pressed_.empty(); }
    // Of functions that rest on more than the time: they are evaluated again, whatever the time.
    void forget() { time_.reset(); }

    // Whether no rod is driven at any time.
    bool empty() const { return drives_.empty(); }
    // Whether something acts within this rod at some time.
    bool is_driven(int rod) const { return first_point_[static_cast<std::size_t>(rod)] != no_point; }
    // At the force points of an element, from its start to its end; empty if the rod is not driven.
    std::span<const PointDrive> of(int rod, int element) const;

  private:
    static constexpr std::size_t no_point = static_cast<std::size_t>(-1);

    // An actuation, or a tendon, at a force point.
    struct ActuatedPoint {
        std::size_t point;  // in drives_
        const Actuation* actuation;
        double s;
        double expansion;
    };
    struct TendonPoint {
        std::size_t point;
        std::size_t pull;  // of that point
    };
    using Strand = std::vector<TendonPoint>;
    // A force point whose wall the pressures stretch.
    struct PressedPoint {
        std::size_t point;
        const Section* section;
        std::vector<std::pair<int, double>> heights;  // nodes of the element and their shape functions there
        double given = 0.0;                           // the strain by actuations
    };

    void lay_out(int rod);
    void place(const Actuation& actuation);
    void place(const Tendon& tendon);
    void place_pressures(int rod);
    void move_strains(double time);

    const Model* model_;
    std::vector<std::size_t> first_point_;  // of each rod, in drives_; no_point if it is not driven
    std::vector<PointDrive> drives_;
    std::vector<ActuatedPoint> actuated_;
    std::vector<Strand> strands_;  // of each tendon
    std::vector<PressedPoint> pressed_;
    std::optional<double> time_;
};

}  // namespace gxrod
