#include "deck/reading/copies.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string_view>

#include "rotation/rotation_map.hpp"

namespace gxrod {

const TableSpec& copies_table() {
    using T = CopiesTable;
    // clang-format off
    static const TableSpec table = Table<T>("rod.NAME.copies", "")
        .key("count", &T::count, "How many, the first included: they are a turn divided by this apart.")
            .required().between(2, 1000)
        .key("about", &T::about, "The axis of the turn; any length. Numbers, not expressions.")
            .unit("1")
        .key("through", &T::through, "A point of the axis. Numbers, not expressions.")
            .unit("length");
    // clang-format on
    return table;
}

namespace {

// Tables by name, and lists of tables, that can have copies.
constexpr std::array<std::string_view, 6> named_kinds{"rod", "body", "joint", "gear", "spring", "bushing"};
constexpr std::array<std::string_view, 5> listed_kinds{"connect", "load", "support", "history", "actuation"};

// Values of these keys are turned about a point of the axis; those of the second list are directions.
constexpr std::array<std::string_view, 9> place_keys{
    "from", "to", "through", "centre", "polyline", "spline", "at", "at_a", "at_b"};
constexpr std::array<std::string_view, 11> direction_keys{"axis",
                                                          "axis_b",
                                                          "x_axis",
                                                          "y_axis",
                                                          "z_axis",
                                                          "axes",
                                                          "directions",
                                                          "velocity",
                                                          "angular_velocity",
                                                          "force",
                                                          "moment"};
constexpr std::array<std::string_view, 2> line_load_keys{"force_per_length", "moment_per_length"};
// Texts of these keys name points or tables.
constexpr std::array<std::string_view, 8> naming_keys{
    "at", "on", "between", "points", "joints", "with", "relative_to", "copies"};

template <std::size_t count>
bool is_one_of(std::string_view key, const std::array<std::string_view, count>& keys) {
    return std::ranges::find(keys, key) != keys.end();
}

// A turn about an axis, whose copy is the number `number`, from 1.
struct Turn {
    int number = 1;
    double angle = 0.0;
    Vec3 axis = Vec3::UnitZ();
    Vec3 through = Vec3::Zero();

    Mat3 matrix() const { return Eigen::AngleAxisd(angle, axis).toRotationMatrix(); }
};

struct CopiesOf {
    long count = 0;
    Vec3 axis = Vec3::UnitZ();
    Vec3 through = Vec3::Zero();

    Turn turn(int number) const {
        return {number, 2.0 * std::numbers::pi * (number - 1) / static_cast<double>(count), axis, through};
    }
};

std::optional<double> number_of(const DeckNode& node) {
    if (const auto* integer = std::get_if<std::int64_t>(&node.value)) return static_cast<double>(*integer);
    if (const auto* number = std::get_if<double>(&node.value)) return *number;
    return std::nullopt;
}

std::optional<Vec3> vector_of(const DeckNode& node) {
    if (node.array() == nullptr || node.array()->size() != 3) return std::nullopt;
    Vec3 vector;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<double> number = number_of((*node.array())[i]);
        if (!number) return std::nullopt;
        vector[static_cast<Eigen::Index>(i)] = *number;
    }
    return vector;
}

bool is_vector(const DeckNode& node) {
    if (node.array() == nullptr || node.array()->size() != 3) return false;
    return std::ranges::all_of(*node.array(), [](const DeckNode& one) {
        return one.text() != nullptr || number_of(one).has_value();
    });
}

// The sum of the components times the factors, plus a number: a number, or an expression.
void set_sum(const DeckNode::Array& components, const Vec3& factors, double constant, DeckNode& sum) {
    std::string text;
    for (int i = 0; i < 3; ++i) {
        const DeckNode& component = components[static_cast<std::size_t>(i)];
        const std::optional<double> number = number_of(component);
        if (number) constant += factors[i] * *number;
        if (number || factors[i] == 0.0) continue;
        text += fmt::format("{}({:.17g})*({})", text.empty() ? "" : " + ", factors[i], *component.text());
    }
    if (text.empty())
        sum.value = constant;
    else
        sum.value = fmt::format("{} + ({:.17g})", text, constant);
}

// Turns a vector, or the vectors of a list.
void turn_vectors(const Mat3& R, const Vec3& shift, DeckNode& node) {
    if (node.array() == nullptr) return;
    if (!is_vector(node)) {
        for (DeckNode& one : *node.array()) turn_vectors(R, shift, one);
        return;
    }
    const DeckNode::Array before = *node.array();
    for (int i = 0; i < 3; ++i)
        set_sum(before, R.row(i), shift[i], (*node.array())[static_cast<std::size_t>(i)]);
}

DeckNode make_rows(const Mat3& R, const Place& place) {
    DeckNode rows{DeckNode::Array{}, place};
    // The rows are the turned x, y and z.
    for (int i = 0; i < 3; ++i) {
        DeckNode row{DeckNode::Array{}, place};
        for (int j = 0; j < 3; ++j) row.array()->push_back({R(j, i), place});
        rows.array()->push_back(std::move(row));
    }
    return rows;
}

void add_entry(DeckNode& table, const char* key, DeckNode node) {
    table.table()->push_back({key, node.place, std::move(node)});
}

class CopyMaker {
  public:
    CopyMaker(DeckNode& tree, FaultList& faults) : tree_(&tree), faults_(&faults) {}

