#include "results/shape_file.hpp"

#include <algorithm>
#include <memory>

#include "machine/file_error.hpp"
#include "results/file/ordered_driver.hpp"
#include "results/file/output_file.hpp"
#include "results/provenance.hpp"
#include "results/tables/frame_mesh.hpp"
#include "results/tables/frame_topology.hpp"

namespace gxrod {
namespace {

double find_extent(const Model& model) {
    Eigen::AlignedBox3d box;
    for (const Node& node : model.nodes) box.extend(node.position);
    const double extent = box.isEmpty() ? 0.0 : box.diagonal().norm();
    return extent > 0.0 ? extent : 1.0;
}

class ShapeFile {
  public:
    ShapeFile(const Hdf5Handle& root, const Model& model, hsize_t count)
        : vtkhdf_(require_group(root, "VTKHDF")),
          steps_(require_group(vtkhdf_, "Steps")),
          points_(model.nodes.size()),
          count_(count) {
        write_frame_topology(vtkhdf_, make_frame_mesh(model), points_);
        const auto steps = static_cast<std::int64_t>(count);
        const std::array<std::int64_t, 1> number{steps};
        write_attribute(steps_.id(), "NSteps", number);
    }

    void write_steps() {
        std::vector<double> numbers(count_);
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<double>(i + 1);
        write_dataset(steps_, {"Values", "number of the shape, from 1", "none", "1"}, numbers);
        const std::vector<std::int64_t> zeros(count_, 0), ones(count_, 1);
        for (const char* name : {"PartOffsets", "CellOffsets", "ConnectivityIdOffsets"})
            write_dataset(steps_, {name, "all steps share them: 0", "none", "1"}, zeros);
        write_dataset(steps_, {"NumberOfParts", "parts of each step: 1", "none", "1"}, ones);
    }

    // Of one equilibrium, or of one for each shape.
    void write_points(std::span<const std::span<const NodeMotion>> equilibria) {
        std::vector<double> values;
        for (const auto& nodes : equilibria) {
            for (const NodeMotion& node : nodes) values.insert(values.end(), node.r.begin(), node.r.end());
        }
        const std::array<hsize_t, 2> size{points_ * equilibria.size(), 3};
        write_dataset(vtkhdf_, {"Points", "positions in equilibrium", "spatial", "length"}, size, values);
        std::vector<std::int64_t> offsets = list_first_rows();
        if (equilibria.size() == 1) offsets.assign(count_, 0);
        write_dataset(steps_, {"PointOffsets", "first row of each shape in Points", "none", "1"}, offsets);
    }

    // Components from `first` on, of each shape.
    void write_field(const DatasetLabel& label,
                     int first,
                     const std::vector<const std::vector<Vec6>*>& shapes,
                     std::span<const double> scales) {
        std::vector<double> values;
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            for (const Vec6& node : *shapes[i]) {
                const Vec3 part = scales[i] * node.segment<3>(first);
                values.insert(values.end(), part.begin(), part.end());
            }
        }
        const std::array<hsize_t, 2> size{points_ * count_, 3};
        write_dataset(require_group(vtkhdf_, "PointData"), label, size, values);
        write_dataset(require_group(steps_, "PointDataOffsets"),
                      {label.name, "first row of each shape", "none", "1"},
                      list_first_rows());
    }

  private:
    std::vector<std::int64_t> list_first_rows() const {
        std::vector<std::int64_t> rows(count_);
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<std::int64_t>(i * points_);
        return rows;
    }

    Hdf5Handle vtkhdf_, steps_;
    std::size_t points_;
    hsize_t count_;
};

}  // namespace

std::vector<double> find_shape_scales(const Model& model, const std::vector<const Shape*>& shapes) {
    constexpr double part = 0.1, angle = 0.3;
    const double extent = find_extent(model);
    std::vector<double> scales;
    for (const Shape* shape : shapes) {
        double displacement = 0.0, rotation = 0.0;
        for (const Vec6& node : shape->nodes) {
            displacement = std::max(displacement, node.head<3>().norm());
            rotation = std::max(rotation, node.tail<3>().norm());
        }
        constexpr double none = 1e-9;
        const bool moves = displacement > none * extent * rotation;
        scales.push_back(moves ? part * extent / displacement : rotation > 0.0 ? angle / rotation : 1.0);
    }
    return scales;
}

std::filesystem::path shape_file_path(const std::filesystem::path& results, const std::string& stage) {
    return results.parent_path() / (results.stem().string() + "." + stage + ".vtkhdf");
}

void write_shape_file(const std::filesystem::path& path,
                      const DeckRecord& deck,
                      const Model& model,
                      std::span<const std::span<const NodeMotion>> equilibria,
                      const std::vector<const Shape*>& shapes,
                      std::span<const double> scales,
                      const std::vector<const std::vector<Vec6>*>& imaginary) {
    std::vector<const std::vector<Vec6>*> real;
    for (const Shape* shape : shapes) real.push_back(&shape->nodes);
    const auto file = std::make_shared<OrderedFile>(create_output_file(path, Existing::replace));
    try {
        Hdf5Handle hdf5 = create_hdf5(*file);
        {
            const Hdf5Handle root(H5Gopen2(hdf5.id(), "/", H5P_DEFAULT), H5Gclose, "opening the root");
            write_provenance(root, deck);
            ShapeFile out(root, model, shapes.size());
            out.write_steps();
            out.write_points(equilibria);
            out.write_field({"displacement", "of the shape, scaled", "spatial", "length"}, 0, real, scales);
            out.write_field({"rotation_vector", "of the shape, scaled", "spatial", "angle"}, 3, real, scales);
            if (!imaginary.empty()) {
                out.write_field({"displacement_imaginary", "imaginary part, scaled", "spatial", "length"},
                                0,
                                imaginary,
                                scales);
                out.write_field({"rotation_vector_imaginary", "imaginary part, scaled", "spatial", "angle"},
                                3,
                                imaginary,
                                scales);
            }
            rewrite_attribute(root.id(), "status", std::string("complete"));
        }
        check_hdf5(hdf5.reset(), "closing the file");
        file->commit();
        file->seal();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        file->abandon();
        throw WriteError(path, std::string("cannot write: ") + error.what());
    }
}

}  // namespace gxrod
