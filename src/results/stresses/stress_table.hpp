#pragma once

#include "model/settings/settings.hpp"
#include "results/file/hdf5_objects.hpp"
#include "watch/stress_watch.hpp"

namespace gxrod {

// /sections and /envelopes, the largest stresses of all steps. Throws Hdf5Error.
class StressTable {
  public:
    // Continues the envelopes of the file. `model` must outlive the table. Throws std::runtime_error if the
    // file has steps, but no envelopes of these places.
    StressTable(const Hdf5Handle& root, const Model& model, const OutputSettings& output, bool has_steps);

    const StressWatch& watch() const { return *watch_; }
    const StressEnvelope& envelope() const { return envelope_; }
    void append(const Snapshot& snapshot) { envelope_.add(snapshot); }
    // Writes the envelopes.
    void flush();

  private:
    // The datasets of one measure.
    struct Measure {
        Hdf5Handle value, time, point, layer, resultants;
    };

    void write_places(const Model& model) const;
    Measure open(const std::string& name, const std::string& meaning, const std::string& dimension) const;
    static void read(const Measure& from, std::vector<WorstStress>& worst);
    static void write(const std::vector<WorstStress>& worst, const Measure& into);

    std::unique_ptr<StressWatch> watch_;
    StressEnvelope envelope_;
    Hdf5Handle group_;
    Measure von_mises_, exposure_;
};

}  // namespace gxrod
