#include "batch/slurm/slurm_jobs.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <sstream>

#include "batch/batch_folder.hpp"
#include "deck/text/text_file.hpp"
#include "machine/file_error.hpp"

namespace gxrod {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path jobs_path(const fs::path& folder) { return slurm_folder(folder) / "jobs.json"; }

Json write_ranges(const std::vector<CaseRange>& ranges) {
    Json json = Json::array();
    for (const CaseRange& range : ranges) json.push_back({range.first, range.last});
    return json;
}

std::vector<CaseRange> read_ranges(const Json& json) {
    std::vector<CaseRange> ranges;
    for (const Json& range : json) ranges.push_back({range.at(0), range.at(1)});
    return ranges;
}

Json write_job(const SlurmJob& job) {
    return {{"id", job.id},
            {"cluster", job.cluster},
            {"script", job.script},
            {"submitted", job.submitted},
            {"options", job.options},
            {"slices", write_ranges(job.slices)},
            {"retried", write_ranges(job.retried)}};
}

SlurmJob read_job(const Json& json) {
    return {json.at("id"),
            json.at("cluster"),
            json.at("script"),
            json.at("submitted"),
            json.at("options").get<std::vector<std::string>>(),
            read_ranges(json.at("slices")),
            read_ranges(json.at("retried"))};
}

bool is_number(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

fs::path slurm_folder(const fs::path& folder) { return folder / "slurm"; }

std::vector<SlurmJob> read_slurm_jobs(const fs::path& folder) {
    const fs::path path = jobs_path(folder);
    std::error_code ignored;
    if (!fs::exists(path, ignored)) return {};
    const std::string text = read_text_file(path);
    try {
        const Json json = Json::parse(text);
        std::vector<SlurmJob> jobs;
        for (const Json& job : json.at("jobs")) jobs.push_back(read_job(job));
        return jobs;
    } catch (const Json::exception& error) {
        throw FileError(path, std::string("is not a list of Slurm jobs: ") + error.what());
    }
}

void write_slurm_jobs(const std::vector<SlurmJob>& jobs, const fs::path& folder) {
    std::string text = "{\"jobs\": [";
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        text += i == 0 ? "\n" : ",\n";
        text += write_job(jobs[i]).dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    replace_file(jobs_path(folder), text + "\n]}\n");
}

SlurmJob read_submission(std::string_view text) {
    // A site can have it print more; the last line counts.
    while (text.ends_with('\n')) text.remove_suffix(1);
    const std::string_view line = text.substr(text.rfind('\n') + 1);
    const std::size_t end = line.find(';');
    SlurmJob job;
    if (!is_number(line.substr(0, end))) return job;
    job.id = line.substr(0, end);
    if (end != std::string_view::npos) job.cluster = line.substr(end + 1);
    return job;
}

std::vector<SlurmTask> read_squeue(std::string_view text, const std::vector<SlurmJob>& jobs) {
    std::vector<SlurmTask> tasks;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        std::array<std::string, 4> words;
        for (std::string& word : words) std::getline(fields, word, '|');
        const auto& [id, index_text, state, reason] = words;
        const auto job =
            std::find_if(jobs.begin(), jobs.end(), [&](const SlurmJob& one) { return one.id == id; });
        std::size_t index = 0;
        std::from_chars(index_text.data(), index_text.data() + index_text.size(), index);
        if (job == jobs.end() || index < 1 || index > job->slices.size()) continue;
        tasks.push_back({id, state, reason, job->slices[index - 1]});
    }
    return tasks;
}

}  // namespace gxrod
