#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/settings/settings.hpp"
#include "verification/study.hpp"

// Example decks and their reference values: the folder of an example holds its deck and a reference.toml with
// the expected results and the order with which the error falls when mesh and steps are refined.
namespace gxrod {

// The equilibria of a path at which a component of a history's displacement, or t of a stage, has this value.
struct PlaceOnPath {
    std::string history;  // "": t
    int component = 0;
    double is = 0.0;
    std::string stage = {};  // "": any
};

// A result that is compared, and its reference.
struct BenchmarkValue {
    std::string
        source;  // a [[history]] of the deck, "ledger", or a stage that finds shapes or critical points
    std::string quantity;
    double time = 0.0;
    bool is_constant = false;       // the reference is for every step, and the largest error counts
    std::vector<double> reference;  // a NaN component is not compared
    double scale = 1.0;             // errors are divided by it
    double uncertainty = 0.0;       // uncertainty of the reference; 0: exact
    bool is_of_shapes = false;      // shapes: the reference has a number for each; errors are relative
    std::optional<double> at = {};  // value of the parameter of a sweep
    std::optional<PlaceOnPath> where = {};  // in place of the time; the nearest equilibrium counts
};

// Runs of one deck with increasing numbers of elements or steps.
struct Refinement {
    std::string name;
    std::vector<std::vector<std::string>> rows;  // "KEY=VALUE" of each run
    double order = 0.0;                          // order of the error, from row to row; 0: not checked
    double tolerance = 0.0;                      // for the last row's error; 0: not checked
    double floor = 0.0;  // smaller errors come from the reference or round-off: no order is checked
};

struct Benchmark {
    std::string name;
    std::string sentence;
    std::string kind;    // "statics", "vibrations", "stability", "dynamics", "rigid body", …
    std::string source;  // source of the problem, and of the reference
    std::string deck;    // its text
    std::vector<BenchmarkValue> values;
    std::vector<Refinement> refinements;
};

// Reads a benchmark. Throws DeckError if `reference` is wrong or incomplete.
Benchmark read_benchmark(const std::string& name, const std::string& deck, const std::string& reference);

// A value of a run and its Euclidean distance from the reference, divided by the scale.
struct FoundValue {
    std::vector<double> value;
    double error = 0.0;
};

struct BenchmarkRun {
    std::vector<FoundValue> values;  // in the order of the benchmark
    double error = 0.0;              // the largest of them
    long unknowns = 0;
    long steps = 0;
    long newton_iterations = 0;
    double seconds = 0.0;
    double energy_error = 0.0;  // largest of the ledger in the run
};

// Runs the deck with these overrides. Throws DeckError, or std::runtime_error if the run fails or a value is
// not among its results.
BenchmarkRun run_benchmark(const Benchmark& benchmark, const std::vector<std::string>& overrides);

// Runs all refinements of a benchmark.
StudyResult report_benchmark(const Benchmark& benchmark);

// Returns the built-in benchmarks: all examples with a reference, by name.
const std::vector<Benchmark>& benchmarks();

}  // namespace gxrod
