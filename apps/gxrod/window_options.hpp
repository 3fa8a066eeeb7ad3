#pragma once

#include <CLI/CLI.hpp>

#include "results/export/time_window.hpp"

namespace gxrod {

// Adds --from, --to and --stage, which choose a part of a run.
inline void add_window_options(CLI::App& verb, WindowRequest& window) {
    CLI::Option* from = verb.add_option(
        "--from", window.from, "First time, or load factor, of ranges [default: when time begins]");
    CLI::Option* to = verb.add_option("--to", window.to, "Last time of ranges [default: the end]");
    verb.add_option("--stage", window.stage, "Stage of ranges, instead of times")
        ->excludes(from)
        ->excludes(to);
}

}  // namespace gxrod
