#include "results/survey.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "machine/child_process.hpp"
#include "machine/file_error.hpp"
#include "results/chunk_check.hpp"
#include "results/hdf5_objects.hpp"
#include "results/hdf5_reader.hpp"
#include "results/text_check.hpp"

// What fails with an error here does so for the reader, too, who tells of it; so errors are passed over.
namespace gxrod {
namespace {

constexpr ChildLimits limits{.processor_seconds = 5};
constexpr hssize_t most_bytes = 1 << 20;  // of numbers, which are all read alike

// What no reader asks for is not read.
bool is_read_whole(hid_t type, hssize_t count) {
    const auto size = static_cast<hssize_t>(H5Tget_size(type));
    const H5T_class_t kind = H5Tget_class(type);
    return kind != H5T_COMPOUND && kind != H5T_ARRAY && kind != H5T_VLEN && size > 0 &&
           count <= most_bytes / size;
}

// The library reads numbers whose bits lie beyond their bytes, and writes such.
bool has_bits_within(hid_t number) {
    const std::size_t digits = H5Tget_precision(number);
    const int first = H5Tget_offset(number);
    if (digits == 0 || first < 0 || static_cast<std::size_t>(first) + digits > 8 * H5Tget_size(number))
        return false;
    if (H5Tget_class(number) != H5T_FLOAT) return true;
    std::size_t sign = 0, exponent = 0, exponent_size = 0, mantissa = 0, mantissa_size = 0;
    if (H5Tget_fields(number, &sign, &exponent, &exponent_size, &mantissa, &mantissa_size) < 0) return false;
    return sign < digits && exponent_size <= digits && exponent <= digits - exponent_size &&
           mantissa_size <= digits && mantissa <= digits - mantissa_size;
}

// It also takes the room that rows have in memory from another place than the size of a number. No number
// that gxrod writes is longer than eight bytes.
bool is_sound_type(hid_t type) {
    const H5T_class_t kind = H5Tget_class(type);
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) return true;
    const std::size_t size = H5Tget_size(type);
    return std::has_single_bit(size) && size <= 8 && has_bits_within(type);
}

// The library takes as many times the memory of a text as a character has bytes, and converts its bits.
bool has_single_bytes(hid_t text) {
    const Hdf5Handle character(H5Tget_super(text), H5Tclose, "type");
    return H5Tget_class(character.id()) == H5T_INTEGER && H5Tget_size(character.id()) == 1 &&
           has_bits_within(character.id());
}

// Of the nodes of its trees and of addresses. Where they are others than gxrod's, which are the library's
// usual ones, it writes nodes over what lies behind them.
bool has_usual_sizes(hid_t file) {
    const Hdf5Handle own(H5Fget_create_plist(file), H5Pclose, "properties of a file");
    const Hdf5Handle usual(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "properties of files");
    const auto read = [](const Hdf5Handle& properties) {
        std::array<unsigned, 3> nodes{};
        std::array<std::size_t, 2> bytes{};
        check_hdf5(H5Pget_sym_k(properties.id(), &nodes[0], &nodes[1]), "sizes of trees");
        check_hdf5(H5Pget_istore_k(properties.id(), &nodes[2]), "sizes of trees");
        check_hdf5(H5Pget_sizes(properties.id(), &bytes[0], &bytes[1]), "sizes of addresses");
        return std::pair{nodes, bytes};
    };
    return read(own) == read(usual);
}

template <class Action>
void pass_over_errors(Action&& action) {
    restart_processor_clock(limits);
    try {
        action();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        H5Eclear2(H5E_DEFAULT);
    }
}

struct Links {
    std::vector<std::string> hard;
    bool are_found = true;    // by their names
    bool stay_within = true;  // the file
};

herr_t add_link(hid_t group, const char* name, const H5L_info_t* information, void* data) {
    auto& links = *static_cast<Links*>(data);
    // Where a new link belongs among others that it does not find, the library ends the process.
    links.are_found = links.are_found && H5Lexists(group, name, H5P_DEFAULT) > 0;
    if (information->type == H5L_TYPE_HARD) links.hard.emplace_back(name);
    if (information->type != H5L_TYPE_HARD && information->type != H5L_TYPE_SOFT) links.stay_within = false;
    return 0;
}

// The library would open, of a dataset, the files that have its rows; of a run that goes on, to write them.
bool has_own_rows(hid_t dataset) {
    const Hdf5Handle properties(H5Dget_create_plist(dataset), H5Pclose, "properties of a dataset");
    return H5Pget_layout(properties.id()) != H5D_VIRTUAL && H5Pget_external_count(properties.id()) == 0;
}

// Where the first rows are in the file; HADDR_UNDEF if there are none.
haddr_t find_rows(hid_t dataset) {
    const Hdf5Handle properties(H5Dget_create_plist(dataset), H5Pclose, "properties of a dataset");
    if (H5Pget_layout(properties.id()) != H5D_CHUNKED) return H5Dget_offset(dataset);
    return find_chunk_ends(dataset).value_or(ChunkEnds{}).first.address;
}

// Visits all objects of a file. What cannot even be listed is not passed over: a reader, who asks by name,
// may come to what lies behind it.
class Survey {
  public:
    explicit Survey(TextCheck texts) : texts_(std::move(texts)) {}

