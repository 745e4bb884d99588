#include "contact_conformance.hpp"

#include "every_plugin.hpp"
#include "plugins.hpp"
#include "simulated.hpp"

#include <gtest/gtest-spi.h>

namespace matpoint::conformance {
namespace {

class EveryLaw : public testing::TestWithParam<Json> {};

TEST_P(EveryLaw, Conforms) {
    PluginCatalogue catalogue;
    catalogue.find("contact", GetParam().at("type"));
    check_contact(catalogue.registry(), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Coulomb, EveryLaw,
                         testing::Values(Json{{"type", "coulomb"}, {"friction", 0}},
                                         Json{{"type", "coulomb"}, {"friction", 0.3}},
                                         Json{{"type", "coulomb"}, {"friction", 1e9}}));

TEST(Coulomb, SlidesAtTheConeAndSticksWithinIt) {
    const auto law = make<Contact<Solid>>("contact", {{"type", "coulomb"}, {"friction", 0.25}});
    std::vector<ContactPoint<Solid>> points = contact_points<Solid>();
    std::vector<Solid::Vector> impulses(points.size());
    law->law()->impulses(points, impulses);
    int slides = 0, sticks = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto& at = points[k];
        const double most = 0.25 * at.pressing;
        EXPECT_NEAR(at.normal.dot(impulses[k]), at.pressing, 1e-15);
        const Solid::Vector across = impulses[k] - at.normal * at.normal.dot(impulses[k]);
        EXPECT_NEAR(across.norm(), std::min(most, at.sticking.norm()), 1e-15);
        if (at.pressing > 0) ++(at.sticking.norm() > most ? slides : sticks);
    }
    EXPECT_GT(slides, 10);
    EXPECT_GT(sticks, 10);
}

/// A law with a mistake, which the kit must find.
class Mutant final : public ContactLaw<PlaneStrain> {
  public:
    using Change = std::function<Vector(const ContactPoint<PlaneStrain>&, Vector)>;
    explicit Mutant(Change change) : change_(std::move(change)) {}
    void impulses(std::span<const ContactPoint<PlaneStrain>> points, std::span<Vector> out) const override {
        for (std::size_t k = 0; k < points.size(); ++k) {
            const auto& at = points[k];
            const double most = 0.3 * at.pressing, size = at.sticking.norm();
            Vector right = Vector::Zero();
            if (at.pressing > 0)
                right = at.pressing * at.normal + (size > most ? most / size : 1.0) * at.sticking;
            out[k] = change_(at, right);
        }
    }

