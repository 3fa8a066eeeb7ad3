#include "check/summaries/memory_estimate.hpp"

#include <algorithm>

namespace gxrod {
namespace {

// As measured: the program and its libraries, with rows that wait to be written; state, matrix, elements and
// what is written of a node, of elements of order 1 and for each order more; the index of the results file,
// of which HDF5 keeps a part.
constexpr double program_bytes = 28e6;
constexpr double bytes_of_node = 4.2e3;
constexpr double bytes_of_node_and_order = 0.45e3;
constexpr double index_share = 0.08;
constexpr double most_index_bytes = 30e6;

}  // namespace

double estimate_memory(const Model& model, double results_bytes) {
    double bytes = program_bytes + std::min(index_share * results_bytes, most_index_bytes);
    bytes += bytes_of_node * static_cast<double>(model.nodes.size());
    for (const Rod& rod : model.rods)
        bytes +=
            bytes_of_node_and_order * (rod.order - 1) * static_cast<double>(rod.element_count() * rod.order);
    return bytes;
}

}  // namespace gxrod
