#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "results/file/hdf5_reader.hpp"

namespace gxrod {

// The largest stresses of all steps along rods, as /envelopes of a results file has them, as far as they fit
// into a page. A file without envelopes adds nothing to its page.
class EnvelopeBlocks {
  public:
    // Reads what fits into `bytes`; of very many places, of each few that follow each other on a rod those
    // with the largest values. Throws Hdf5Error.
    EnvelopeBlocks(const Hdf5Reader& file, std::size_t bytes);

    // Counts the blocks, with the text around them.
    std::size_t count_bytes() const;
    std::vector<std::string> left_out() const;
    // Adds "envelopes": the criterion of exposure and the names of the quantities.
    void describe(nlohmann::ordered_json& json) const;
    // Writes "envelope-rods" (number of the rod in the order of the deck), "envelope-places" (arc length),
    // "envelope-sections" (number, −1 without stresses) and, of each quantity, "envelope-QUANTITY": value,
    // time, y, z, layer and the six resultants of each place.
    void write(std::ostream& out) const;

  private:
    struct Quantity {
        std::string name;
        std::vector<float> rows;  // eleven numbers for each place
    };

    Quantity read_quantity(const std::string& name) const;
    std::vector<std::size_t> list_largest(std::size_t group) const;
    std::size_t count_bytes_of(std::size_t places) const;

    const Hdf5Reader& file_;
    std::vector<double> rods_, places_, sections_;
    std::vector<Quantity> quantities_;
    std::vector<std::size_t> kept_;  // rows
};

}  // namespace gxrod
