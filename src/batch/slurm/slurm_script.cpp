#include "batch/slurm/slurm_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "batch/cases/case_slices.hpp"
#include "machine/file_error.hpp"

namespace gxrod {
namespace {

bool is_plain(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '0' && letter <= '9') || letter == '.' || letter == '-' || letter == '_';
}

// A folder in a line of options: sbatch expands %, a \ would keep it from that.
std::string escape_for_sbatch(const std::filesystem::path& folder) {
    std::string escaped;
    for (const char letter : folder.string()) {
        if (letter == '\n' || letter == '\\' || letter == '"') {
            throw FileError(folder,
                            "sbatch cannot write into a folder whose name has a line end, a \" or a \\",
                            "-o takes another folder");
        }
        escaped += letter == '%' ? "%%" : std::string(1, letter);
    }
    return escaped;
}

// The number in "-c4", "-c 4", "--cpus-per-task=4" or "--cpus-per-task 4"; 1 if there is none.
long find_cores(const std::vector<std::string>& options) {
    long cores = 1;
    for (std::size_t i = 0; i < options.size(); ++i) {
        for (const std::string_view key : {"--cpus-per-task", "-c"}) {
            if (!options[i].starts_with(key)) continue;
            std::string_view number = std::string_view(options[i]).substr(key.size());
            if (number.empty() && i + 1 < options.size()) number = options[i + 1];
            if (number.starts_with("=")) number.remove_prefix(1);
            std::from_chars(number.data(), number.data() + number.size(), cores);
        }
    }
    return std::max(cores, 1L);
}

}  // namespace

std::string make_job_name(const std::string& text) {
    std::string name = text;
    std::replace_if(
        name.begin(), name.end(), [](char letter) { return !is_plain(letter); }, '_');
    return name;
}

std::string quote_for_shell(std::string_view word) {
    const auto needs_none = [](char letter) {
        return is_plain(letter) || letter == '/' || letter == ',' || letter == ':' || letter == '=';
    };
    if (!word.empty() && std::all_of(word.begin(), word.end(), needs_none)) return std::string(word);
    std::string quoted = "'";
    for (const char letter : word) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
    return quoted + "'";
}

long choose_task_count(long cases, const std::vector<std::string>& sbatch_options) {
    constexpr long least_cases_per_core = 4;
    constexpr long most_tasks = 100;
    return std::clamp(cases / (least_cases_per_core * find_cores(sbatch_options)), 1L, most_tasks);
}

std::string write_slurm_script(const SlurmScript& script) {
    std::string text = "#!/bin/bash\n# Each task runs a slice of a batch; gxrod batch --slurm wrote this.\n";
    text += fmt::format("#SBATCH --job-name={}\n", script.name);
    text += fmt::format("#SBATCH --array=1-{}\n", script.slices.size());
    text += fmt::format("#SBATCH --output=\"{}/slurm/%A_%a.out\"\n", escape_for_sbatch(script.folder));
    text += "#SBATCH --open-mode=append\n\nslices=(\n";
    for (std::size_t i = 0; i < script.slices.size(); ++i)
        text += fmt::format("  [{}]={}\n", i + 1, write_range(script.slices[i]));
    text += ")\nslice=${slices[SLURM_ARRAY_TASK_ID]:?there is no such task}\n";
    text += "echo \"cases $slice on ${SLURMD_NODENAME:-$(hostname)}, $(date '+%F %T')\"\n";
    text += fmt::format("cd {} || exit\n", quote_for_shell(script.directory.string()));
    text += fmt::format("exec {} batch", quote_for_shell(script.program.string()));
    for (const std::string& file : script.files) text += " " + quote_for_shell(file);
    text +=
        fmt::format(" \\\n  --output {} \\\n  --only \"$slice\"{} --jobs \"${{SLURM_CPUS_PER_TASK:-1}}\"\n",
                    quote_for_shell(script.folder.string()),
                    script.retry_failed ? " --retry-failed" : "");
    return text;
}

}  // namespace gxrod
