#include <algorithm>
#include <cstdint>

#include "deck/problem.hpp"
#include "fuzz/inputs.hpp"
#include "fuzz/results_sample.hpp"
#include "fuzz/scratch_folder.hpp"
#include "machine/file_error.hpp"
#include "report/report.hpp"
#include "results/csv_export.hpp"
#include "results/results_file.hpp"
#include "results/series_export.hpp"

namespace gxrod::fuzz {
namespace {

// A change of five bytes: what it does, where (three bytes, the lowest first), and a value.
constexpr std::size_t edit_size = 5;

void apply_edit(std::string_view edit, std::string& bytes) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(edit[i]); };
    if (bytes.empty()) return;
    const std::size_t at = (byte(1) + 256U * byte(2) + 65536U * byte(3)) % bytes.size();
    const std::uint8_t value = byte(4);
    switch (byte(0) % 8) {
        case 0:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << (value % 8)));
            break;
        case 1:
            bytes[at] = static_cast<char>(bytes[at] + 1);
            break;
        case 2:  // a number of eight bytes
            std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                        std::min<std::size_t>(8, bytes.size() - at),
                        static_cast<char>(value));
            break;
        case 3:  // what a disk lost
            std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                        std::min<std::size_t>(16U * value, bytes.size() - at),
                        '\0');
            break;
        case 4:  // one part in place of another
            bytes.replace(at,
                          std::min<std::size_t>(value, bytes.size() - at),
                          bytes,
                          value * 64U % bytes.size(),
                          value);
            break;
        case 5:
            if (value % 16 == 0) bytes.resize(at);
            break;
        default:
            bytes[at] = static_cast<char>(value);
    }
}

std::string apply_edits(std::string_view edits) {
    std::string bytes = results_sample();
    for (; edits.size() >= edit_size; edits.remove_prefix(edit_size))
        apply_edit(edits.substr(0, edit_size), bytes);
    return bytes;
}

const ScratchFolder& folder() {
    static const ScratchFolder all;
    return all;
}

void resume(const std::filesystem::path& path) {
    ResumableFile file(path);
    const Problem problem = read_resumption(file.deck(), "", {});
    ResultsFile results(problem.record, problem.model, problem.output, std::move(file));
    results.close(RunStatus::complete, "");
}

// As documented, or nothing.
template <class Action>
void try_to(Action&& action) {
    try {
        action();
    } catch (const FileError&) {
        return;
    } catch (const DeckError&) {
        return;
    }
}

}  // namespace

void try_results(std::string_view input) {
    constexpr std::size_t most_edits = 20;
    if (input.empty() || input.size() > 1 + most_edits * edit_size) return;
    const std::filesystem::path path = folder().write("edited.vtkhdf", apply_edits(input.substr(1)));
    switch (static_cast<std::uint8_t>(input[0]) % 4) {
        case 0:
            return try_to([&] { resume(path); });
        case 1:
            return try_to([&] {
                write_report(
                    {.results = path, .page = folder().path() / "page.html", .existing = Existing::replace});
            });
        case 2:
            return try_to([&] { export_csv(path, folder().path() / "csv", Existing::replace); });
        default:
            return try_to([&] { export_series(path, folder().path() / "series", Existing::replace); });
    }
}

}  // namespace gxrod::fuzz
