#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/model.hpp"
#include "state/motion.hpp"
#include "state/point_drive.hpp"

namespace gxrod {

// The tendons to include: those with prescribed tension, which suffice for elements; those that winches pull
// too; or no action at all.
enum class TendonsIn { prescribed, all, none };

// The values of a model's actuations, tendons and pressures at one time, at the force points of rods. They
// are computed again only when the time has changed, so that the iterations of a step share them; earlier
// requests change no value. Threads can read it at once while nobody moves it.
class DriveValues {
  public:
    // The model must outlive this.
    explicit DriveValues(const Model& model, TendonsIn tendons = TendonsIn::prescribed);

    // Throws EvaluationError if a function has no finite value.
    void move_to(double time);
    // Sets the tensions of all tendons of the model, in place of their functions, until the time changes.
    void set_tensions(std::span<const double> tensions);
    // Sets the tension of one tendon at each of its force points, from the rod's start to its end.
    void set_tensions(std::size_t tendon, std::span<const double> at_points);
    // Sets strains by the pressure of water and contents, which depend on the depth, from the positions of
    // the rods, gravity and water. Call it after move_to, before the drives are asked for.
    void press(const std::vector<NodeMotion>& motions, double time);
    bool have_pressures() const { return !pressed_.empty(); }
    // Forgets functions that depend on more than the time: they are evaluated again, whatever the time.
    void forget() { time_.reset(); }

    // Whether no rod is driven at any time.
    bool empty() const { return drives_.empty(); }
    // Whether a drive acts within this rod at some time.
    bool is_driven(int rod) const { return first_point_[static_cast<std::size_t>(rod)] != no_point; }
    // Returns the drives at the force points of an element, from its start to its end; empty if the rod is
    // not driven.
    std::span<const PointDrive> of(int rod, int element) const;

  private:
    static constexpr std::size_t no_point = static_cast<std::size_t>(-1);

    // An actuation, or a tendon, at a force point.
    struct ActuatedPoint {
        std::size_t point;  // index in drives_
        const Actuation* actuation;
        double s;
        double expansion;
    };
    struct TendonPoint {
        std::size_t point;
        std::size_t pull;  // index among the pulls of that point
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
    std::vector<std::size_t> first_point_;  // for each rod, index in drives_; no_point if it is not driven
    std::vector<PointDrive> drives_;
    std::vector<ActuatedPoint> actuated_;
    std::vector<Strand> strands_;  // for each tendon
    std::vector<PressedPoint> pressed_;
    std::optional<double> time_;
};

}  // namespace gxrod