    void visit(const Hdf5Handle& object) {
        restart_processor_clock(limits);
        H5O_info_t information{};
        expect_listed(H5Oget_info2(object.id(), &information, H5O_INFO_BASIC | H5O_INFO_NUM_ATTRS));
        if (!is_listed_ || !seen_.insert(information.addr).second) return;
        if (information.type == H5O_TYPE_DATASET) pass_over_errors([&] { visit_dataset(object.id()); });
        for (hsize_t i = 0; i < information.num_attrs; ++i) visit_attribute(object, i);
        if (information.type == H5O_TYPE_GROUP) visit_members(object);
    }
    // What is wrong, empty if nothing is.
    std::string fault() const {
        if (!is_listed_) return "it cannot list all that is there";
        if (!stays_within_) return "it would go to other files";
        if (!has_sound_numbers_) return "it would go beyond the ends of numbers";
        if (!has_sound_chunks_) return "it would go beyond the ends of rows";
        return has_sound_texts_ ? "" : "it would go beyond the ends of texts";
    }

  private:
    void visit_dataset(hid_t dataset) {
        check_rows(dataset);
        if (!stays_within_ || !has_sound_chunks_) return;
        const Hdf5Handle type(H5Dget_type(dataset), H5Tclose, "type");
        const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "dataspace");
        read_values(type, space, [&](hid_t memory, void* buffer) {
            return H5Dread(dataset, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer);
        });
    }

    void check_rows(hid_t dataset) {
        try {
            stays_within_ = stays_within_ && has_own_rows(dataset);
            const haddr_t place = find_rows(dataset);
            const bool has_own_place = place == HADDR_UNDEF || places_.insert(place).second;
            has_sound_chunks_ = has_sound_chunks_ && has_own_place &&
                                has_sound_chunks(dataset, [] { restart_processor_clock(limits); });
        } catch (const Hdf5Error&) {
            is_listed_ = false;
            throw;
        }
    }

    void visit_attribute(const Hdf5Handle& object, hsize_t index) {
        const hid_t id =
            H5Aopen_by_idx(object.id(), ".", H5_INDEX_NAME, H5_ITER_INC, index, H5P_DEFAULT, H5P_DEFAULT);
        expect_listed(id < 0 ? -1 : 0);
        if (id < 0) return;
        const Hdf5Handle attribute(id, H5Aclose, "an attribute");
        pass_over_errors([&] {
            const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose, "type");
            const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose, "dataspace");
            check_text_room(attribute, type, space);
            read_values(type, space, [&](hid_t memory, void* buffer) {
                return H5Aread(attribute.id(), memory, buffer);
            });
        });
    }

    // The library keeps a text's reference with the attribute, in as much room as the type says.
    void check_text_room(const Hdf5Handle& attribute, const Hdf5Handle& type, const Hdf5Handle& space) {
        if (H5Tis_variable_str(type.id()) <= 0) return;
        const auto count = static_cast<hsize_t>(H5Sget_simple_extent_npoints(space.id()));
        has_sound_texts_ =
            has_sound_texts_ && H5Aget_storage_size(attribute.id()) == count * text_reference_bytes;
    }

    void visit_members(const Hdf5Handle& group) {
        // All of it, so that the library goes along the leaves of the group's tree, as other programs do.
        H5O_info_t information{};
        expect_listed(H5Oget_info2(group.id(), &information, H5O_INFO_ALL));
        Links links;
        expect_listed(H5Literate(group.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add_link, &links));
        is_listed_ = is_listed_ && links.are_found;
        stays_within_ = stays_within_ && links.stay_within;
        for (const std::string& name : links.hard) {
            pass_over_errors([&] {
                visit({H5Oopen(group.id(), name.c_str(), H5P_DEFAULT), H5Oclose, "an object"});
            });
        }
    }

    // Of a dataset or an attribute: numbers if they are few, and where its texts lie.
    template <class Read>
    void read_values(const Hdf5Handle& type, const Hdf5Handle& space, Read read) {
        has_sound_numbers_ = has_sound_numbers_ && is_sound_type(type.id());
        const hssize_t count = H5Sget_simple_extent_npoints(space.id());
        if (!has_sound_numbers_ || count <= 0 || !is_read_whole(type.id(), count)) return;
        const auto make_buffer = [&](std::size_t bytes) {
            return std::vector<std::byte>(static_cast<std::size_t>(count) * bytes);
        };
        if (H5Tis_variable_str(type.id()) > 0) {
            const bool were_sound = std::exchange(has_sound_texts_, false);  // also if this throws
            std::vector<std::byte> references = make_buffer(text_reference_bytes);
            has_sound_texts_ = has_single_bytes(type.id()) &&
                               read(texts_.reference_type(), references.data()) >= 0 &&
                               texts_.are_sound(references) && were_sound;
        } else {
            read(type.id(), make_buffer(H5Tget_size(type.id())).data());
        }
    }

    void expect_listed(herr_t result) { is_listed_ = is_listed_ && result >= 0; }

    TextCheck texts_;
    std::set<haddr_t> seen_;
    std::set<haddr_t> places_;  // of rows
    bool is_listed_ = true;
    bool stays_within_ = true;
    bool has_sound_numbers_ = true;
    bool has_sound_chunks_ = true;
    bool has_sound_texts_ = true;
};

// What is wrong with a file, empty if nothing is.
std::string survey(const std::filesystem::path& path) {
    silence_hdf5();
    TextCheck texts(path);
    try {
        const Hdf5Reader file(path);
        if (!has_usual_sizes(file.id())) return "its trees are not of the size of gxrod's";
        Survey all(std::move(texts));
        all.visit({H5Oopen(file.id(), "/", H5P_DEFAULT), H5Oclose, "an object"});
        return all.fault();
    } catch (const std::runtime_error&) {
        return "";
    }
}

}  // namespace

void survey_file(const std::filesystem::path& path) {
    std::string fault;
    try {
        fault = run_in_child([&] { return survey(path); }, limits);
    } catch (const ChildMemoryError&) {
        throw std::bad_alloc();
    } catch (const ChildError& error) {
        fault = error.what();
    }
    if (!fault.empty()) throw FileError(path, "is damaged: where HDF5's library reads it, " + fault);
}

}  // namespace gxrod
