#include "report/blocks/frame_vectors.hpp"

#include <algorithm>

namespace gxrod {

std::span<const double> FrameVectors::read(std::size_t frame) {
    constexpr std::size_t rows_at_once = 8192;
    if (frame >= end_) {
        const std::size_t count = std::max<std::size_t>(1, rows_at_once / std::max<std::size_t>(rows_, 1));
        first_ = frame;
        end_ = std::min(frame + count, frames_);
        values_ = file_.rows(dataset_, first_ * rows_, (end_ - first_) * rows_, width_);
    }
    return std::span<const double>(values_).subspan((frame - first_) * width_ * rows_, width_ * rows_);
}

}  // namespace gxrod
