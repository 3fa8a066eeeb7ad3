#include "deck/drives/place_field.hpp"

namespace gxrod {

PlaceField make_field(const CheckedMotionVector& components, const Acting& acting) {
    PlaceField field;
    std::array<PointFunction, 3> by_place;
    for (std::size_t i = 0; i < 3; ++i) {
        const MotionExpression& component = components[i].expression;
        if (component.by_motion) {
            by_place[i] = acting.apply(component.by_motion, component.has_time);
        } else {
            field.uniform[i] = acting.apply(component.by_time);
        }
    }
    if (!by_place[0] && !by_place[1] && !by_place[2]) return field;
    field.by_place = [by_place](double time, const Vec3& position) {
        Vec3 value = Vec3::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            if (by_place[i])
                value[static_cast<Eigen::Index>(i)] = by_place[i](time, 0.0, {.position = position});
        }
        return value;
    };
    return field;
}

}  // namespace gxrod
