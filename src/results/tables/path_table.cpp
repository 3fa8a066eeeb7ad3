#include "results/tables/path_table.hpp"

namespace gxrod {
namespace {

const char* name_kind(CriticalKind kind) {
    switch (kind) {
        case CriticalKind::limit:
            return "limit";
        case CriticalKind::bifurcation:
            return "bifurcation";
        case CriticalKind::touch:
            return "touch";
        case CriticalKind::release:
            return "release";
        case CriticalKind::divergence:
            break;
    }
    return "divergence";
}

const char* name_branching(Branching branching) {
    switch (branching) {
        case Branching::transcritical:
            return "transcritical";
        case Branching::supercritical:
            return "supercritical";
        case Branching::subcritical:
            return "subcritical";
        case Branching::unknown:
            break;
    }
    return "";
}

// Columns of a table, a row at a time.
struct CriticalColumns {
    std::vector<std::string> kinds, branchings, words, findings;
    std::vector<std::int64_t> branches, rows, before, after, multiplicities, located, first_shapes;
    std::vector<double> load_factors, arc_lengths;
    std::int64_t shapes = 0;

    void add(const CriticalPoint& point, std::size_t branch, std::int64_t row) {
        kinds.emplace_back(name_kind(point.kind));
        branchings.emplace_back(name_branching(point.branching));
        words.push_back(point.shape);
        branches.push_back(static_cast<std::int64_t>(branch));
        rows.push_back(row);
        before.push_back(point.pivots_before);
        after.push_back(point.pivots_after);
        multiplicities.push_back(point.multiplicity);
        located.push_back(point.is_located ? 1 : 0);
        first_shapes.push_back(point.kernel.empty() ? 0 : shapes + 1);
        shapes += static_cast<std::int64_t>(point.kernel.size());
        load_factors.push_back(point.load_factor);
        arc_lengths.push_back(point.arc_length);
    }
};

void write_points(const Hdf5Handle& group, const PathRecord& paths) {
    CriticalColumns table;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        for (std::size_t k = 0; k < paths[i].points.size(); ++k)
            table.add(paths[i].points[k], i, paths[i].rows[k]);
        table.findings.insert(table.findings.end(), paths[i].findings.begin(), paths[i].findings.end());
    }
    const auto write = [&](const char* name, const char* description, const auto& values) {
        write_dataset(group, {name, description, "none", "1"}, values);
    };
    write("kind", "limit, bifurcation, divergence; of contact touch or release", table.kinds);
    write("branching",
          "of a simple bifurcation: transcritical, supercritical or subcritical",
          table.branchings);
    write("branch", "that the point is on, as its row in branches; 0: the main path", table.branches);
    write("row", "of the histories", table.rows);
    write("load_factor", "there; of a point that was not located, where its step ends", table.load_factors);
    write("arc_length", "there, from the start of the path or branch", table.arc_lengths);
    write("pivots_before", "negative pivots of the tangent before it; -1 if not counted", table.before);
    write("pivots_after", "the same beyond it", table.after);
    write("multiplicity", "how many shapes lose their stiffness there", table.multiplicities);
    write("located",
          "1 if a step ends on it, 0 if it lies within the step that ends at the row",
          table.located);
    write("first_shape", "number of its first shape in the file of shapes; 0: none", table.first_shapes);
    write("words", "the first of its shapes in words", table.words);
    write("finding", "what gxrod run says of it", table.findings);
}

void write_branches(const Hdf5Handle& group, const PathRecord& paths) {
    std::vector<std::string> names, causes;
    std::vector<std::int64_t> parents, points, sides, rows;
    std::vector<std::int64_t> first_points;  // of each path in the table of all points
    std::int64_t count = 0;
    for (const FollowedPath& path : paths) {
        first_points.push_back(count);
        count += static_cast<std::int64_t>(path.points.size());
        names.push_back(path.name);
        causes.push_back(path.cause);
        parents.push_back(path.parent);
        points.push_back(path.parent < 0 ? -1
                                         : first_points[static_cast<std::size_t>(path.parent)] +
                                               static_cast<std::int64_t>(path.point));
        sides.push_back(path.side);
        rows.push_back(path.first_row);
    }
    const auto write = [&](const char* name, const char* description, const auto& values) {
        write_dataset(group, {name, description, "none", "1"}, values);
    };
    write("name", "as messages have it; the main path comes first", names);
    write("parent", "row of the path that it leaves; -1: the main path", parents);
    write("critical_point", "row of the point where it begins in critical_points; -1: none", points);
    write("side", "1 or -1: to which side of the point's shape", sides);
    write("first_row", "of the histories; the rows to that of the next branch are its own", rows);
    write("cause", "why it was not followed to its end; empty if it was", causes);
}

}  // namespace

void write_path_tables(const Hdf5Handle& group, const PathRecord& paths) {
    remove_path_tables(group);
    write_points(require_group(group, critical_points_name), paths);
    write_branches(require_group(group, branches_name), paths);
}

void remove_path_tables(const Hdf5Handle& group) {
    for (const char* name : {critical_points_name, branches_name}) {
        if (has_link(group, name)) check_hdf5(H5Ldelete(group.id(), name, H5P_DEFAULT), "removing a table");
    }
}

}  // namespace gxrod
