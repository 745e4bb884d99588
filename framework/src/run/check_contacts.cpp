#include "contact/placed_contact.hpp"
#include "run/scene_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace matpoint {

namespace {

/// Cells below which the far face of a body is felt at its near one (theory.md, "Contact").
constexpr double thin = 2;

/// Least extent of a body along an axis, in cells.
template <class S>
double thickness(const Patch<S>& patch, const Particles<S>& particles) {
    double least = std::numeric_limits<double>::infinity();
    for (int a = 0; a < S::dimension; ++a) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (Index p = 0; p < particles.size(); ++p) {
            const double x = particles.value(Field::position, a, p),
                         half = static_cast<double>(particles.column(Field::initial_half_size, a)[p]);
            low = std::min(low, x - half);
            high = std::max(high, x + half);
        }
        least = std::min(least, (high - low) * patch.inverse_cell_size()[a]);
    }
    return least;
}

}  // namespace

template <class S>
Findings check_contacts(const SceneParts<S>& parts, std::span<const PlacedContact<S>> contacts) {
    Findings findings;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const Json friction = parts.scene.at("contacts")[k].value("friction", Json(0));
        if (contacts[k].rule.normal == PairRule::Normal::average &&
            contacts[k].rule.gap == PairRule::Gap::particles && friction.is_number() && friction != 0)
            findings.push_back({false, fmt::format("/contacts/{}/normal", k),
                                "with gaps by particles, edges of bodies plough by average normals: friction "
                                "may be twice what is asked for; take \"regression\" or a fixed normal"});
        if (contacts[k].rule.gap != PairRule::Gap::moment) continue;
        for (const std::size_t body : contacts[k].bodies) {
            const double cells = thickness(parts.patch, parts.bodies[body]);
            if (cells > thin * (1 - 1e-6)) continue;
            findings.push_back(
                {false, fmt::format("/contacts/{}/gap", k),
                 fmt::format("body \"{}\" is {:.2g} cells thick: by moments, what is thinner than "
                             "{} meets others up to 0.7 cells early; take \"particles\"",
                             parts.bodies[body].body(), cells, thin)});
            break;
        }
    }
    return findings;
}

#define MATPOINT_INSTANTIATE(S) \
    template Findings check_contacts(const SceneParts<S>&, std::span<const PlacedContact<S>>);
MATPOINT_FOR_EACH_SPACE(MATPOINT_INSTANTIATE)

}  // namespace matpoint
