#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/base64.hpp"
#include "report/blocks/step_thinning.hpp"
#include "results/energy_warning.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// A chart of one dataset or more with a row for each step.
struct StepChart {
    std::string title;     // for a history its name in the deck
    std::string group;     // "energy", "momentum", "history" or "solver"
    std::string quantity;  // quantity of a history
    std::string description;
    std::string dimension;
    std::string frame;
    struct Source {
        std::string dataset;
        std::vector<std::string> labels;  // labels of its columns, and of a vector's magnitude
        std::size_t width = 1;            // columns in the file
    };
    std::vector<Source> sources;

    std::size_t columns() const;
};

// Lists the charts: energies, momenta (of dynamic runs), each history, and the solver's record. Throws
// Hdf5Error.
std::vector<StepChart> list_charts(const Hdf5Reader& file, bool is_static);

nlohmann::ordered_json describe_charts(const std::vector<StepChart>& charts);

// Writes the block "step-times" and, column after column of all charts, "steps". Throws Hdf5Error.
void write_step_blocks(const Hdf5Reader& file,
                       const std::vector<StepChart>& charts,
                       const StepThinning& thinning,
                       std::size_t steps,
                       std::ostream& out);

// Writes column after column of a chart, as float, at ascending rows of the first `steps`. Throws Hdf5Error.
void write_chart_rows(const Hdf5Reader& file,
                      const StepChart& chart,
                      const std::vector<std::size_t>& rows,
                      std::size_t steps,
                      Base64Writer& base64);

// Surveys the energies of the first `steps` steps. Throws Hdf5Error.
EnergySurvey survey_energy(const Hdf5Reader& file, bool is_static, std::size_t steps);

}  // namespace gxrod
