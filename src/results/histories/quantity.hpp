#pragma once

#include "model/settings/settings.hpp"
#include "results/file/append_dataset.hpp"
#include "results/file/hdf5_objects.hpp"
#include "results/histories/point_kind.hpp"

namespace gxrod {

// How a quantity of a history is stored: name, description, frame and dimension, and the form of its rows.
struct QuantityForm {
    DatasetLabel label;
    RowShape shape;
};

QuantityForm quantity_form(Quantity quantity, PointKind kind);
// The same of a history that is relative to a point, which the frame names.
QuantityForm relative_quantity_form(Quantity quantity, PointKind kind, const std::string& relative_to);

}  // namespace gxrod
