#pragma once

#include "model/settings/settings.hpp"
#include "results/file/append_dataset.hpp"
#include "results/file/hdf5_objects.hpp"
#include "results/histories/point_kind.hpp"

namespace gxrod {

// The storage of a quantity of a history: name, description, frame and dimension, and the form of its rows.
struct QuantityForm {
    DatasetLabel label;
    RowShape shape;
};

QuantityForm quantity_form(Quantity quantity, PointKind kind);
// Returns the form in a history that is relative to a point; the frame names that point.
QuantityForm relative_quantity_form(Quantity quantity, PointKind kind, const std::string& relative_to);

}  // namespace gxrod
