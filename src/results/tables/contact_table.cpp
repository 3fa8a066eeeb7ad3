#include "results/tables/contact_table.hpp"

namespace gxrod {
namespace {

constexpr RowShape pair_row{2, true};

std::span<const double> numbers(const Vec3& vector) { return {vector.data(), 3}; }

Hdf5Handle require_contacts(const Hdf5Handle& root, const Model& model) {
    const bool is_new = !has_link(root, "contacts");
    Hdf5Handle group = require_group(root, "contacts");
    if (!is_new) return group;
    const auto write_names = [&](const char* name, const char* sentence, const auto& parts) {
        std::vector<std::string> names;
        for (const auto& part : parts) names.push_back(part.name);
        write_dataset(group, {name, sentence, "none", ""}, std::span<const std::string>(names));
    };
    if (!model.contact.obstacles.empty())
        write_names("obstacle", "name of each obstacle", model.contact.obstacles);
    if (!model.contact.bodies.empty()) write_names("body", "name of each body", model.bodies);
    return group;
}

hsize_t count_touches(const AppendDataset<std::int64_t>& offsets) {
    return static_cast<hsize_t>(offsets.last_row().at(0));
}

}  // namespace

ContactTable::ContactTable(const Hdf5Handle& root, const Model& model, hsize_t frames)
    : group_(require_contacts(root, model)),
      offsets_(group_,
               {"offsets", "the rows from offsets[f] to offsets[f + 1] are those of frame f", "none", "1"},
               scalar_row,
               frames + 1),
      touches_(static_cast<std::int64_t>(count_touches(offsets_))),
      rods_(group_,
            {"rods",
             "number of the rod in /rods, and of the other one; with N rods N + i is the body i, -1 - j the "
             "obstacle j",
             "none",
             "1"},
            pair_row,
            static_cast<hsize_t>(touches_)),
      slides_(
          group_,
          {"slides", "1 where it slides, or where there is no friction; 0 where friction holds", "none", "1"},
          scalar_row,
          static_cast<hsize_t>(touches_)),
      places_(group_,
              {"places", "where on both rods, as fractions of their lengths; 0 of an obstacle", "none", "1"},
              pair_row,
              static_cast<hsize_t>(touches_)),
      points_(group_,
              {"point", "halfway between both surfaces", "spatial", "length"},
              vector_row,
              static_cast<hsize_t>(touches_)),
      normal_forces_(group_,
                     {"normal_force", "force on the first rod across the surface", "spatial", "force"},
                     vector_row,
                     static_cast<hsize_t>(touches_)),
      friction_forces_(group_,
                       {"friction_force", "force on the first rod along the surface", "spatial", "force"},
                       vector_row,
                       static_cast<hsize_t>(touches_)),
      gaps_(group_,
            {"gap", "least distance between the surfaces there", "none", "length"},
            scalar_row,
            static_cast<hsize_t>(touches_)) {}

void ContactTable::append(const Snapshot& snapshot) {
    for (const ContactTouch& touch : snapshot.touches) {
        rods_.append(std::array<std::int64_t, 2>{touch.rods[0], touch.rods[1]});
        slides_.append(touch.slides ? 1 : 0);
        places_.append(touch.places);
        points_.append(numbers(touch.point));
        normal_forces_.append(numbers(touch.normal_force));
        friction_forces_.append(numbers(touch.friction_force));
        gaps_.append(touch.gap);
    }
    touches_ += static_cast<std::int64_t>(snapshot.touches.size());
    offsets_.append(touches_);
}

template <class Action>
void ContactTable::for_each_dataset(const Action& action) {
    for (AppendDataset<std::int64_t>* dataset : {&offsets_, &rods_, &slides_}) action(*dataset);
    for (AppendDataset<double>* dataset : {&places_, &points_, &normal_forces_, &friction_forces_, &gaps_})
        action(*dataset);
}

void ContactTable::flush() {
    for_each_dataset([](auto& dataset) { dataset.flush(); });
}

void ContactTable::trim() {
    for_each_dataset([](auto& dataset) { dataset.trim(); });
}

std::size_t ContactTable::buffered_bytes() const {
    constexpr std::size_t vectors_of_touch = 5;
    return vectors_of_touch * points_.buffered_bytes() + offsets_.buffered_bytes();
}

}  // namespace gxrod
