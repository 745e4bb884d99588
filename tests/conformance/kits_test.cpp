// What a kit says of a plugin that is wrong.

#include "material_conformance.hpp"

#include <gtest/gtest-spi.h>

namespace matpoint::conformance {
namespace {

/// sigma = E d, a wave speed of `share` times the right one.
template <class S>
class Spring final : public Material<S> {
  public:
    using typename Material<S>::Real;
    using typename Material<S>::Batch;
    static Schema schema() { return Schema("A spring"); }
    explicit Spring(const Parameters& p) : Material<S>(p), share_(static_cast<Real>(p.number("share"))) {}

    void update_stress(const Batch& batch, Real dt) const override {
        for (Index p = batch.begin(); p < batch.end(); ++p) {
            const Tensor<S> l = batch.velocity_gradient(p), spin = Real(0.5) * (l - transpose(l));
            const Tensor<S> s = batch.stress(p);
            batch.set_stress(p, s + dt * (Real(0.5) * (l + transpose(l)) + spin * s - s * spin));
        }
    }
    Real wave_speed(const Batch& batch) const override {
        Real fastest = share_ * Real(2) / std::sqrt(batch.density(batch.begin()));
        for (Index p = batch.begin(); p < batch.end(); ++p)
            fastest = std::max(fastest, share_ * Real(2) / std::sqrt(batch.density(p)));
        return fastest;
    }

  private:
    Real share_;
};

std::vector<std::string> failures(double share) {
    Registry registry;
    registry.material<Spring>("spring");
    testing::TestPartResultArray results;
    {
        using Reporter = testing::ScopedFakeTestPartResultReporter;
        const Reporter reporter(Reporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
        check_material(registry, {{"type", "spring"}, {"density", 1}, {"share", share}});
    }
    std::vector<std::string> texts;
    for (int i = 0; i < results.size(); ++i) texts.emplace_back(results.GetTestPartResult(i).message());
    return texts;
}

/// Of those that are not about waves there may be some: the spring is a crude one.
long about_waves(const std::vector<std::string>& texts, const std::string& part) {
    return std::count_if(texts.begin(), texts.end(),
                         [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

TEST(Kits, AWaveSpeedThatIsTooLowIsToldOnce) {
    EXPECT_EQ(about_waves(failures(1), "wave speed"), 0);
    const std::vector<std::string> texts = failures(0.2);
    EXPECT_EQ(about_waves(texts, "wave speed too low: 0.4"), 1) << testing::PrintToString(texts);
    EXPECT_LE(texts.size(), 4U);
    EXPECT_EQ(about_waves(failures(-1), "wave speed of -2 m/s"), 1);
}

}  // namespace
}  // namespace matpoint::conformance
