#include "deck/rods/imperfections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "deck/loads/acting.hpp"
#include "deck/loads/combinations.hpp"
#include "deck/places/part.hpp"
#include "deck/rods/start_shapes.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/top_level.hpp"
#include "deck/sections/section_axes.hpp"
#include "deck/table/table.hpp"
#include "machine/file_error.hpp"
#include "model/displaced_start.hpp"
#include "model/settings/analysis_traits.hpp"
#include "watch/members.hpp"

namespace gxrod {

inline constexpr std::array<Choice<ModeKind>, 2> mode_kind_choices{
    {{"buckling", ModeKind::buckling}, {"vibration", ModeKind::vibration}}};
inline constexpr const auto& choices_of(ModeKind) { return mode_kind_choices; }

namespace {

ModeFinder mode_finder = nullptr;

struct ImperfectionTable : TableHead {
    std::optional<long> mode;
    ModeKind of = ModeKind::buckling;
    std::optional<std::string> load_case;
    std::optional<std::string> file;
    std::optional<double> amplitude;
    std::optional<double> bow, sway;
    std::optional<TableNames> on;
    std::optional<Vec3> direction;
};

}  // namespace

bool set_mode_finder(ModeFinder finder) {
    mode_finder = finder;
    return true;
}

const TableSpec& imperfection_table() {
    using T = ImperfectionTable;
    // clang-format off
    static const TableSpec table = Table<T>("[[imperfection]]",
            "By what the stress-free start differs from the perfect structure that the rest of the deck describes. "
            "Several add up.")
        .key("mode", &T::mode, "A linear buckling mode of the perfect structure under the loads of the first stage at "
             "t = 1: 1 is that of the smallest factor; or a mode of vibration. Its largest component is positive.")
            .between(1, 1000).also("buckling_mode eigenmode shape")
        .key("of", &T::of, "Whether the mode is one of buckling, or of vibration without loads, 1 that of the lowest "
             "frequency.")
            .only_with("mode").also("kind step")
        .key("file", &T::file, "A CSV file with a row for each node, in the order of the model: three displacements and "
             "three rotations, global, any size. Relative to the deck's folder.")
        .key("amplitude", &T::amplitude, "The largest displacement of the mode, or of the file's shape.")
            .unit("length").also("scale size factor")
        .key("bow", &T::bow, "The rise of half a sine wave along each member of the rods `on`, as a part of its "
             "length: 1/300.")
            .unit("1").also("bow_imperfection e0")
        .key("sway", &T::sway, "How much the whole structure leans along `direction`: the displacement at a height "
             "above its lowest point, over that height: 1/200. Up is against gravity, as of a rod's z_axis.")
            .unit("1").also("lean drift phi out_of_plumb")
        .key("on", &T::on, "The rods that are bent.")
            .names_of({"rod"}).only_with("bow").otherwise("all")
        .key("direction", &T::direction, "Of bow, across each member, or of sway, level; projected.")
            .unit("1").also("towards along")
        .with(add_load_case<T>)
        .exactly_one_of({"mode", "file", "bow", "sway"});
    // clang-format on
    return table;
}

namespace {

class ImperfectionMaker {
  public:
    ImperfectionMaker(const TableFiles& files, bool is_varied, Problem& problem, FaultList& faults)
        : files_(files), is_varied_(is_varied), problem_(problem), faults_(faults) {}

    // Adds an imperfection to a change, by `perfect`.
    void add(const ImperfectionTable& given, const BuildContext& context, StartChange& change) {
        const double factor = find_case_factor(given.load_case, context);
        if (factor == 0.0) return;
        if (given.bow || given.sway) return add_geometry(given, factor, context, change);
        if (!given.amplitude)
            return faults_.add(
                given.place, given.path_of(&given.amplitude), "missing; expected the largest displacement");
        if (given.direction) return context.add_fault(given, given.direction, "goes with bow or sway");
        const std::optional<std::vector<Vec6>> shape = given.file ? read_shape(given) : find_mode(given);
        if (shape) add_shape(problem_.model, *shape, factor * *given.amplitude, change);
    }

