#include "analyses/shapes/mode_tracking.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/scatter.hpp"
#include "linear/eigen/pencil.hpp"

namespace gxrod {

namespace {

using Eigen::Index;

// Of |λ|: so near are copies of one mode, which mix as they like.
constexpr double copies = 1e-6;

Eigen::VectorXcd join(const System& system,
                      const std::vector<Vec6>& real,
                      const std::vector<Vec6>& imaginary) {
    Eigen::VectorXcd joined(system.equations().count());
    joined.real() = gather(real, system.equations());
    joined.imag() = gather(imaginary, system.equations());
    return joined;
}

Eigen::VectorXcd multiply_complex(const SparsePattern& pattern,
                                  const std::vector<double>& values,
                                  const Eigen::VectorXcd& x) {
    Eigen::VectorXcd product(x.size());
    Eigen::VectorXd part;
    multiply(pattern, values, x.real(), part);
    product.real() = part;
    multiply(pattern, values, x.imag(), part);
    product.imag() = part;
    return product;
}

Eigen::MatrixXd correlate(const ModeTraces& earlier, const ModeTraces& later) {
    const Eigen::MatrixXcd mass = earlier.left.transpose() * later.mass;
    const Eigen::MatrixXcd damping = earlier.left.transpose() * later.damping;
    const Eigen::MatrixXcd sums = earlier.lambda.replicate(1, later.lambda.size()) +
                                  later.lambda.transpose().replicate(earlier.lambda.size(), 1);
    Eigen::MatrixXcd correlation = sums.cwiseProduct(mass) + damping;
    for (const auto& [law, image] : later.relaxing) {
        const Eigen::MatrixXcd relaxing = earlier.left.transpose() * image;
        for (Index j = 0; j < relaxing.cols(); ++j) {
            for (Index i = 0; i < relaxing.rows(); ++i)
                correlation(i, j) += law.slope(earlier.lambda[i], later.lambda[j]) * relaxing(i, j);
        }
    }
    return correlation.cwiseAbs();
}

// Of those that are no copies of one.
double find_largest_other(const Eigen::VectorXd& values, const Eigen::VectorXcd& lambda, Index own) {
    double largest = 0.0;
    for (Index i = 0; i < values.size(); ++i) {
        if (std::abs(lambda[i] - lambda[own]) > copies * std::abs(lambda[own]))
            largest = std::max(largest, values[i]);
    }
    return largest;
}

}  // namespace

ModeTraces make_traces(const System& system,
                       const StateMatrices& matrices,
                       const std::vector<Eigenmode>& modes) {
    const auto count = static_cast<Index>(modes.size());
    const Index size = system.equations().count();
    ModeTraces traces{Eigen::VectorXcd(count),
                      Eigen::MatrixXcd::Zero(size, count),
                      Eigen::MatrixXcd(size, count),
                      Eigen::MatrixXcd(size, count),
                      {}};
    for (const RelaxingMatrix& one : matrices.relaxing)
        traces.relaxing.push_back({{one.time, {}}, Eigen::MatrixXcd(size, count)});
    for (Index i = 0; i < count; ++i) {
        const Eigenmode& mode = modes[static_cast<std::size_t>(i)];
        traces.lambda[i] = mode.lambda();
        if (!mode.left.empty()) traces.left.col(i) = join(system, mode.left, mode.left_imaginary);
        const Eigen::VectorXcd z = join(system, mode.shape.nodes, mode.imaginary);
        traces.mass.col(i) = multiply_complex(system.pattern(), matrices.mass, z);
        traces.damping.col(i) = multiply_complex(system.pattern(), matrices.damping, z);
        for (std::size_t k = 0; k < traces.relaxing.size(); ++k)
            traces.relaxing[k].second.col(i) =
                multiply_complex(system.pattern(), matrices.relaxing[k].values, z);
    }
    return traces;
}

std::vector<ModeMatch> match_modes(const ModeTraces& earlier, const ModeTraces& later) {
    const Eigen::MatrixXd correlation = correlate(earlier, later);
    Eigen::MatrixXd open = correlation;
    std::vector<ModeMatch> matches(static_cast<std::size_t>(earlier.lambda.size()));
    // The strongest first.
    for (Index k = 0; k < std::min(open.rows(), open.cols()); ++k) {
        Index i = 0, j = 0;
        const double own = open.maxCoeff(&i, &j);
        if (!(own > 0.0)) break;
        const double other = std::max(find_largest_other(correlation.row(i).transpose(), later.lambda, j),
                                      find_largest_other(correlation.col(j), earlier.lambda, i));
        matches[static_cast<std::size_t>(i)] = {static_cast<int>(j), other / own};
        open.row(i).setConstant(-1.0);
        open.col(j).setConstant(-1.0);
    }
    return matches;
}

}  // namespace gxrod
