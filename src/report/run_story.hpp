#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "deck/problem.hpp"
#include "report/model/drawn_cells.hpp"
#include "report/model/load_arrows.hpp"
#include "report/model/model_json.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

inline constexpr std::size_t most_bodies = 300;  // that are drawn

// The data of a results file about a run, in addition to its numbers.
struct RunStory {
    bool is_static = false;
    std::string deck;  // its text, as last run
    FrameTopology topology;
    std::unique_ptr<Problem> problem;  // null if the deck cannot be rebuilt or does not fit the frames
    std::string why_no_problem;
    std::vector<LoadArrow> arrows;         // loads of the problem's model
    std::vector<std::int64_t> fail_nodes;  // nodes that the reason of a failure names
    std::vector<int> marked_nodes;         // nodes at which something is drawn
    std::vector<std::string> left_out;     // parts missing in the drawing, a sentence each
};

// Reads the story of a run. Throws Hdf5Error.
RunStory read_run_story(const Hdf5Reader& file);

// Lists warnings to read before trusting the results: that the run is not complete, that the energy does not
// balance over the first `steps` steps, that many of them were cut. Throws Hdf5Error.
std::vector<std::string> list_warnings(const Hdf5Reader& file, const RunStory& story, std::size_t steps);

// Describes the run for the page. Throws Hdf5Error.
nlohmann::ordered_json describe_run(const Hdf5Reader& file, const RunStory& story, const NodeNumbers& number);

}  // namespace gxrod