  private:
    void fault(const ImperfectionTable& given, const void* field, const std::string& message) {
        faults_.add(given.place_of(field), given.path_of(field), message);
    }

    std::optional<std::vector<Vec6>> parse(const std::string& bytes, const std::string& file) const {
        const FileTable table = read_file_table(bytes, file);
        if (table.rows.size() != problem_.model.nodes.size())
            throw FileError(file,
                            fmt::format("has {} rows; expected one for each of {} nodes",
                                        table.rows.size(),
                                        problem_.model.nodes.size()));
        std::vector<Vec6> shape;
        for (const CsvRow& row : table.rows) {
            Vec6& node = shape.emplace_back();
            for (std::size_t i = 0; i < 6; ++i) {
                const std::optional<double> number =
                    row.fields.size() == 6 ? read_finite(row.fields[i]) : std::nullopt;
                if (!number) throw FileError(file, fmt::format("line {}: expected 6 numbers", row.line));
                node[static_cast<Eigen::Index>(i)] = *number;
            }
        }
        return shape;
    }

    std::optional<std::vector<Vec6>> read_shape(const ImperfectionTable& given) {
        try {
            const std::string bytes = files_.read(*given.file);
            keep_file(*given.file, bytes, problem_.record.meshes);
            return parse(bytes, *given.file);
        } catch (const FileError& error) {
            fault(given, &given.file, error.what());
            return std::nullopt;
        }
    }

    // A shape that was found before is kept with the deck.
    std::optional<std::vector<Vec6>> find_mode(const ImperfectionTable& given) {
        const std::string name = given.path + ".csv";
        try {
            const std::string bytes = files_.read(name);
            keep_file(name, bytes, problem_.record.meshes);
            return parse(bytes, name);
        } catch (const FileError&) {
            // It is to be found now.
        }
        const AnalysisSettings& first = problem_.analysis();
        if (is_varied_)
            fault(given,
                  &given.mode,
                  "derivatives do not follow how a mode changes; expected its shape from a file");
        else if (given.of == ModeKind::buckling && (is_timed(first) || !has_steps(first)))
            fault(given, &given.mode, "goes with a static first stage, whose loads at t = 1 the mode is of");
        else if (mode_finder == nullptr)
            fault(given, &given.mode, "this program finds no modes; expected a file");
        else
            return find_new_mode(given, name);
        return std::nullopt;
    }

    std::optional<std::vector<Vec6>> find_new_mode(const ImperfectionTable& given, const std::string& name) {
        try {
            const std::vector<Vec6> shape = mode_finder(problem_, given.of, static_cast<int>(*given.mode));
            std::string bytes = "x,y,z,rx,ry,rz\n";
            for (const Vec6& node : shape)
                bytes +=
                    fmt::format("{},{},{},{},{},{}\n", node[0], node[1], node[2], node[3], node[4], node[5]);
            keep_file(name, bytes, problem_.record.meshes);
            return shape;
        } catch (const std::runtime_error& error) {
            fault(given, &given.mode, error.what());
            return std::nullopt;
        }
    }

    void add_geometry(const ImperfectionTable& given,
                      double factor,
                      const BuildContext& context,
                      StartChange& change) {
        const void* field = given.bow ? static_cast<const void*>(&given.bow) : &given.sway;
        if (given.amplitude)
            return fault(
                given, &given.amplitude, "goes with mode or file; bow and sway have a size themselves");
        if (!given.direction || given.direction->isZero(0.0))
            return fault(
                given, given.direction ? &given.direction : field, "expected a direction that is not zero");
        if (given.bow)
            add_bows(given, factor, context, change);
        else
            add_lean(given, factor, find_up(context), change);
    }

