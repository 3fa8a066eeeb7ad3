#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/findings/stage_list.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// The answers of a stage of kind "response" to forces that swing, where the deck has histories.
class ResponseData {
  public:
    // Components that move at all, of the quantities that the histories name. If they take more than `bytes`,
    // frequencies are left out, but not the peaks. Throws Hdf5Error.
    ResponseData(const Hdf5Reader& file, const FoundStage& stage, std::size_t bytes);

    static bool has_any(const Hdf5Reader& file, const FoundStage& stage);
    // In the page, as base64.
    std::size_t count_bytes() const;
    // A sentence on what was left out, or "".
    std::string left_out() const;
    // {stage, block, curves: [{history, quantity, component, dimension}]}
    nlohmann::ordered_json describe(std::size_t block) const;
    // Blocks "response-omegas-BLOCK" and "response-values-BLOCK": of each curve real parts, then imaginary
    // parts. NaN where there is no answer.
    void write(std::size_t block, std::ostream& out) const;

  private:
    struct Curve {
        std::string history, quantity, dimension;
        std::size_t component;
        std::vector<double> real, imaginary;
    };
    void add_curves(const Hdf5Reader& file, const std::string& history, const std::string& quantity);
    void choose_rows(std::size_t bytes);
    std::size_t bytes_of_row() const;

    FoundStage stage_;
    std::vector<double> omegas_;
    std::vector<Curve> curves_;
    std::vector<std::size_t> rows_;  // that are kept
};

}  // namespace gxrod
