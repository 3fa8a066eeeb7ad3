#include "batch/batch_index.hpp"

#include <array>
#include <charconv>
#include <optional>

#include "batch/batch_folder.hpp"
#include "machine/file_error.hpp"
#include "results/hdf5_objects.hpp"

namespace gxrod {
namespace {

std::optional<double> read_number(const std::string& text) {
    double number = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (text.empty() || error != std::errc() || stop != end) return std::nullopt;
    return number;
}

// The rows' values of one column.
template <class Value, class Take>
std::vector<Value> gather(const std::vector<CaseRow>& rows, Take&& take) {
    std::vector<Value> values;
    values.reserve(rows.size());
    for (const CaseRow& row : rows) values.push_back(take(row));
    return values;
}

class IndexWriter {
  public:
    IndexWriter(const Hdf5Handle& file, const std::vector<CaseRow>& rows) : file_(file), rows_(rows) {}

    template <class Take>
    void add_integers(const DatasetLabel& label, Take&& take) {
        write_dataset(file_, label, std::span<const std::int64_t>(gather<std::int64_t>(rows_, take)));
    }
    template <class Take>
    void add_numbers(const Hdf5Handle& group, const DatasetLabel& label, Take&& take) {
        write_dataset(group, label, std::span<const double>(gather<double>(rows_, take)));
    }
    template <class Take>
    void add_texts(const Hdf5Handle& group, const DatasetLabel& label, Take&& take) {
        write_dataset(group, label, std::span<const std::string>(gather<std::string>(rows_, take)));
    }

    void add_parameter(const Hdf5Handle& group, const std::string& name, std::size_t index) {
        const DatasetLabel label{name, "value of this key of the deck", "none", ""};
        bool has_numbers_only = true;
        for (const CaseRow& row : rows_)
            has_numbers_only = has_numbers_only && read_number(row.parameters[index]).has_value();
        if (has_numbers_only) {
            add_numbers(
                group, label, [&](const CaseRow& row) { return *read_number(row.parameters[index]); });
        } else {
            add_texts(group, label, [&](const CaseRow& row) { return row.parameters[index]; });
        }
    }

  private:
    const Hdf5Handle& file_;
    const std::vector<CaseRow>& rows_;
};

void write_attributes(const Hdf5Handle& file, const BatchRecord& record) {
    write_attribute(file.id(), "gxrod_version", record.version);
    write_attribute(file.id(), "title", record.title);
    write_attribute(file.id(), "plan", record.plan);
    write_attribute(file.id(), "plan_text", record.plan_text);
    write_attribute(file.id(), "combine", record.combine);
    const std::array<std::int64_t, 1> seed{static_cast<std::int64_t>(record.seed)};
    const std::array<std::int64_t, 1> cases{record.cases};
    write_attribute(file.id(), "seed", seed);
    write_attribute(file.id(), "cases", cases);
}

// A name of a dataset: '/' would make a group.
std::string dataset_name(std::string key) {
    for (char& letter : key) {
        if (letter == '/') letter = '_';
    }
    return key;
}

void write_rows(const Hdf5Handle& file, const BatchRecord& record, const std::vector<CaseRow>& rows) {
    IndexWriter writer(file, rows);
    writer.add_integers({"case", "number of the case, from 1", "none", "1"},
                        [](const CaseRow& row) { return row.number; });
    writer.add_texts(file,
                     {"status", "done, failed, time limit, out of memory, crashed or deck fault", "none", ""},
                     [](const CaseRow& row) { return name_of(row.status); });
    writer.add_texts(
        file, {"reason", "why it is not done", "none", ""}, [](const CaseRow& row) { return row.reason; });
    const Hdf5Handle parameters = require_group(file, "parameters");
    for (std::size_t i = 0; i < record.parameters.size(); ++i)
        writer.add_parameter(parameters, dataset_name(record.parameters[i]), i);
    const Hdf5Handle collected = require_group(file, "collected");
    for (std::size_t i = 0; i < record.columns.size(); ++i) {
        writer.add_numbers(collected,
                           {record.columns[i].name, record.columns[i].description, "none", ""},
                           [&](const CaseRow& row) { return row.collected[i]; });
    }
    writer.add_integers({"steps", "accepted steps", "none", "1"},
                        [](const CaseRow& row) { return row.steps; });
    writer.add_integers({"newton_iterations", "of all steps", "none", "1"},
                        [](const CaseRow& row) { return row.newton_iterations; });
    writer.add_integers({"rejected_steps", "trials that were cut", "none", "1"},
                        [](const CaseRow& row) { return row.rejected_steps; });
    writer.add_numbers(
        file, {"time", "time reached", "none", "time"}, [](const CaseRow& row) { return row.time; });
    writer.add_numbers(file, {"seconds", "wall time of the case", "none", "s"}, [](const CaseRow& row) {
        return row.seconds;
    });
    writer.add_texts(file,
                     {"results", "results file, relative to the folder; empty if not kept", "none", ""},
                     [](const CaseRow& row) { return row.results; });
    writer.add_texts(
        file, {"warning", "what is suspicious", "none", ""}, [](const CaseRow& row) { return row.warning; });
}

// The bytes of the file, made in memory: the library may crash where a file of its own cannot be written.
std::string make_file(const BatchRecord& record, const std::vector<CaseRow>& rows) {
    constexpr std::size_t increment = 1 << 20;
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "properties");
    check_hdf5(H5Pset_fapl_core(access.id(), increment, false), "properties");
    Hdf5Handle file(H5Fcreate("index.h5", H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose, "creating");
    write_attributes(file, record);
    write_rows(file, record, rows);
    check_hdf5(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "flushing");
    const ssize_t size = H5Fget_file_image(file.id(), nullptr, 0);
    if (size < 0) throw Hdf5Error("taking its bytes");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (H5Fget_file_image(file.id(), bytes.data(), bytes.size()) < 0) throw Hdf5Error("taking its bytes");
    check_hdf5(file.reset(), "closing");
    return bytes;
}

}  // namespace

void write_batch_index(const std::filesystem::path& folder,
                       const BatchRecord& record,
                       const std::vector<CaseRow>& rows) {
    silence_hdf5();
    const std::filesystem::path path = folder / "index.h5";
    try {
        replace_file(path, make_file(record, rows));
    } catch (const Hdf5Error& failure) {
        throw FileError(path, std::string("cannot be written: ") + failure.what());
    }
}

}  // namespace gxrod
