#pragma once

#include <filesystem>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/report_plan.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// The shapes of one stage, from a file next to the results. The picture swings in them about the states in
// which they were found.
class StageShapes {
  public:
    // Reads the shapes. `times` are the places of their states on the axis of the results.
    StageShapes(const Hdf5Reader& results,
                const std::filesystem::path& path,
                std::vector<double> times,
                const ReportContent& content);

    // Returns a sentence on why there is nothing to draw; "" if there is something.
    const std::string& why_none() const { return why_none_; }
    std::size_t count() const { return times_.size(); }
    std::size_t kept() const { return kept_; }
    // Keeps only the first `most` of them.
    void keep(std::size_t most);
    // Counts the vectors per node that are kept: positions and rotations of the states, displacements and
    // rotations of each shape, both twice if it is complex.
    std::size_t count_vectors() const;
    // Returns {block, kept, is_complex, times}; times has one entry for each state.
    nlohmann::ordered_json describe(std::size_t block) const;
    // Writes the blocks "shape-PART-BLOCK": "places" and "attitudes" (rotation vectors) of the states,
    // "moves" and "turns" of the shapes and, if they are complex, "moves-imaginary" and "turns-imaginary".
    // Throws Hdf5Error.
    void write(std::size_t block, const ReportPlan& plan, std::ostream& out) const;

  private:
    void open(const std::filesystem::path& path);
    bool find_imaginary_parts() const;
    std::size_t count_states() const { return has_one_state_ ? 1 : kept_; }
    std::size_t nearest_frame(double time) const;

    const Hdf5Reader& results_;
    std::optional<Hdf5Reader> file_;
    std::vector<double> times_;
    std::size_t nodes_;
    std::vector<double> frame_times_;
    std::size_t kept_ = 0;
    bool has_one_state_ = true, is_complex_ = false;
    std::string why_none_;
};

}  // namespace gxrod
