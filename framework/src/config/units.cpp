#include "config/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace matpoint {
namespace {

using Unit = std::unique_ptr<ut_unit, decltype(&ut_free)>;
using Converter = std::unique_ptr<cv_converter, decltype(&cv_free)>;

Unit parse(ut_system* system, const std::string& text) {
    return Unit(ut_parse(system, text.c_str(), UT_UTF8), ut_free);
}

std::string_view trim(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// udunits would read the 5 of "10 5" as a unit of five; here a unit has a name.
bool starts_as_unit(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    return std::isalpha(first) || first == '%' || first >= 0x80 || text.starts_with("1/");
}

}  // namespace

double Units::to_si(std::string_view given, const std::string& unit) {
    const std::string_view text = trim(given);
    double number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc())
        throw std::invalid_argument(fmt::format("\"{}\" doesn't start with a number", given));
    const std::string name(trim(text.substr(static_cast<std::size_t>(end - text.data()))));

    double value = number;
    if (!name.empty()) {
        if (!system_) {
            ut_set_error_message_handler(ut_ignore);
            system_.reset(ut_read_xml(nullptr), ut_free_system);
            if (!system_) throw std::runtime_error("the database of units of udunits2 can't be read");
        }
        const Unit from = starts_as_unit(name) ? parse(system_.get(), name) : Unit(nullptr, ut_free);
        if (!from) throw std::invalid_argument(fmt::format("unknown unit \"{}\"", name));
        const Unit to = parse(system_.get(), unit.empty() ? "1" : unit);
        if (!ut_are_convertible(from.get(), to.get())) {
            throw std::invalid_argument(fmt::format("\"{}\" is not convertible to {}", given,
                                                    unit.empty() ? "a number without unit" : unit));
        }
        value = cv_convert_double(Converter(ut_get_converter(from.get(), to.get()), cv_free).get(), number);
    }
    if (!std::isfinite(value))
        throw std::invalid_argument(fmt::format("\"{}\" is not a finite number", given));
    return value;
}

}  // namespace matpoint