  private:
    Change change_;
};

TEST(ContactKit, FindsMistakes) {
    using Point = ContactPoint<PlaneStrain>;
    using Vector = PlaneStrain::Vector;
    static const auto checks = [](const Mutant& law) {
        return ContactChecks<PlaneStrain>(law, contact_points<PlaneStrain>());
    };
    const auto fails = [](const Mutant::Change& change, const auto& check) {
        bool failed = false;
        testing::TestPartResultArray results;
        {
            const testing::ScopedFakeTestPartResultReporter reporter(
                testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
            check(checks(Mutant(change)));
        }
        for (int i = 0; i < results.size(); ++i) failed = failed || results.GetTestPartResult(i).failed();
        return failed;
    };
    const auto all = [](const auto& own) { own.all(); };
    EXPECT_FALSE(fails([](const Point&, Vector right) { return right; }, all));
    // Sticks when bodies separate; lets them overlap; bounces; pushes in x only; turns what slides round.
    EXPECT_TRUE(fails([](const Point& at, Vector) -> Vector { return -at.mass * at.velocity; },
                      [](const auto& own) { own.does_not_pull(); }));
    EXPECT_TRUE(fails([](const Point&, Vector right) -> Vector { return 0.9 * right; },
                      [](const auto& own) { own.keeps_apart(); }));
    EXPECT_TRUE(fails([](const Point&, Vector right) -> Vector { return 2.1 * right; },
                      [](const auto& own) { own.takes_energy(); }));
    EXPECT_TRUE(fails(
        [](const Point& at, Vector right) -> Vector {
            const Vector across = right - at.normal * at.normal.dot(right);
            return right - Vector(0, across[1]);
        },
        [](const auto& own) { own.turns_with_the_frame(); }));
    EXPECT_TRUE(
        fails([](const Point& at, Vector right) -> Vector { return right + Vector(0.1 * at.pressing, 0); },
              [](const auto& own) { own.turns_with_the_frame(); }));
    EXPECT_TRUE(fails(
        [](const Point& at, Vector right) -> Vector {
            return at.pressing > 0 ? Vector(at.pressing * at.normal + 1.5 * at.sticking) : right;
        },
        [](const auto& own) { own.acts_against_sliding(); }));
}

/// Two squares that meet off-centre, in a box.
Json two_squares() {
    return Json::parse(R"json({
        "matpoint": 1, "space": {"dimension": 2},
        "grid": {"type": "uniform", "min": [0, 0], "max": [2, 2], "cell_size": 0.1},
        "time": {"end": 100, "cfl": 0.3},
        "materials": {"rubber": {"type": "neo_hookean", "density": 1000, "youngs_modulus": 1e5, "poissons_ratio": 0.3}},
        "bodies": {"left": {"material": "rubber", "velocity": [2, 0.4], "geometry": {"type": "box", "min": [0.33, 0.5], "max": [0.81, 1.02]}},
                   "right": {"material": "rubber", "velocity": [-1, 0], "geometry": {"type": "box", "min": [0.9, 0.75], "max": [1.4, 1.2]}}},
        "contacts": [{"type": "coulomb", "between": ["left", "right"], "friction": 0.3}],
        "boundary_conditions": [{"type": "slip", "on": ["y_min", "x_min", "x_max", "y_max"]}]
    })json");
}

/// Every field that outputs can see, of all bodies.
std::vector<std::vector<double>> everything(Simulated& run) {
    std::vector<std::vector<double>> all;
    for (const std::string& body : run->bodies())
        for (const char* field : {"position", "velocity", "stress"})
            for (int c = 0; c < run->components(body, field); ++c) all.push_back(run->column(body, field, c));
    return all;
}

TEST(Contact, KeepsMomentumAndTheBalanceOfEnergy) {
    for (const char* integrator : {"usl", "musl", "usf", "uvf", "usavg", "central_difference"})
        for (const char* normal : {"average", "regression"}) {
            SCOPED_TRACE(std::string(integrator) + ", " + normal);
            Json scene = two_squares();
            scene["integrator"]["type"] = integrator;
            scene["contacts"][0]["normal"] = normal;
            Simulated run(scene);
            const double before = run->energies().total();
            run.advance(150);
            EXPECT_EQ(run->contact("left-right").touched, 1);
            EXPECT_LT(run->conservation().momentum_drift, 1e-13);
            EXPECT_LT(run->energies().total(), before * (1 + 1e-3));  // coarse waves lose some
            EXPECT_GT(run->contact("left-right").friction_work, 0);
        }
}

TEST(Contact, StickingEverywhereIsNoContact) {
    Json scene = two_squares();
    scene["contacts"][0]["friction"] = "stick";
    scene["grid"]["light_nodes"] = 0;        // which belong to layers
    scene["transfer"] = {{"type", "apic"}};  // what the grid doesn't see of the velocity, others keep
    Simulated sticks(scene);
    scene["contacts"] = Json::array();
    Simulated shares(scene);
    const auto a = everything(sticks.advance(20)), b = everything(shares.advance(20));
    for (std::size_t k = 0; k < a.size(); ++k) {
        double size = 0;
        for (const double x : b[k]) size = std::max(size, std::abs(x));
        // Layers with less than 1e-5 of a node's mass are left alone there; were they not, it would be 1e-9.
        for (std::size_t p = 0; p < a[k].size(); ++p) EXPECT_NEAR(a[k][p], b[k][p], 1e-3 * size);
    }
}

TEST(Contact, BodiesThatShareNoNodeAreAsWithoutIt) {
    Json scene = two_squares();
    scene["bodies"]["right"]["geometry"] = {{"type", "box"}, {"min", {1.5, 1.5}}, {"max", {1.9, 1.9}}};
    Simulated with(scene);
    scene["contacts"] = Json::array();
    Simulated without(scene);
    EXPECT_EQ(everything(with.advance(20)), everything(without.advance(20)));
    EXPECT_EQ(with->contact("left-right").touched, 0);
}

TEST(Contact, IsTheSameWhenRestarted) {
    Simulated whole(two_squares()), first(two_squares()), second(two_squares());
    first.advance(40);
    second->restore(first->state());
    EXPECT_EQ(everything(second.advance(40)), everything(whole.advance(80)));
    const ContactReport a = second->contact("left-right"), b = whole->contact("left-right");
    EXPECT_EQ(a.impulse, b.impulse);
    EXPECT_EQ(a.friction_work, b.friction_work);
    EXPECT_EQ(a.first_gap, b.first_gap);
    EXPECT_EQ(a.penetration, b.penetration);
}

/// A column of three squares, the lowest on the floor: the middle one meets two others at once.
TEST(Contact, ThreeBodiesCarryEachOthersWeight) {
    Json scene = two_squares();
    scene["bodies"] = Json::object();
    double low = 0;
    for (const char* name : {"low", "thin", "high"}) {  // the thin one is a cell thick
        const double high = low + (std::string(name) == "thin" ? 0.1 : 0.4);
        scene["bodies"][name] = {{"material", "rubber"},
                                 {"geometry", {{"type", "box"}, {"min", {0.0, low}}, {"max", {2.0, high}}}}};
        low = high;
    }
    scene["contacts"] = Json::parse(R"([{"type": "coulomb", "between": ["low", "thin"], "name": "below"},
                                        {"type": "coulomb", "between": ["thin", "high"], "name": "above"},
                                        {"type": "coulomb", "between": ["low", "high"], "name": "across"}])");
    scene["loads"] = Json::parse(R"([{"type": "gravity", "acceleration": [0, -1]}])");
    scene["damping"] = {{"type", "kinetic"}};
    scene["time"]["until_at_rest"] = 1e-3;
    Simulated run(scene);
    while (!run->finished()) run.advance(1);
    ASSERT_EQ(run->at_rest(), true);
    const double weight = 2 * 1000;  // N a metre of height
    const double below = run->contact("below").force[1], above = run->contact("above").force[1],
                 across = run->contact("across").force[1];
    EXPECT_NEAR(-above - across, 0.4 * weight, 0.005 * weight) << "what the highest weighs";
    EXPECT_NEAR(-below - across, 0.5 * weight, 0.005 * weight) << "what both weigh";
}

}  // namespace
}  // namespace matpoint::conformance
