#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

// One function a verb: declares its options on the program and, when it was asked for, stores its exit code.
namespace gxrod {

void add_init_verb(CLI::App& program, int& exit_code);
void add_run_verb(CLI::App& program, int& exit_code);
void add_resume_verb(CLI::App& program, int& exit_code);
// `sbatch_options` come after "--", if there is one.
void add_batch_verb(CLI::App& program,
                    int& exit_code,
                    std::optional<std::vector<std::string>> sbatch_options);
void add_check_verb(CLI::App& program, int& exit_code);
void add_section_verb(CLI::App& program, int& exit_code);
void add_obstacle_verb(CLI::App& program, int& exit_code);
void add_verify_verb(CLI::App& program, int& exit_code);
void add_schema_verb(CLI::App& program, int& exit_code);
void add_export_verb(CLI::App& program, int& exit_code);
void add_line_ends_verb(CLI::App& program, int& exit_code);
void add_fmu_verb(CLI::App& program, int& exit_code);
void add_report_verb(CLI::App& program, int& exit_code);

}  // namespace gxrod
