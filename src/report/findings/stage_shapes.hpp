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

// The shapes of one stage, which are in a file beside the results, for the picture to swing in them about the
// states in which they were found.
class StageShapes {
  public:
    // `times`: where the state of each shape is on the axis of the results.
    StageShapes(const Hdf5Reader& results,
                const std::filesystem::path& path,
                std::vector<double> times,
                const ReportContent& content);

    // Why there is nothing to draw, a sentence for the reader; "" if there is.
    const std::string& why_none() const { return why_none_; }
    std::size_t count() const { return times_.size(); }
    std::size_t kept() const { return kept_; }
    // Draws no more than the first `most` of them.
    void keep(std::size_t most);
    // Vectors of each node that are kept: of the states their positions and rotations, of each shape
    // displacements and rotations, both twice if it is complex.
    std::size_t count_vectors() const;
    // {block, kept, is_complex, times}; of a shape at once, times has one for each state.
    nlohmann::ordered_json describe(std::size_t block) const;
    // Blocks "shape-PART-BLOCK": "places" and "attitudes" (rotation vectors) of the states, "moves" and
    // "turns" of the shapes and, of complex ones, "moves-imaginary" and "turns-imaginary". Throws Hdf5Error.
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
