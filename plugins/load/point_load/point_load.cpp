#include <matpoint/history.hpp>
#include <matpoint/load.hpp>
#include <matpoint/plugin.hpp>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace matpoint {

/// A force at one point of a body, carried by the particles around it.
template <class S>
class PointLoad final : public Load<S> {
  public:
    using typename Load<S>::Real;
    using typename Load<S>::Vector;
    using Position = typename S::Position;

    explicit PointLoad(const Parameters& parameters)
        : body_(parameters.text("body")), history_(parameters.json().at("history")) {
        const auto at = parameters.vector("at"), force = parameters.vector("force");
        field_ = "point_load";
        for (int a = 0; a < S::dimension; ++a) {
            at_[a] = at[static_cast<std::size_t>(a)];
            force_[a] = force[static_cast<std::size_t>(a)];
            field_ += "_" + parameters.json().at("at")[static_cast<std::size_t>(a)].dump();
        }
    }

    static Schema schema() {
        Schema schema("Force at a point of a body, which moves with it");
        schema.add("body", ParameterType::reference, {.doc = "The body that is loaded", .section = "bodies"})
            .vector("at",
                    {.unit = "m", .doc = "Where the force acts at the start, in the body or on its surface"})
            .vector("force", {.unit = "N",
                              .doc = "The whole force: in 1D on a bar of 1 m^2, in plane strain on 1 m of "
                                     "depth, axisymmetric on the whole ring"})
            .refuse("/force", "is zero: there is no force", [](const Json& own, const Json&) {
                return std::ranges::all_of(own.at("force"), [](const Json& f) { return f == 0; });
            });
        History::declare(schema);
        return schema;
    }

    void declare(Particles<S>& particles) override {
        if (particles.body() != body_) return;
        particles.require(Field::initial_half_size);
        weight_ = particles.require(field_, 1);
    }

    void start(const Patch<S>&, std::span<Particles<S>> bodies) override {
        if constexpr (S::axisymmetric)
            if (at_[0] == 0 && force_[0] != 0)
                throw std::invalid_argument(
                    "nothing is drawn along the radius at the axis: the first component of `force` must be "
                    "0");
        Particles<S>& particles = body(bodies);
        const std::vector<Index> near = neighbours(particles);
        const Eigen::VectorXd weights = weights_of(particles, near);
        for (std::size_t k = 0; k < near.size(); ++k)
            particles.column(weight_, 0)[near[k]] = static_cast<Real>(weights[static_cast<Index>(k)]);
    }

    void apply(LoadContext<S>& context) const override {
        const double factor = history_(context.time);
        if (factor == 0) return;
        const Particles<S>& particles = body(context.bodies);
        const Real* weight = particles.column(weight_, 0);
        std::vector<PointSource<S>> sources;
        for (Index p = 0; p < particles.size(); ++p)
            if (weight[p] != 0)
                sources.push_back(
                    {particles.position(p),
                     particles.vector(
                         particles.has(Field::half_size) ? Field::half_size : Field::initial_half_size, p),
                     Vector((static_cast<double>(weight[p]) * factor * force_).template cast<Real>())});
        context.spread(particles, sources, NodeField::external_force);
    }

    double settled_at() const override { return history_.settled_at(); }

  private:
    Particles<S>& body(std::span<Particles<S>> bodies) const {
        return *std::find_if(bodies.begin(), bodies.end(), [&](const auto& b) { return b.body() == body_; });
    }

    /// From the point to a particle, in its sizes.
    Position offset(const Particles<S>& particles, Index p, const Position& size) const {
        return (particles.position(p) - at_).cwiseQuotient(size);
    }

    /// The particles within two and a half of their sizes, that of the nearest one.
    std::vector<Index> neighbours(const Particles<S>& particles) {
        double nearest = std::numeric_limits<double>::infinity();
        for (Index p = 0; p < particles.size(); ++p) {
            const Position size = 2 * particles.vector(Field::initial_half_size, p).template cast<double>();
            const double distance = offset(particles, p, size).norm();
            if (distance < nearest) {
                nearest = distance;
                size_ = size;
            }
        }
        if (!(nearest < 1.01)) throw std::invalid_argument(told("is not in it, nor on its surface"));
        std::vector<Index> near;
        for (Index p = 0; p < particles.size(); ++p)
            if (offset(particles, p, size_).norm() < reach) near.push_back(p);
        return near;
    }

    /// Weights that fall off with the distance, w = phi (a + b . x) with sum w = 1 and sum w x = 0, as a
    /// moving least squares approximation at the point has them [Lancaster & Salkauskas 1981].
    Eigen::VectorXd weights_of(const Particles<S>& particles, const std::vector<Index>& near) const {
        Eigen::MatrixXd basis(S::dimension + 1, static_cast<Index>(near.size()));
        Eigen::VectorXd phi(static_cast<Index>(near.size()));
        for (Index k = 0; k < phi.size(); ++k) {
            const Position x = offset(particles, near[static_cast<std::size_t>(k)], size_);
            basis.col(k) << 1.0, x;
            const double q = 1 - x.squaredNorm() / (reach * reach);
            phi[k] = q * q;
        }
        const Eigen::MatrixXd moments = basis * phi.asDiagonal() * basis.transpose();
        const Eigen::VectorXd one = Eigen::VectorXd::Unit(S::dimension + 1, 0);
        const Eigen::VectorXd ab = moments.completeOrthogonalDecomposition().solve(one);
        const Eigen::VectorXd weights = phi.cwiseProduct(basis.transpose() * ab);
        if (!((basis * weights - one).norm() < 1e-9))
            throw std::invalid_argument(
                told("is beside the line or plane of the few particles around it, so that "
                     "their forces can't have its moment: move it there, or take more "
                     "particles per cell"));
        return weights;
    }

    std::string told(const std::string& what) const {
        std::ostringstream text;
        text << "the point [";
        for (int a = 0; a < S::dimension; ++a) text << (a > 0 ? ", " : "") << at_[a];
        text << "] of body \"" << body_ << "\" " << what;
        return text.str();
    }

    static constexpr double reach = 2.5;  ///< in sizes of a particle

    std::string body_, field_;
    History history_;
    Position at_;                                   ///< m
    Position size_ = Position::Ones();              ///< m, of the nearest particle
    Eigen::Matrix<double, S::dimension, 1> force_;  ///< N
    int weight_ = -1;                               ///< particle field
};

}  // namespace matpoint

MATPOINT_PLUGIN("point_load", "1.0.0") {
    registry.load<matpoint::PointLoad>("point_load");
}