    void expand() {
        for (const std::string_view kind : named_kinds) list_copies(kind);
        if (!faults_->empty()) return;
        for (const std::string_view kind : named_kinds) expand_named(kind);
        for (const std::string_view kind : listed_kinds) expand_listed(kind);
    }

  private:
    void add_fault(const DeckNode& node, const std::string& path, const std::string& message) {
        faults_->add(node.place, path, message);
    }

    // Finds the copies that tables define, by name.
    void list_copies(std::string_view kind) {
        const DeckEntry* tables = tree_->find(kind);
        if (tables == nullptr || tables->node.table() == nullptr) return;
        for (const DeckEntry& one : *tables->node.table()) {
            const DeckEntry* copies = find_copies(one.node);
            if (copies == nullptr || copies->node.text() != nullptr) continue;
            const std::string path = fmt::format("{}.{}.copies", kind, one.key);
            if (const std::optional<CopiesOf> found = read(copies->node, path)) copied_[one.key] = *found;
        }
        for (const DeckEntry& one : *tables->node.table()) {
            const DeckEntry* copies = find_copies(one.node);
            if (copies == nullptr || copies->node.text() == nullptr) continue;
            followers_.push_back({one.key, *copies->node.text()});
        }
        resolve_followers();
    }

    // Names that follow others can be named, too.
    void resolve_followers() {
        for (bool is_new = true; is_new;) {
            is_new = false;
            for (const auto& [name, leader] : followers_) {
                const auto found = copied_.find(leader);
                if (found != copied_.end()) is_new = copied_.emplace(name, found->second).second || is_new;
            }
        }
    }

    static const DeckEntry* find_copies(const DeckNode& table) {
        return table.table() == nullptr ? nullptr : table.find("copies");
    }

    std::optional<CopiesOf> read(const DeckNode& node, const std::string& path) {
        CopiesOf copies;
        if (node.table() == nullptr) {
            add_fault(
                node, path, "expected { count = 3, about = [0, 0, 1] } or the name of a table with copies");
            return std::nullopt;
        }
        for (const DeckEntry& entry : *node.table()) {
            if (!read_entry(entry, path, copies)) return std::nullopt;
        }
        if (copies.count == 0) {
            add_fault(node, path, "expected count, a number from 2 to 1000");
            return std::nullopt;
        }
        return copies;
    }

