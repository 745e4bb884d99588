#include "../free_vibration.hpp"

#include <matpoint/plugin.hpp>

namespace matpoint {

/// A disk with a free rim in its lowest radial mode, in plane strain; see README.md.
class FreeDiskVibration final : public FreeVibration {
  public:
    explicit FreeDiskVibration(const Parameters& parameters)
        : FreeVibration(parameters), mode_(dimension(), radius(), elastic()) {
        set_frequency(mode_.root(), elastic().lambda + 2 * elastic().mu);
    }

    static Schema schema() {
        Schema schema("Small radial vibration of a disk whose rim is free, at rest or in flight",
                      "[Love 1927, chapter XII]");
        schema.dimensions({2}).refuse(
            "", "is no solution in an axisymmetric space",
            [](const Json&, const Json& scene) { return scene.at("space").at("mode") == "axisymmetric"; });
        return add_free_vibration(schema);
    }

  private:
    Vector shape(const Vector& x) const override { return mode_.shape(x); }
    Matrix shape_gradient(const Vector& x) const override { return mode_.gradient(x); }

    RadialMode mode_;
};

}  // namespace matpoint

MATPOINT_PLUGIN("free_disk_vibration", "1.0.0") {
    registry.exact_solution<matpoint::FreeDiskVibration>("free_disk_vibration");
}
