#include "verify/compare_states.hpp"

#include <fmt/format.h>

#include <bit>

namespace matpoint {
namespace {

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// 17 digits tell any two doubles apart.
std::string differ(const std::string& what, double expected, double found) {
    return fmt::format("{} is {:.17g}, expected {:.17g}", what, found, expected);
}

using Column = CheckpointData::Column;
using Body = CheckpointData::Body;

std::string compare(const std::string& body, const Column& expected, const Column& found) {
    if (expected.field != found.field || expected.component != found.component ||
        expected.values.index() != found.values.index()) {
        return fmt::format("body {} has the column {}/{} in place of {}/{}", body, found.field,
                           found.component, expected.field, expected.component);
    }
    return std::visit(
        [&](const auto& values) -> std::string {
            const auto& others = std::get<std::decay_t<decltype(values)>>(found.values);
            if (values.size() != others.size())
                return fmt::format("body {}, {}: other length", body, expected.field);
            for (std::size_t p = 0; p < values.size(); ++p) {
                if (same_bits(values[p], others[p])) continue;
                return differ(fmt::format("{} (component {}) of particle {} of body {}", expected.field,
                                          expected.component, p, body),
                              static_cast<double>(values[p]), static_cast<double>(others[p]));
            }
            return {};
        },
        expected.values);
}

std::string compare(const Body& expected, const Body& found) {
    if (expected.name != found.name) return fmt::format("body {} in place of {}", found.name, expected.name);
    const std::string& name = expected.name;
    if (expected.size != found.size) {
        return fmt::format("body {} has {} particles, expected {}", name, found.size, expected.size);
    }
    if (expected.columns.size() != found.columns.size()) return fmt::format("body {} has other fields", name);
    for (std::size_t c = 0; c < expected.columns.size(); ++c) {
        std::string difference = compare(name, expected.columns[c], found.columns[c]);
        if (!difference.empty()) return difference;
    }
    if (expected.ids != found.ids) return fmt::format("body {}: the particles' ids differ", name);
    if (expected.block_numbers != found.block_numbers || expected.block_begins != found.block_begins) {
        return fmt::format("body {}: the particles' order in blocks differs", name);
    }
    return {};
}

}  // namespace

std::string first_difference(const CheckpointData& expected, const CheckpointData& found) {
    if (expected.step != found.step) return fmt::format("step is {}, expected {}", found.step, expected.step);
    if (!same_bits(expected.time, found.time)) return differ("time", expected.time, found.time);
    if (expected.bodies.size() != found.bodies.size()) return "the number of bodies differs";
    for (std::size_t b = 0; b < expected.bodies.size(); ++b) {
        std::string difference = compare(expected.bodies[b], found.bodies[b]);
        if (!difference.empty()) return difference;
    }
    for (const auto& [name, value] : expected.numbers) {
        const auto other = found.numbers.find(name);
        if (other == found.numbers.end()) return fmt::format("the run's number \"{}\" is missing", name);
        if (!same_bits(value, other->second))
            return differ(fmt::format("the run's \"{}\"", name), value, other->second);
    }
    return {};
}

}  // namespace matpoint