    bool read_entry(const DeckEntry& entry, const std::string& path, CopiesOf& copies) {
        const std::string key = path + "." + entry.key;
        if (entry.key == "count") {
            const auto* count = std::get_if<std::int64_t>(&entry.node.value);
            if (count != nullptr && *count >= 2 && *count <= 1000) {
                copies.count = *count;
                return true;
            }
            add_fault(entry.node, key, "expected a whole number from 2 to 1000");
            return false;
        }
        const std::optional<Vec3> vector = vector_of(entry.node);
        if (entry.key == "about" && vector && vector->norm() > 0.0) {
            copies.axis = vector->normalized();
            return true;
        }
        if (entry.key == "through" && vector) {
            copies.through = *vector;
            return true;
        }
        const bool is_known = entry.key == "about" || entry.key == "through";
        add_fault(entry.node,
                  key,
                  is_known ? "expected 3 numbers, not all of them zero for about"
                           : "unknown key; expected count, about or through");
        return false;
    }

    // The copies of a table; nullopt if it has none, or with a fault.
    std::optional<CopiesOf> find_of(const DeckNode& table, const std::string& path) {
        const DeckEntry* copies = find_copies(table);
        if (copies == nullptr) return std::nullopt;
        const std::string key = path + ".copies";
        if (copies->node.text() == nullptr) return read(copies->node, key);
        const auto found = copied_.find(*copies->node.text());
        if (found != copied_.end()) return found->second;
        add_fault(copies->node, key, fmt::format("\"{}\" names no table with copies", *copies->node.text()));
        return std::nullopt;
    }

    void expand_named(std::string_view kind) {
        DeckEntry* tables = tree_->find(kind);
        if (tables == nullptr || tables->node.table() == nullptr) return;
        std::set<std::string> taken;
        for (const DeckEntry& one : *tables->node.table()) taken.insert(one.key);
        DeckNode::Table expanded;
        for (DeckEntry& one : *tables->node.table()) {
            const std::string path = fmt::format("{}.{}", kind, one.key);
            const std::optional<CopiesOf> copies = find_of(one.node, path);
            if (!copies) {
                expanded.push_back(std::move(one));
                continue;
            }
            for (int number = 1; number <= copies->count; ++number) {
                const std::string name = fmt::format("{}_{}", one.key, number);
                if (taken.contains(name))
                    add_fault(one.node, path, fmt::format("its copy {} has the name of another table", name));
                expanded.push_back({name, one.place, one.node});
                finish(kind, path, copies->turn(number), expanded.back().node);
            }
        }
        *tables->node.table() = std::move(expanded);
    }

    void expand_listed(std::string_view kind) {
        DeckEntry* tables = tree_->find(kind);
        if (tables == nullptr || tables->node.array() == nullptr) return;
        DeckNode::Array expanded;
        std::size_t index = 0;
        for (DeckNode& one : *tables->node.array()) {
            const std::string path = fmt::format("{}[{}]", kind, index++);
            const std::optional<CopiesOf> copies = find_of(one, path);
            if (!copies) {
                expanded.push_back(std::move(one));
                continue;
            }
            for (int number = 1; number <= copies->count; ++number) {
                expanded.push_back(one);
                finish(kind, path, copies->turn(number), expanded.back());
                DeckEntry* name = expanded.back().find("name");
                if (name != nullptr && name->node.text() != nullptr)
                    name->node.value = fmt::format("{}_{}", *name->node.text(), number);
            }
        }
        *tables->node.array() = std::move(expanded);
    }

    // Makes a table the copy that a turn says.
    void finish(std::string_view kind, const std::string& path, const Turn& turn, DeckNode& table) {
        std::erase_if(*table.table(), [](const DeckEntry& entry) { return entry.key == "copies"; });
        number_names(turn.number, table);
        check_kind(kind, path, table);
        if (turn.number == 1) return;
        turn_table(kind, turn, table);
        const Mat3 R = turn.matrix();
        if (kind == "body") turn_attitude(path, turn, table);
        if (kind == "bushing" || kind == "support") turn_axes(kind, R, table);
    }

