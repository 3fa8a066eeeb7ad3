#pragma once

#include <fmt/format.h>

#include <functional>
#include <set>
#include <string>

#include "results/hdf5_objects.hpp"

namespace gxrod {

// Goes through a file: calls visit(object, path, is_new) for all objects but those of /restart, by every
// name; `is_new` by the first.
class ObjectWalk {
  public:
    using Visit = std::function<void(hid_t object, const std::string& path, bool is_new)>;
    explicit ObjectWalk(Visit visit) : visit_(std::move(visit)) {}

    void walk(hid_t object, const std::string& path) {
        const bool is_new = seen_.insert(address_of(object)).second;
        visit_(object, path, is_new);
        if (!is_new || H5Iget_type(object) != H5I_GROUP) return;
        for (const std::string& name : list_members(object)) {
            if (path == "/" && name == "restart") continue;
            const Hdf5Handle child(H5Oopen(object, name.c_str(), H5P_DEFAULT), H5Oclose, "opening an object");
            walk(child.id(), fmt::format("{}/{}", path == "/" ? "" : path, name));
        }
    }

  private:
    Visit visit_;
    std::set<haddr_t> seen_;
};

}  // namespace gxrod
