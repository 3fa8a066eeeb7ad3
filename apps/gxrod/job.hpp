#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "deck/problem.hpp"
#include "run/run.hpp"

namespace gxrod {

// What a user asks of a run in addition to the deck.
struct JobOptions {
    std::string deck;     // as the user named it
    std::string results;  // file
    std::string summary;  // file for JSON, "-", or "" for none
    bool quiet = false;
    Existing existing = Existing::refuse;
    std::string until;  // the stage after which the run stops
    int threads = 1;

    // Whether to print on stdout.
    bool prints() const { return !quiet && summary != "-"; }
};

// Declares --threads, --summary and --quiet.
void add_job_options(CLI::App& verb, JobOptions& options);

// Reads a deck, as read_problem does; given a plan, the error says how to run it.
Problem read_job_problem(const std::string& deck, const std::vector<std::string>& overrides);

// Runs a problem with a progress line, ends it tidily on Ctrl-C and reports the outcome; or resumes the file
// `resumed`. Returns the exit code. Throws FileError.
int run_job(const Problem& problem, const JobOptions& options, ResumableFile* resumed = nullptr);

}  // namespace gxrod