    // Gives names of tables with copies the number of the copy: "blade.end" is "blade_2.end".
    void number_names(int number, DeckNode& table) const {
        for (DeckEntry& entry : *table.table()) {
            if (is_one_of(entry.key, naming_keys)) number_texts(number, entry.node);
        }
    }

    void number_texts(int number, DeckNode& node) const {
        if (node.array() != nullptr) {
            for (DeckNode& one : *node.array()) number_texts(number, one);
        }
        if (node.text() == nullptr) return;
        const std::string text = *node.text();
        const std::size_t end = std::min(text.find_first_of(".@"), text.size());
        if (copied_.contains(text.substr(0, end)))
            node.value = fmt::format("{}_{}{}", text.substr(0, end), number, text.substr(end));
    }

    // Whether a text, or one of a list, has a *.
    static bool has_pattern(const DeckNode& node) {
        if (node.array() != nullptr) return std::ranges::any_of(*node.array(), has_pattern);
        return node.text() != nullptr && node.text()->find('*') != std::string::npos;
    }

    // What has no turned copy, or none without another key.
    void check_kind(std::string_view kind, const std::string& path, const DeckNode& table) {
        const auto refuse = [&](const char* key, const char* message) {
            if (const DeckEntry* entry = table.find(key)) add_fault(entry->node, path + "." + key, message);
        };
        if (kind == "rod") {
            refuse("mesh", "a rod of a mesh has no copies; expected line, arc, helix, polyline or spline");
            refuse("catenary", "a catenary has no copies; expected line, arc, helix, polyline or spline");
            if (table.find("y_axis") == nullptr && table.find("z_axis") == nullptr)
                add_fault(table, path + ".copies", "copies need y_axis or z_axis, which is turned with them");
        }
        if (kind == "joint" && table.find("curve") != nullptr && table.find("x_axis") == nullptr)
            add_fault(table, path + ".copies", "copies of a cam need x_axis, which is turned with them");
        for (const char* key : {"at", "on", "points"}) {
            const DeckEntry* entry = table.find(key);
            if (entry != nullptr && has_pattern(entry->node))
                add_fault(entry->node,
                          path + "." + key,
                          "a pattern names all copies at once; leave out copies, or name one of each");
        }
        refuse("where", "a condition on the place is not turned with copies; name the points");
        if (kind == "load") {
            const DeckEntry* frame = table.find("frame");
            if (frame == nullptr || frame->node.text() == nullptr || *frame->node.text() != "body")
                refuse("file",
                       "components of a file are not turned with copies; expected frame = \"body\", or a "
                       "load for each copy");
            for (const char* key : {"force", "moment", "force_per_length", "moment_per_length"})
                check_load(key, path, table);
        }
    }

    // Components that grow with t by themselves, and others that have t, do not mix.
    void check_load(const char* key, const std::string& path, const DeckNode& table) {
        const DeckEntry* vector = table.find(key);
        if (vector == nullptr || vector->node.array() == nullptr) return;
        bool has_time = false, grows = false;
        for (const DeckNode& component : *vector->node.array()) {
            const bool is_text = component.text() != nullptr;
            if (is_text && names_one_of(*component.text(), {"x", "y", "z", "vx", "vy", "vz"}))
                return add_fault(component,
                                 path + "." + key,
                                 "a force by place or velocity is not turned with copies; write each load");
            const bool is_timed = is_text && names_one_of(*component.text(), {"t"});
            has_time = has_time || is_timed;
            grows = grows || (!is_timed && number_of(component) != 0.0);
        }
        if (has_time && grows)
            add_fault(vector->node,
                      path + "." + key,
                      "copies are turned: expected t in all components that are not 0, or in none");
    }

