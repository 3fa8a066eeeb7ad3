#include "results/series_export.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "model/file_error.hpp"
#include "results/frame_copy.hpp"
#include "results/results_access.hpp"

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

}  // namespace

std::filesystem::path export_series(const std::filesystem::path& results,
                                    const std::filesystem::path& folder,
                                    Existing existing) {
    const std::vector<double> times = read_times(results);
    const std::string name = results.stem().string();
    std::vector<std::filesystem::path> files;
    for (std::size_t i = 0; i < times.size(); ++i) {
        files.push_back(folder / fmt::format("{}_{:04}.hdf", name, i));
    }
    std::filesystem::path series = folder / (name + ".hdf.series");
    files.push_back(series);
    prepare_export(folder, files, existing);
    files.pop_back();

    for (std::size_t i = 0; i < files.size(); ++i) {
        FrameCopy frame;
        read_results(results, [&](const Hdf5Reader& file) { frame = read_frame(file, i); });
        write_frame(frame, files[i]);
    }
    write_series(series, files, times);
    return series;
}

}  // namespace gxrod
