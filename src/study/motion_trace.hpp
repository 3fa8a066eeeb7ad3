#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "deck/problem.hpp"
#include "watch/history_watch.hpp"

namespace gxrod {

// A quantity of a point that is followed through several runs of a model.
struct Series {
    std::string point;    // the history's name
    std::string name;     // the quantity; "rotation" for a rotation_vector, which is followed as a quaternion
    std::size_t history;  // in OutputSettings::histories
    const Quantity* quantity;
    Turning turning;

    // Rows of rotations are unit quaternions (w x y z), and their differences are angles.
    bool is_rotation() const { return quantity->is_rotation(); }
    bool is_length() const { return quantity->size == Size::place || quantity->size == Size::change; }
    std::string title() const { return point + " " + name; }
};

// Lists all quantities that the problem's histories record; only one of a rotation's two forms.
std::vector<Series> list_series(const OutputSettings& output);

// Makes histories of the ends of rods and of bodies, for a problem that has none.
std::vector<HistoryRequest> make_end_histories(const Model& model);

// Reads the series of a snapshot.
class SeriesReader {
  public:
    // Takes a problem with the histories of these series; all must outlive the reader.
    SeriesReader(const Problem& problem, const std::vector<Series>& series);

    std::vector<HistoryRow> read(const Snapshot& snapshot);

  private:
    const std::vector<Series>* series_;
    std::vector<HistoryWatch> watches_;
};

// Errors of the balances of a run over all its steps.
struct TraceBooks {
    double largest_energy = 0.0;  // kinetic + strain energy, or work
    double largest_strain_energy = 0.0;
    double largest_energy_error = 0.0;
    // Imbalances of momenta: the largest |p(t) − p(0) − ∫ F dt|, by the trapezoidal rule.
    double linear_imbalance = 0.0;
    double angular_imbalance = 0.0;
    double momentum_scale = 0.0;  // √(2 m T), the largest momentum of the mass at this kinetic energy
    double angular_scale = 0.0;   // momentum_scale times the model's length
};

// The results of one run of a model.
struct MotionTrace {
    std::vector<std::vector<HistoryRow>> rows;  // rows of each series, at the sample times
    std::size_t samples = 0;                    // samples that were reached
    TraceBooks books;
    double length = 0.0;  // length of the model, as in System
    double mass = 0.0;
    long unknowns = 0;
    long elements = 0;
    long steps = 0;                   // in all stages
    std::vector<long> steps_at;       // steps taken up to each sample
    std::vector<double> rejected_at;  // start times of the trials that were cut
    long newton_iterations = 0;
    double seconds = 0.0;
    std::string failure;                // why it stopped early, or ""
    std::vector<std::string> warnings;  // as in SteppedAnalysis
    bool is_unstable = false;           // whether unstable equilibria were accepted

    bool is_whole() const { return failure.empty(); }
};

// Thrown if the user ends a study.
struct StudyInterrupted : std::runtime_error {
    StudyInterrupted() : std::runtime_error("interrupted") {}
};

struct TraceRequest {
    const std::vector<Series>& series;
    const std::vector<double>& sample_times;  // ascending; from 0
    int threads = 1;
    std::function<bool()> is_interrupted = [] { return false; };
};

// Runs the problem in memory, and records its last stage, by that stage's own t. Values between steps lie on
// a cubic through four of them. If a step does not converge, the trace has a failure. Throws
// StudyInterrupted.
MotionTrace trace_motion(const Problem& problem, const TraceRequest& request);

}  // namespace gxrod
