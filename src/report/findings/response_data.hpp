#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/findings/stage_list.hpp"
#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// The responses of a stage of kind "response" to harmonic forces, at the points of the deck's histories.
class ResponseData {
  public:
    // Reads the components that move, of the quantities that the histories name. If they take more than
    // `bytes`, leaves out frequencies, but not the peaks. Throws Hdf5Error.
    ResponseData(const Hdf5Reader& file, const FoundStage& stage, std::size_t bytes);

    static bool has_any(const Hdf5Reader& file, const FoundStage& stage);
    // Returns the bytes in the page, as base64.
    std::size_t count_bytes() const;
    // Returns a sentence on what was left out, or "".
    std::string left_out() const;
    // Returns {stage, block, curves: [{history, quantity, component, dimension}]}.
    nlohmann::ordered_json describe(std::size_t block) const;
    // Writes the blocks "response-omegas-BLOCK" and "response-values-BLOCK": for each curve real parts, then
    // imaginary parts. NaN where there is no response.
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
    std::vector<std::size_t> rows_;  // rows that are kept
};

}  // namespace gxrod
