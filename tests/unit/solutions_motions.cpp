// Motions that are given: the stress is the material's own, the deformation that of the formula.

#include "../conformance/specimen.hpp"
#include "solutions_fixture.hpp"

namespace matpoint {

class SolutionsMotions : public SolutionsTest {
  protected:
    /// Stress of the material itself when F grows in many small steps to that of the solution at `time`.
    template <class S>
    Tensor<S> stress_of_material(const ExactSolution& solution, const Json& material, double time) {
        catalogue.find("material", material.at("type").get<std::string>());
        const Parameters::Context context{SpaceId::of<S>(), ".", &catalogue.registry(), nullptr};
        const auto made = catalogue.registry().make<Material<S>>("material", material, context);
        conformance::Specimen<S> specimen(*made);
        const int steps = 4000;
        const Eigen::Vector3d x(0.3, 0.2, 0.1);
        const auto deformation = [&](int step) {
            return solution.deformation_gradient(x, time * step / steps);
        };
        for (int k = 0; k < steps; ++k) {
            const Eigen::Matrix3d before = deformation(k), after = deformation(k + 1);
            const Eigen::Matrix3d increment = after * before.inverse();
            specimen.step(tensor<S>(increment - Eigen::Matrix3d::Identity()));
        }
        return specimen.stress();
    }
    template <class S>
    static Tensor<S> tensor(const Eigen::Matrix3d& full) {
        Tensor<S> t;
        t.plane = full.topLeftCorner<S::dimension, S::dimension>();
        if constexpr (S::has_normal) t.normal = full(2, 2);
        return t;
    }
};

TEST_F(SolutionsMotions, StressOfUniformStretchIsTheMaterials) {
    for (const Json& material :
         {elastic("neo_hookean"), elastic("linear_elastic", "small"), elastic("linear_elastic", "rate")})
        for (const Mode mode : {Mode::bar, Mode::plane_strain, Mode::axisymmetric, Mode::solid}) {
            const auto body =
                make({{"type", "uniform_stretch"}, {"course", "smooth"}, {"stretch", 1.6}, {"duration", 2}},
                     material, mode);
            with_space({mode, false}, [&]<class S>() {
                if constexpr (std::is_same_v<typename S::Real, double>)
                    for (const double time : {0.7, 2.0, 5.0}) {
                        const auto difference = stress_of_material<S>(*body, material, time) -
                                                tensor<S>(body->stress({0.3, 0.2, 0.1}, time));
                        EXPECT_LT(std::sqrt(contract(difference, difference)), 1e-5)
                            << material << " mode " << static_cast<int>(mode) << " at " << time;
                    }
            });
        }
}

TEST_F(SolutionsMotions, UniformStretchStartsAndEndsAtRest) {
    const auto body =
        make({{"type", "uniform_stretch"}, {"course", "smooth"}, {"stretch", 0.5}, {"duration", 2}},
             elastic("neo_hookean"));
    const Eigen::Vector3d x(3, 0, 0);
    for (const double t : {0.0, 2.0, 3.0}) {
        EXPECT_EQ(body->velocity(x, t)[0], 0);
        EXPECT_EQ(body->body_force(x, t)[0], 0);
    }
    EXPECT_EQ(body->displacement(x, 0)[0], 0);
    EXPECT_NEAR(body->displacement(x, 2)[0], -1.5, 1e-14);
    EXPECT_NEAR(body->displacement(x, 1)[0], -0.75, 1e-14);
}

TEST_F(SolutionsMotions, FreeFlightGoesStraight) {
    Json dust = elastic();
    dust["youngs_modulus"] = 0;
    const auto bar = make({{"type", "free_flight"}, {"velocity", {"(1+x)^2"}}}, dust);
    EXPECT_NEAR(bar->displacement({0.5, 0, 0}, 2)[0], 4.5, 1e-14);
    EXPECT_NEAR(bar->velocity({0.5, 0, 0}, 2)[0], 2.25, 1e-14);
    EXPECT_NEAR(bar->deformation_gradient({0.5, 0, 0}, 2)(0, 0), 7, 1e-9);

    const auto ring =
        make({{"type", "free_flight"}, {"velocity", {"2*x + y", nullptr}}}, dust, Mode::axisymmetric);
    const Eigen::Matrix3d f = ring->deformation_gradient({0.5, 1, 0}, 0.1);
    const Eigen::Matrix3d expected = (Eigen::Matrix3d() << 1.2, 0.1, 0, 0, 1, 0, 0, 0, 1.4).finished();
    EXPECT_LT((f - expected).norm(), 1e-9) << f;
    EXPECT_EQ(ring->stress({0.5, 1, 0}, 0.1), Eigen::Matrix3d::Zero());
}

}  // namespace matpoint
