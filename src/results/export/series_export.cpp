#include "results/export/series_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "machine/file_error.hpp"
#include "results/export/frame_copy.hpp"
#include "results/file/results_access.hpp"

namespace gxrod {

namespace {

std::vector<double> read_times(const std::filesystem::path& results) {
    std::vector<double> times;
    read_results(results, [&](const Hdf5Reader& file) { times = file.numbers("/VTKHDF/Steps/Values"); });
    if (times.empty()) throw FileError(results, "has no frame yet");
    return times;
}

void write_series(const std::filesystem::path& path,
                  const std::vector<std::filesystem::path>& files,
                  const std::vector<double>& times) {
    nlohmann::ordered_json series{{"file-series-version", "1.0"}, {"files", nlohmann::json::array()}};
    for (std::size_t i = 0; i < files.size(); ++i) {
        series["files"].push_back({{"name", files[i].filename().string()}, {"time", times[i]}});
    }
    std::ofstream out(path, std::ios::binary);
    out << series.dump(1) << '\n';
    out.close();
    if (!out) throw FileError(path, "cannot be written", std::generic_category().message(errno));
}

// The name of a file of the series NAME: "NAME_0012.hdf".
std::string frame_name(const std::string& name, std::size_t frame) {
    return fmt::format("{}_{:04}.hdf", name, frame);
}

// Names of frames that a series lists, if it can be read; gxrod did not write anything else that it lists.
std::vector<std::string> read_frame_names(const std::filesystem::path& path, const std::string& name) {
    std::ifstream in(path, std::ios::binary);
    const auto series = nlohmann::json::parse(in, nullptr, false);
    if (!series.is_object() || !series.value("files", nlohmann::json()).is_array()) return {};
    std::vector<std::string> names;
    for (const nlohmann::json& file : series["files"]) {
        if (!file.is_object() || !file.contains("name") || !file["name"].is_string()) continue;
        const std::string listed = file["name"];
        const std::size_t digits = std::min(listed.size(), name.size() + 1);
        const std::size_t frame = std::strtoull(listed.c_str() + digits, nullptr, 10);
        if (listed == frame_name(name, frame)) names.push_back(listed);
    }
    return names;
}

// Removes files of an earlier series that the new one does not list.
void remove_stale(const std::filesystem::path& folder,
                  const std::vector<std::string>& earlier,
                  const std::vector<std::filesystem::path>& files) {
    for (const std::string& name : earlier) {
        const std::filesystem::path path = folder / name;
        std::error_code error;
        if (std::find(files.begin(), files.end(), path) == files.end()) std::filesystem::remove(path, error);
        if (error) throw FileError(path, "cannot be removed", error.message());
    }
}

}  // namespace

std::filesystem::path export_series(const std::filesystem::path& results,
                                    const std::filesystem::path& folder,
                                    Existing existing) {
    const std::vector<double> times = read_times(results);
    const std::string name = results.stem().string();
    std::vector<std::filesystem::path> files;
    for (std::size_t i = 0; i < times.size(); ++i) {
        files.push_back(folder / frame_name(name, i));
    }
    std::filesystem::path series = folder / (name + ".hdf.series");
    files.push_back(series);
    prepare_export(folder, files, existing);
    files.pop_back();
    const std::vector<std::string> earlier = read_frame_names(series, name);

    for (std::size_t i = 0; i < files.size(); ++i) {
        FrameCopy frame;
        read_results(results, [&](const Hdf5Reader& file) { frame = read_frame(file, i); });
        write_copies(frame, {"UnstructuredGrid"}, files[i]);
    }
    write_series(series, files, times);
    remove_stale(folder, earlier, files);
    return series;
}

}  // namespace gxrod
