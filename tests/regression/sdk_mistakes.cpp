// Plugins with one mistake each; sdk_mistakes.sh looks at what the compiler says of them. Nothing here
// compiles.
#include <matpoint/geometry.hpp>
#include <matpoint/load.hpp>
#include <matpoint/output.hpp>
#include <matpoint/plugin.hpp>
#include <matpoint/pointwise_material.hpp>
#include <matpoint/tensor_product_shape.hpp>

using namespace matpoint;

template <class Space>
class WithoutWaves final : public PointwiseMaterial<Space, WithoutWaves<Space>> {
  public:
    using PointwiseMaterial<Space, WithoutWaves<Space>>::PointwiseMaterial;
    static Schema schema() { return Schema("No squared_wave_speed"); }
    template <class Point>
    auto update(const Point& p, typename Space::Real) const {
        return p.volume();
    }
};

template <class Space>
class ThatChangesItself final : public PointwiseMaterial<Space, ThatChangesItself<Space>> {
  public:
    using PointwiseMaterial<Space, ThatChangesItself<Space>>::PointwiseMaterial;
    static Schema schema() { return Schema("update is not const"); }
    template <class Point>
    auto squared_wave_speed(const Point& p) const {
        return p.volume();
    }
    template <class Point>
    auto update(const Point& p, typename Space::Real) {
        return p.volume();
    }
};

template <class Space>
class Undescribed final : public Load<Space> {
  public:
    explicit Undescribed(const Parameters&) {}
    void apply(LoadContext<Space>&) const override {}
};

template <class Space>
class OfAnotherKind final : public Load<Space> {
  public:
    explicit OfAnotherKind(const Parameters&) {}
    static Schema schema() { return Schema("Registered as a material"); }
    void apply(LoadContext<Space>&) const override {}
};

class Unmade final : public Geometry {
  public:
    static Schema schema() { return Schema("No constructor from Parameters"); }
    Bounds bounds() const override { return {}; }
    bool contains(const Eigen::Vector3d&) const override { return true; }
};

class Unfinished final : public Output {
  public:
    explicit Unfinished(const Parameters&) {}
    static Schema schema() { return Schema("No write"); }
    void open(const RunView&, const std::filesystem::path&, double) override {}
};

struct WithoutWidth {
    static constexpr bool sized = false;
    template <class T>
    static T base(T xi) {
        return xi;
    }
    template <class T>
    static void evaluate(T, T, T*, T*) {}
};
template <class Space>
class Shapeless final : public TensorProductShape<Space, WithoutWidth> {
  public:
    explicit Shapeless(const Parameters&) {}
    static Schema schema() { return Schema("Its kernel has no width"); }
};

double branch(Pack<double> a) {
    if (a < Pack<double>(0)) return 0;
    return 1;
}

MATPOINT_PLUGIN("mistakes", "0.1.0") {
    registry.material<WithoutWaves>("without_waves");
    registry.material<ThatChangesItself>("that_changes_itself");
    registry.load<Undescribed>("undescribed");
    registry.material<OfAnotherKind>("of_another_kind");
    registry.geometry<Unmade>("unmade");
    registry.output<Unfinished>("unfinished");
    registry.shape_function<Shapeless>("shapeless");
}
