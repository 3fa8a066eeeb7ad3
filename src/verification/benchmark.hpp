#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/settings/settings.hpp"
#include "verification/study.hpp"

// Example decks against reference values: the folder of an example holds its deck and a reference.toml, which
// says what the deck must give and how the error falls when mesh and steps are refined.
namespace gxrod {

// Equilibria of a path: those at which a component of a history's displacement has this value, or t of a
// stage.
struct PlaceOnPath {
    std::string history;  // "": t
    int component = 0;
    double is = 0.0;
    std::string stage = {};  // "": any
};

// What is compared, and with what.
struct BenchmarkValue {
    std::string
        source;  // a [[history]] of the deck, "ledger", or a stage that finds shapes or critical points
    std::string quantity;
    double time = 0.0;
    bool is_constant = false;       // the reference is for every step, and the worst of them counts
    std::vector<double> reference;  // a NaN component is not compared
    double scale = 1.0;             // errors are divided by it
    double uncertainty = 0.0;       // of the reference; 0: exact
    bool is_of_shapes = false;      // then the reference has a number for each of them; errors are relative
    std::optional<double> at = {};  // the value of a sweep
    std::optional<PlaceOnPath> where = {};  // instead of the time; of several equilibria the nearest counts
};

// Runs of one deck with more and more elements or steps.
struct Refinement {
    std::string name;
    std::vector<std::vector<std::string>> rows;  // "KEY=VALUE" of each run
    double order = 0.0;                          // of the error, from row to row, if asked for
    double tolerance = 0.0;                      // of the last row's error, if asked for
    double floor = 0.0;  // errors below it are the reference's own or round-off: no order is asked
};

struct Benchmark {
    std::string name;
    std::string sentence;
    std::string kind;    // "statics", "vibrations", "stability", "dynamics", "rigid body", …
    std::string source;  // of the problem, and how the reference was found
    std::string deck;    // its text
    std::vector<BenchmarkValue> values;
    std::vector<Refinement> refinements;
};

// Throws DeckError where `reference` does not say what it must.
Benchmark read_benchmark(const std::string& name, const std::string& deck, const std::string& reference);

// A value of a run and its distance from the reference, Euclidean, divided by the scale.
struct FoundValue {
    std::vector<double> value;
    double error = 0.0;
};

struct BenchmarkRun {
    std::vector<FoundValue> values;  // those of the benchmark
    double error = 0.0;              // the largest of them
    long unknowns = 0;
    long steps = 0;
    long newton_iterations = 0;
    double seconds = 0.0;
    double energy_error = 0.0;  // of the ledger, the largest of the run
};

// Runs the deck with these overrides. Throws DeckError, or std::runtime_error if the run fails or a value is
// not among its results.
BenchmarkRun run_benchmark(const Benchmark& benchmark, const std::vector<std::string>& overrides);

// Runs all refinements.
StudyResult report_benchmark(const Benchmark& benchmark);

// Those built in: every example with a reference, by name.
const std::vector<Benchmark>& benchmarks();

}  // namespace gxrod