    // Whether an expression has one of these names.
    static bool names_one_of(const std::string& text, std::initializer_list<std::string_view> names) {
        const auto is_part = [](char letter) {
            return letter == '_' || std::isalnum(static_cast<unsigned char>(letter)) != 0;
        };
        for (auto first = text.begin(); first != text.end();) {
            first = std::find_if(first, text.end(), is_part);
            const auto last = std::find_if_not(first, text.end(), is_part);
            if (std::ranges::find(names, std::string_view(first, last)) != names.end()) return true;
            first = last;
        }
        return false;
    }

    void turn_table(std::string_view kind, const Turn& turn, DeckNode& table) const {
        const Mat3 R = turn.matrix();
        const Vec3 shift = turn.through - R * turn.through;
        const DeckEntry* frame = table.find("frame");
        const bool is_in_body =
            frame != nullptr && frame->node.text() != nullptr && *frame->node.text() == "body";
        for (DeckEntry& entry : *table.table()) {
            const bool is_load =
                entry.key == "force" || entry.key == "moment" || is_one_of(entry.key, line_load_keys);
            if (is_load && (kind != "load" || is_in_body)) continue;
            const bool is_name = entry.key == "at" && is_one_of(kind, listed_kinds);
            if (is_one_of(entry.key, place_keys) && !is_name) turn_vectors(R, shift, entry.node);
            if (is_load || is_one_of(entry.key, direction_keys)) turn_vectors(R, Vec3::Zero(), entry.node);
            const bool is_curve =
                entry.key == "line" || entry.key == "arc" || entry.key == "helix" || entry.key == "rest";
            if (kind == "rod" && is_curve && entry.node.table() != nullptr)
                turn_table(kind, turn, entry.node);
        }
    }

    void turn_attitude(const std::string& path, const Turn& turn, DeckNode& table) {
        const Vec3 by = turn.angle * turn.axis;
        DeckEntry* attitude = table.find("rotation_vector");
        const std::optional<Vec3> before =
            attitude == nullptr ? Vec3(Vec3::Zero()) : vector_of(attitude->node);
        if (!before)
            return add_fault(attitude->node, path + ".rotation_vector", "copies need three numbers here");
        const Vec3 after = log(Quat(exp_quaternion(by) * exp_quaternion(*before)));
        DeckNode node{DeckNode::Array{}, table.place};
        for (int i = 0; i < 3; ++i) node.array()->push_back({after[i], table.place});
        if (attitude == nullptr)
            add_entry(table, "rotation_vector", std::move(node));
        else
            attitude->node = std::move(node);
    }

    // Axes that a deck leaves out are the global ones, turned with the copy.
    static void turn_axes(std::string_view kind, const Mat3& R, DeckNode& table) {
        const DeckEntry* axes = table.find("axes");
        if (axes != nullptr && axes->node.text() == nullptr) return;  // turned already
        if (kind == "bushing" && axes != nullptr) {
            if (table.find("directions") == nullptr)
                add_entry(table, "directions", make_rows(R, table.place));
            return;
        }
        const DeckEntry* fix = table.find("fix");
        const bool is_clamp = fix != nullptr && fix->node.text() != nullptr && *fix->node.text() == "all";
        if (kind == "support" && is_clamp && table.find("move") == nullptr) return;
        add_entry(table, "axes", make_rows(R, table.place));
    }

    DeckNode* tree_;
    FaultList* faults_;
    std::map<std::string, CopiesOf, std::less<>> copied_;
    std::vector<std::pair<std::string, std::string>> followers_;
};

}  // namespace

bool has_copies(const DeckNode& tree) {
    const auto is_copied = [](const DeckNode& table) {
        return table.table() != nullptr && table.find("copies") != nullptr;
    };
    for (const DeckEntry& entry : *tree.table()) {
        if (entry.node.array() != nullptr && std::ranges::any_of(*entry.node.array(), is_copied)) return true;
        if (entry.node.table() == nullptr) continue;
        for (const DeckEntry& one : *entry.node.table()) {
            if (is_copied(one.node)) return true;
        }
    }
    return false;
}

void expand_copies(DeckNode& tree, FaultList& faults) { CopyMaker(tree, faults).expand(); }

}  // namespace gxrod