    void add_lean(const ImperfectionTable& given, double factor, const Vec3& up, StartChange& change) {
        const std::optional<Vec3> level = project_across(*given.direction, up);
        if (!level) return fault(given, &given.direction, "is vertical; expected a level direction");
        add_sway(problem_.model, up, factor * *given.sway * *level, change);
    }

    void add_bows(const ImperfectionTable& given,
                  double factor,
                  const BuildContext& context,
                  StartChange& change) {
        std::vector<bool> is_meant(problem_.model.rods.size(), !given.on);
        if (given.on) {
            for (const Part& part : find_parts(given, *given.on, context))
                is_meant[static_cast<std::size_t>(part.rod)] = true;
        }
        for (const Member& member : list_members(problem_.model)) {
            if (!is_meant[static_cast<std::size_t>(member.ends[0].rod)] ||
                add_bow(problem_.model, member, factor * *given.bow, *given.direction, change))
                continue;
            return fault(given,
                         &given.direction,
                         fmt::format("is along {}; expected a direction across each member, or `on` with "
                                     "those that it is across",
                                     member.name));
        }
    }

    const TableFiles& files_;
    bool is_varied_;
    Problem& problem_;
    FaultList& faults_;
};

// Why the deck's own axes and places do not allow another start, or "".
std::string explain_fixed_problem(const Problem& problem) {
    std::string reason = explain_fixed_start(problem.model);
    for (const HistoryRequest& history : problem.output.histories) {
        if (history.relative_node >= 0 && reason.empty())
            reason = "history " + history.name + " is relative to axes of the perfect structure";
    }
    const auto check_loads = [&](const Actions& actions) {
        for (const NodalLoad& load : actions.loads) {
            if (load.frame == Frame::body && reason.empty())
                reason =
                    load.key + " is in section axes of the perfect structure; expected frame = \"follower\"";
        }
    };
    check_loads(problem.model);
    for (const StagePlan& stage : problem.stages) check_loads(stage.actions);
    return reason;
}

// Joints of later stages are where those of the first one are.
void move_joints_of_stages(Problem& problem) {
    for (StagePlan& stage : problem.stages) {
        std::vector<Joint>& joints = stage.actions.joints;
        for (std::size_t i = 0; i < joints.size(); ++i) {
            joints[i].a.anchor = problem.model.joints[i].a.anchor;
            joints[i].b.anchor = problem.model.joints[i].b.anchor;
        }
    }
}

}  // namespace

std::vector<std::string> list_imperfection_cases(const CheckedTable& deck) {
    std::vector<std::string> cases;
    for (const ImperfectionTable& given : tables_of<ImperfectionTable>(deck, imperfection_table())) {
        if (given.load_case) cases.push_back(*given.load_case);
    }
    return cases;
}

void apply_imperfections(
    const CheckedTable& deck, const TableFiles& files, bool is_varied, Problem& problem, FaultList& faults) {
    const auto tables = tables_of<ImperfectionTable>(deck, imperfection_table());
    if (tables.empty()) return;
    const ImperfectionTable& first = tables.front();
    if (const std::string reason = explain_fixed_problem(problem); !reason.empty())
        return faults.add(first.place, first.path, "the start cannot be displaced: " + reason);
    const PointNames names(deck, {});
    const BuildContext context{deck, names, faults, problem.notes, problem.model};
    StartChange change(problem.model);
    ImperfectionMaker maker(files, is_varied, problem, faults);
    for (const ImperfectionTable& given : tables) maker.add(given, context, change);
    if (!faults.empty()) return;
    const std::string parted = displace_start(change, problem.model);
    if (!parted.empty())
        return faults.add(
            first.place,
            first.path,
            fmt::format("it parts the points of joint {}, which its arms carry; expected joints "
                        "at their nodes",
                        parted));
    move_joints_of_stages(problem);
    double largest = 0.0;
    for (const Vec3& displacement : change.displacements) largest = std::max(largest, displacement.norm());
    problem.notes.push_back(
        fmt::format("imperfection: the stress-free start is displaced by up to {:.6g}", largest));
}

}  // namespace gxrod
