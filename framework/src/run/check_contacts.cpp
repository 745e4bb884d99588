#include "contact/placed_contact.hpp"
#include "run/scene_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

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

/// Whether conditions prescribe how each particle of a body moves, in all components.
template <class S>
bool is_prescribed(const SceneParts<S>& parts, std::size_t body) {
    const Particles<S>& particles = parts.bodies[body];
    std::vector<unsigned char> held(static_cast<std::size_t>(particles.size()), 0);
    for (const PlacedCondition<S>& placed : parts.conditions) {
        if (!placed.part || placed.part->body != body) continue;
        const auto prescribes =
            guarded(*placed.condition, "prescribes", [&] { return placed.condition->prescribes(-1); });
        const auto* const in_part = particles.column(placed.part->slot, 0);
        for (Index p = 0; p < particles.size(); ++p)
            for (int c = 0; c < S::dimension && in_part[p] > 0; ++c)
                if (prescribes[static_cast<std::size_t>(c)])
                    held[static_cast<std::size_t>(p)] |= static_cast<unsigned char>(1 << c);
    }
    return std::ranges::all_of(held, [](unsigned char own) { return own == (1 << S::dimension) - 1; });
}

/// Those that are named, or all.
template <class S>
std::vector<std::size_t> bodies_of_tool(const SceneParts<S>& parts, const Json& own) {
    std::vector<std::size_t> bodies;
    for (std::size_t b = 0; b < parts.bodies.size(); ++b)
        if (!own.contains("bodies") ||
            std::ranges::find(own.at("bodies"), Json(parts.bodies[b].body())) != own.at("bodies").end())
            bodies.push_back(b);
    return bodies;
}

/// Bodies that nothing can stop where they meet a tool, or each other.
template <class S>
void find_unstoppable(const SceneParts<S>& parts, std::size_t contact, bool is_tool,
                      const std::vector<std::size_t>& bodies, Findings& findings) {
    std::vector<std::string> names;
    for (const std::size_t body : bodies)
        if (is_prescribed(parts, body)) names.push_back(parts.bodies[body].body());
    if (names.size() < (is_tool ? 1U : 2U)) return;
    findings.push_back(
        {false, fmt::format("/contacts/{}", contact),
         fmt::format("boundary conditions prescribe how all of {} moves: {} can't stop it, and "
                     "goes through it where they meet",
                     fmt::join(names, " and "), is_tool ? "the tool" : "contact")});
}

}  // namespace

template <class S>
Findings check_contacts(const SceneParts<S>& parts, std::span<const PlacedContact<S>> contacts) {
    Findings findings;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const bool is_tool = contacts[k].contact->tool() != nullptr;
        find_unstoppable(parts, k, is_tool,
                         is_tool ? bodies_of_tool(parts, parts.scene.at("contacts")[k]) : contacts[k].bodies,
                         findings);
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
