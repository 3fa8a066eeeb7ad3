#pragma once

#include "model/model.hpp"
#include "results/file/append_dataset.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// /contacts: the places that touch in each frame. Throws Hdf5Error.
class ContactTable {
  public:
    // Appends after the first `frames` frames.
    ContactTable(const Hdf5Handle& root, const Model& model, hsize_t frames);

    void append(const Snapshot& snapshot);
    void flush();
    void trim();
    std::size_t buffered_bytes() const;

  private:
    template <class Action>
    void for_each_dataset(const Action& action);

    Hdf5Handle group_;
    AppendDataset<std::int64_t> offsets_;  // one row more than there are frames
    std::int64_t touches_;                 // appended
    AppendDataset<std::int64_t> rods_, slides_;
    AppendDataset<double> places_, points_, normal_forces_, friction_forces_, gaps_;
};

}  // namespace gxrod
